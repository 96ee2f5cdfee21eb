#pragma once

#include <array>
#include <vector>

#include "case/models/rule.hpp"

namespace thalweg {

/// The words of model.turbulence.
enum class Turbulence { off, sub_particle_stress };

inline constexpr std::array<Choice<Turbulence>, 2> choices(Turbulence) {
  return {{{Turbulence::off, "off", "none but the eddies that the particles make themselves"},
           {Turbulence::sub_particle_stress, "sps",
            "sub-particle stress: Smagorinsky's viscosity for eddies smaller than the spacing; meant for scenes in "
            "space"}}};
}

namespace models {

/// Sub-particle stress in the water: model.turbulence = "sps".
struct SubParticleStress {
  static bool is_on(const Case& whole);
  static std::vector<Rule> rules();
};

}  // namespace models

}  // namespace thalweg
