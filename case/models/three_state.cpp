#include "case/models/three_state.hpp"

#include <algorithm>

#include "case/case.hpp"

namespace thalweg::models {

bool ThreeState::is_on(const Case& whole) {
  switch (whole.model.sediment) {
    case SedimentModel::off:
    case SedimentModel::viscoplastic:
    case SedimentModel::surface:
      return false;
    case SedimentModel::three_state:
      return true;
  }
  return false;
}

std::vector<Rule> ThreeState::rules() {
  return {{[](const Case& c) { return !(c.domain.gravity.norm() > 0); }, "model.sediment",
           "sediment = \"three-state\" needs gravity: grains roll and settle by their weight",
           "give domain.gravity, or write sediment = \"viscoplastic\""},
          {[](const Case& c) { return !(c.water.viscosity > 0); }, "materials.water.viscosity",
           "sediment = \"three-state\" needs the water's viscosity for shear and settling",
           "give it, or write sediment = \"viscoplastic\""},
          {[](const Case& c) {
             return std::none_of(c.shapes.begin(), c.shapes.end(),
                                 [](const Shape& shape) { return shape.role == ShapeRole::water; });
           },
           "model.sediment", "sediment = \"three-state\" needs water, which moves grains along and lifts them",
           "give a shape the role \"water\", or write sediment = \"viscoplastic\""}};
}

}  // namespace thalweg::models
