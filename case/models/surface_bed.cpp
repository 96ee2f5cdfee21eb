#include "case/models/surface_bed.hpp"

#include <algorithm>

#include "case/case.hpp"
#include "case/models/tilted_gravity.hpp"
#include "case/models/wall_friction.hpp"

namespace thalweg::models {
namespace {

bool has_a_hydrograph(const Case& c) {
  const auto varies = [](const auto& opening) { return !opening.times.empty() || !opening.file.empty(); };
  return std::any_of(c.inlets.begin(), c.inlets.end(), varies) ||
         std::any_of(c.outlets.begin(), c.outlets.end(), varies);
}

}  // namespace

bool SurfaceBedOfCase::is_on(const Case& whole) {
  switch (whole.model.sediment) {
    case SedimentModel::off:
    case SedimentModel::viscoplastic:
    case SedimentModel::three_state:
      return false;
    case SedimentModel::surface:
      return true;
  }
  return false;
}

std::vector<Rule> SurfaceBedOfCase::rules() {
  return {
      {has_tilted_gravity, "domain.gravity", "sediment = \"surface\" is a bed of columns along z",
       "let gravity point along -z, or write sediment = \"three-state\""},
      {[](const Case& c) { return c.inlets.empty() && !c.has_water(); }, "model.sediment",
       "sediment = \"surface\" needs water, whose shear stress moves the grains", "give a shape the role \"water\""},
      {[](const Case& c) { return !(c.water.viscosity > 0); }, "materials.water.viscosity",
       "sediment = \"surface\" needs the water's viscosity for its shear stress", "give it"},
      {[](const Case& c) { return !WallStress::is_on(c); }, "model.wall_friction",
       "sediment = \"surface\" moves grains by the shear stress on walls, which wall_friction leaves out",
       "write wall_friction = \"smooth\" or \"rough\""},
      {[](const Case& c) { return c.model.implementation != Implementation::law; }, "model.implementation",
       "sediment = \"surface\" moves grains by laws that were measured", "write implementation = \"law\""},
      {[](const Case& c) { return c.model.pore_pressure != PorePressureModel::off; }, "model.pore_pressure",
       "a bed that is a surface has no pores", "write pore_pressure = \"off\", or sediment = \"viscoplastic\""},
      {[](const Case& c) { return has_a_hydrograph(c) && c.surface_bed.factor == SurfaceBedSettings{}.factor; },
       "surface_bed.factor",
       "inlets and outlets follow a table over the bed's time, which runs up to 1000 times as fast as the water's",
       "give a surface_bed.factor with which the water follows the table, 10 or less"}};
}

}  // namespace thalweg::models
