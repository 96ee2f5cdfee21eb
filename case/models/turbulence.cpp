#include "case/models/turbulence.hpp"

#include "case/case.hpp"

namespace thalweg::models {

bool SubParticleStress::is_on(const Case& whole) {
  switch (whole.model.turbulence) {
    case Turbulence::off:
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
