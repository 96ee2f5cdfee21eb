#include "case/models/wall_friction.hpp"

#include "case/case.hpp"

namespace thalweg::models {
namespace {

bool is_rough_without_roughness(const Case& c) {
  return c.model.wall_friction == WallFriction::rough && !c.has_rough_walls();
}

bool has_no_viscosity(const Case& c) { return !(c.water.viscosity > 0); }

}  // namespace

bool WallStress::is_on(const Case& whole) {
  switch (whole.model.wall_friction) {
    case WallFriction::none:
    case WallFriction::no_slip:
      return false;
    case WallFriction::smooth:
    case WallFriction::rough:
      return true;
  }
  return false;
}

std::vector<Rule> WallStress::rules() {
  return {{is_rough_without_roughness, "model.wall_friction", "walls are rough, and no wall has a roughness",
           "give a wall's [[shape]] a roughness, or write wall_friction = \"smooth\""},
          {has_no_viscosity, "materials.water.viscosity", "the shear stress of a smooth wall needs a viscosity",
           "give water a viscosity, or write wall_friction = \"none\""}};
}

}  // namespace thalweg::models
