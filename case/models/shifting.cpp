#include "case/models/shifting.hpp"

#include "case/case.hpp"
#include "case/models/mixture.hpp"

namespace thalweg::models {

bool ParticleShifting::is_on(const Case& whole) { return whole.numerics.shifting == Shifting::on; }

std::vector<Rule> ParticleShifting::rules() {
  return {{Mixture::is_on, "numerics.shifting", "shifting knows no mixture, whose two sets share their places",
           "write shifting = \"off\""}};
}

}  // namespace thalweg::models
