#include "case/models/suspended_load.hpp"

#include "case/case.hpp"

namespace thalweg::models {

bool SuspendedLoadOfWater::is_on(const Case& whole) {
  switch (whole.suspended_load.carried_by) {
    case CarriedBy::parcels:
      return false;
    case CarriedBy::water:
      return true;
  }
  return false;
}

std::vector<Rule> SuspendedLoadOfWater::rules() {
  return {{[](const Case& c) {
             const bool has_bed = ThreeState::is_on(c) || SurfaceBedOfCase::is_on(c);
             return !has_bed || c.model.implementation != Implementation::law;
           },
           "suspended_load.carried_by",
           "water that carries grains needs the laws of three-state sediment or of a bed that is a surface",
           "write sediment = \"three-state\" or \"surface\", and implementation = \"law\", in [model]"},
          {[](const Case& c) { return !c.has_sediment(); }, "suspended_load.carried_by",
           "no shape of the scene has sediment, and no water has a concentration",
           "give a shape the role \"sediment\", or a shape of water a concentration"}};
}

}  // namespace thalweg::models
