#include "foam_reference/sediment_rheology.hpp"

namespace thalweg::foam {

StockRheology stock_rheology(const Case& scene, const SceneContents& contents) {
  const SedimentParameters& sediment = scene.sediment();
  const double submerged_density = sediment.bed_density() - sediment.pore_density;

  StockRheology rheology;
  rheology.density = sediment.bed_density();
  rheology.yield_coefficient = yield_pressure_coefficient(sediment.friction_angle, scene.model.plane_strain_fit());
  rheology.effective_pressure = submerged_density * scene.domain.gravity.norm() * contents.bed_thickness / 2;
  rheology.yield_stress =
      rheology.yield_coefficient * rheology.effective_pressure +
      yield_cohesion_term(sediment.cohesion, sediment.friction_angle, scene.model.plane_strain_fit());
  rheology.consistency = sediment.consistency;
  rheology.flow_index = sediment.flow_index;
  rheology.viscosity_cap = rheology.yield_stress * sediment.regularisation / 2 + sediment.consistency;
  return rheology;
}

}  // namespace thalweg::foam
