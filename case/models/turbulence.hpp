#pragma once

#include <array>
#include <vector>

#include "case/models/rule.hpp"

namespace thalweg {

/// The words of model.turbulence.
enum class Turbulence { off, mixing_length, sub_particle_stress };

inline constexpr std::array<Choice<Turbulence>, 3> choices(Turbulence) {
  return {{{Turbulence::off, "off", "none but the eddies that the particles make themselves"},
           {Turbulence::mixing_length, "mixing-length",
            "eddy viscosity of currents over walls and beds, from the distance to them and the depth of the water"},
           {Turbulence::sub_particle_stress, "sps",
            "sub-particle stress: Smagorinsky's viscosity for eddies smaller than the spacing; meant for scenes in "
            "space"}}};
}

namespace models {

/// Eddy viscosity of currents: model.turbulence = "mixing-length".
struct MixingLength {
  static bool is_on(const Case& whole);
  static std::vector<Rule> rules();
};

/// Sub-particle stress in the water: model.turbulence = "sps".
struct SubParticleStress {
  static bool is_on(const Case& whole);
  static std::vector<Rule> rules();
};

}  // namespace models

}  // namespace thalweg
