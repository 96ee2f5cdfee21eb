#include "case/models/two_pass.hpp"

#include "case/case.hpp"
#include "case/models/moving_walls.hpp"

namespace thalweg::models {

bool TwoPass::is_on(const Case& whole) {
  switch (whole.numerics.integrator) {
    case Integrator::leapfrog:
      return false;
    case Integrator::two_pass:
      return true;
  }
  return false;
}

std::vector<Rule> TwoPass::rules() {
  const char* cure = "write integrator = \"leapfrog\"";
  return {{MovingWalls::is_on, "numerics.integrator", "the two-pass integrator has no moving walls", cure},
          {Mixture::is_on, "numerics.integrator", "the two-pass integrator knows no mixture", cure}};
}

}  // namespace thalweg::models
