#pragma once

#include <array>

#include "case/tables/table.hpp"

namespace thalweg {

/// The words of model.wall_friction.
enum class WallFriction { none, smooth };

inline constexpr std::array<Choice<WallFriction>, 2> choices(WallFriction) {
  return {{{WallFriction::none, "none", "water slips along walls"},
           {WallFriction::smooth, "smooth", "shear stress of a smooth wall's turbulent boundary layer (Blasius)"}}};
}

}  // namespace thalweg
