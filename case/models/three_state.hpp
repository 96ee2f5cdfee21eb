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

/// Effect of the pressure of water on the particles of the surface of a bed (model.bed_surface).
enum class SurfaceHold { free, held };

inline constexpr std::array<Choice<SurfaceHold>, 2> choices(SurfaceHold) {
  return {
      {{SurfaceHold::free, "free", "the pressure of water pushes its particles, as a wave pushes a bed as a whole"},
       {SurfaceHold::held, "held",
        "where it is less steep than grains stand it is held against that pressure, which in a current is a part of "
        "the shear stress"}}};
}

namespace models {

/// Grains that are eroded from the bed, carried and deposited: model.sediment = "three-state".
struct ThreeState {
  static bool is_on(const Case& whole);
  static std::vector<Rule> rules();
};

}  // namespace models

}  // namespace thalweg
