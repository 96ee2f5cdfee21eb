#pragma once

#include <array>
#include <vector>

#include "case/models/rule.hpp"

namespace thalweg {

/// The words of model.seepage.
enum class SeepageModel { off, mixture };

inline constexpr std::array<Choice<SeepageModel>, 2> choices(SeepageModel) {
  return {{{SeepageModel::off, "off", "the bed is one fluid, into which no water seeps"},
           {SeepageModel::mixture, "mixture",
            "grains and pore water are two sets of particles in the same places, joined by Ergun's drag"}}};
}

namespace models {

/// Water that seeps through the bed: model.seepage = "mixture".
struct Mixture {
  static bool is_on(const Case& whole);
  static std::vector<Rule> rules();
};

}  // namespace models

}  // namespace thalweg
