#include "case/models/driven_flow.hpp"

#include <algorithm>

#include "case/case.hpp"
#include "case/models/mixture.hpp"
#include "case/models/tilted_gravity.hpp"
#include "physics/water/viscosity_switch.hpp"

namespace thalweg {

double roughness_of_current(const Case& of) {
  if (of.has_sediment()) {
    const SedimentParameters& bed = of.sediment();
    return bed.roughness > 0 ? bed.roughness : bed.grain_diameter;
  }
  double largest = 0;
  if (of.model.wall_friction != WallFriction::rough) return largest;
  for (const Shape& shape : of.shapes) largest = std::max(largest, shape.roughness);
  return largest;
}

namespace models {
namespace {

/// Of a direction that a flow can have; the table refuses others.
bool is_not_periodic(const Case& c) {
  const bool known = c.flow.along == "x" || (c.flow.along == "y" && c.info.dimension == 3);
  return known && !c.domain.is_periodic(c.flow.along == "x" ? 0 : 1);
}

bool is_braked_by_artificial_viscosity(const Case& c) {
  return c.numerics.artificial_viscosity > 0 && c.numerics.smoothing_ratio < least_ratio_of_viscosity_switch;
}

bool is_guided_without_eddies(const Case& c) {
  return c.flow.guide_length > 0 && c.model.turbulence != Turbulence::mixing_length;
}

/// Nothing takes the drive's momentum: the velocity would rise for ever.
bool is_without_friction(const Case& c) {
  return c.flow.drive == Drive::slope && !c.has_sediment() && c.model.wall_friction == WallFriction::none;
}

}  // namespace

bool DrivenFlow::is_on(const Case& whole) { return whole.flow.drive != Drive::off; }

std::vector<Rule> DrivenFlow::rules() {
  return {{is_not_periodic, "flow.along", "the flow goes along a direction in which the domain does not repeat itself",
           "name the direction in domain.periodic"},
          {has_tilted_gravity, "flow.drive", "a driven flow needs gravity straight down, along -z",
           "write gravity = [0, -9.81] (in space [0, 0, -9.81]) m/s^2, and give the tilt as flow.slope"},
          {[](const Case& c) { return !c.has_water(); }, "flow.drive",
           "no shape of the scene is water, and the drive acts on water",
           "give a shape the role \"water\", or remove [flow]"},
          {is_without_friction, "flow.drive", "walls without friction let a flow down a slope accelerate for ever",
           "write wall_friction = \"smooth\" or \"rough\" in [model]"},
          {[](const Case& c) { return !(c.water.viscosity > 0); }, "materials.water.viscosity",
           "a driven flow needs the water's viscosity for the friction of walls and beds", "give it"},
          {Mixture::is_on, "flow.drive", "the two sets of particles of a mixture cannot be driven",
           "write seepage = \"off\", or remove [flow]"},
          {is_guided_without_eddies, "flow.guide_length",
           "the guide zone takes the height over the ground from the mixing length",
           "write turbulence = \"mixing-length\" in [model], or remove guide_length"},
          {is_braked_by_artificial_viscosity, "numerics.smoothing_ratio",
           "below a smoothing_ratio of 1.9 the artificial viscosity acts in shear and brakes the current",
           "write smoothing_ratio = 2, or artificial_viscosity = 0"}};
}

}  // namespace models
}  // namespace thalweg
