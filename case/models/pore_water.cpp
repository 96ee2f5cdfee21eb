#include "case/models/pore_water.hpp"

#include "case/case.hpp"

namespace thalweg::models {
namespace {}  // namespace

std::vector<Rule> pore_water_rules(const std::string& key) {
  // Rules are asked in this order: without the first, there may be no sediment whose pores the others could ask for.
  return {{[](const Case& c) { return !c.has_sediment(); }, key, key + " is on, and no shape has the role sediment",
           "remove it"},
          {[](const Case& c) { return c.sediment().pore_density != c.water.density; }, key,
           key + " needs pores full of the scene's water", "give pore_density the density of water"},
          // Ergun's law loses its meaning below.
          {[](const Case& c) { return !(c.sediment().porosity >= 0.2); }, key, key + " needs a porosity of 0.2 or more",
           "use Ergun's law where it holds"},
          {[](const Case& c) { return !(c.water.viscosity > 0); }, key, key + " needs the water's viscosity",
           "give materials.water.viscosity"}};
}

}  // namespace thalweg::models
