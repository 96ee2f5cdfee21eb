#pragma once

#include <array>
#include <vector>

#include "case/models/rule.hpp"
#include "case/tables/table.hpp"

namespace thalweg {

/// The words of model.wall_friction.
enum class WallFriction { none, no_slip, smooth, rough };

inline constexpr std::array<Choice<WallFriction>, 4> choices(WallFriction) {
  return {{{WallFriction::none, "none", "water slips along walls"},
           {WallFriction::no_slip, "no-slip", "laminar flow: water stands still at the wall, and its viscosity drags"},
           {WallFriction::smooth, "smooth",
            "turbulent flow: shear stress by the law of the wall over smooth walls, viscous sublayer included"},
           {WallFriction::rough, "rough",
            "the same with the `roughness` of each wall shape (Nikuradse's sand-grain roughness)"}}};
}

namespace models {

/// Shear stress of turbulent water on smooth or rough walls (solver/models/wall_stress/).
struct WallStress {
  static bool is_on(const Case& whole);
  static std::vector<Rule> rules();
};

}  // namespace models

}  // namespace thalweg
