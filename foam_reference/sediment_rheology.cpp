#include "foam_reference/sediment_rheology.hpp"

#include "physics/sediment/effective_pressure.hpp"

namespace thalweg::foam {

SedimentMaterial<double> sediment_material(const Case& scene) {
  return make_material<double>(scene.sediment(), {scene.model.yield, scene.model.yield_fit, scene.model.rheology,
                                                  scene.model.implementation == Implementation::paper});
}

StockRheology stock_rheology(const Case& scene, const SceneContents& contents) {
  const SedimentParameters& sediment = scene.sediment();
  const SedimentMaterial<double> material = sediment_material(scene);
  const double weight = submerged_weight(sediment.bed_density(), sediment.pore_density, scene.domain.gravity.norm());

  StockRheology rheology;
  rheology.density = sediment.bed_density();
  rheology.yield_coefficient = material.yield_coefficient;
  rheology.effective_pressure = weight * contents.bed_thickness / 2;
  rheology.yield_stress = yield_stress_of(material, rheology.effective_pressure, 0.0);
  rheology.consistency = material.consistency;
  rheology.flow_index = material.flow_index;
  rheology.viscosity_cap = rheology.yield_stress * material.regularisation / 2 + material.consistency;
  return rheology;
}

}  // namespace thalweg::foam
