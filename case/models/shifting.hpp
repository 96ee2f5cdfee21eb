#pragma once

#include <array>
#include <vector>

#include "case/models/rule.hpp"

namespace thalweg {

/// The words of numerics.shifting.
enum class Shifting { automatic, off, on };

inline constexpr std::array<Choice<Shifting>, 3> choices(Shifting) {
  return {
      {{Shifting::automatic, "auto",
        "on for driven flows ([flow]), and for water alone without gravity and walls, which nothing keeps in order; "
        "else off"},
       {Shifting::off, "off", "particles move with the fluid alone"},
       {Shifting::on, "on",
        "sheared water is kept in order: for vortices and currents, with smoothing_ratio = 2 in the plane"}}};
}

namespace models {

/// Shifting of the water's particles: numerics.shifting = "on".
struct ParticleShifting {
  static bool is_on(const Case& whole);
  static std::vector<Rule> rules();
};

}  // namespace models

}  // namespace thalweg
