#include "case/models/turbulence.hpp"

#include "case/case.hpp"
#include "case/models/tilted_gravity.hpp"

namespace thalweg::models {

bool MixingLength::is_on(const Case& whole) {
  switch (whole.model.turbulence) {
    case Turbulence::off:
    case Turbulence::sub_particle_stress:
      return false;
    case Turbulence::mixing_length:
      return true;
  }
  return false;
}

std::vector<Rule> MixingLength::rules() {
  return {
      {Mixture::is_on, "model.turbulence", "water in the pores of a mixture has no mixing length",
       "write turbulence = \"off\""},
      {[](const Case& c) { return !WallStress::is_on(c); }, "model.turbulence",
       "turbulence = \"mixing-length\" needs walls that brake the flow by the law of the wall",
       "write wall_friction = \"smooth\" or \"rough\", or turbulence = \"off\""},
      {has_tilted_gravity, "model.turbulence", "turbulence = \"mixing-length\" measures the depth of the water along z",
       "let gravity point along -z, or write turbulence = \"off\""}};
}

bool SubParticleStress::is_on(const Case& whole) {
  switch (whole.model.turbulence) {
    case Turbulence::off:
    case Turbulence::mixing_length:
      return false;
    case Turbulence::sub_particle_stress:
      return true;
  }
  return false;
}

std::vector<Rule> SubParticleStress::rules() {
  return {{Mixture::is_on, "model.turbulence", "water in the pores of a mixture has no sub-particle stress",
           "write turbulence = \"off\""}};
}

}  // namespace thalweg::models
