#pragma once

#include <array>
#include <vector>

#include "case/models/rule.hpp"
#include "physics/transport/bed_shear.hpp"

namespace thalweg {

inline constexpr std::array<Choice<BedShear>, 3> choices(BedShear) {
  return {
      {{BedShear::log_law, "log-law", "logarithmic law, from the mean of the water in reach"},
       {BedShear::nearest, "nearest", "logarithmic law, from the water particle nearest to the grain"},
       {BedShear::paper, "paper", "rho (kappa du/2)^2 from the summed velocity difference, the paper's (20), (21)"}}};
}

namespace models {

/// Grains that are eroded from the bed, carried and deposited: model.sediment = "three-state".
struct ThreeState {
  static bool is_on(const Case& whole);
  static std::vector<Rule> rules();
};

}  // namespace models

}  // namespace thalweg
