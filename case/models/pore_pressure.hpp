#pragma once

#include <array>
#include <vector>

#include "case/models/rule.hpp"

namespace thalweg {

/// The words of model.pore_pressure.
enum class PorePressureModel { off, diffusion };

inline constexpr std::array<Choice<PorePressureModel>, 2> choices(PorePressureModel) {
  return {{{PorePressureModel::off, "off", "the bed drains at once"},
           {PorePressureModel::diffusion, "diffusion",
            "excess pore pressure rises as the bed is compressed, drains by consolidation and weakens the bed"}}};
}

namespace models {

/// Excess pore pressure in a bed of one fluid: model.pore_pressure = "diffusion".
struct PorePressure {
  static bool is_on(const Case& whole);
  static std::vector<Rule> rules();
};

}  // namespace models

}  // namespace thalweg
