#include "solver/models/make.hpp"
#include "case/models/pore_pressure.hpp"
#include "physics/seepage/consolidation.hpp"
#include "physics/seepage/ergun.hpp"
#include "solver/models/all.hpp"

namespace thalweg {

template <int Dim>
void PoreModel::make(const SceneSource& from, Scene<Dim>& scene) {
  PoreScene& law = scene.pores;
  law.on = scene.has_sediment && models::PorePressure::is_on(from.of);
  if (!law.on) return;
  const SedimentParameters& s = from.of.sediment();
  const WaterParameters& water = from.of.water;
  const double g = -from.of.domain.gravity.z();
  const double conductivity =
      hydraulic_conductivity(permeability(s.porosity, s.grain_diameter), water.density, water.viscosity, g);
  law.consolidation =
      static_cast<float>(consolidation_coefficient(conductivity, s.oedometer_modulus, water.density * g));
  if (s.critical_porosity > 0) {
    law.critical_solids = static_cast<float>(1 - s.critical_porosity);
    law.dilatancy = static_cast<float>(s.dilatancy);
    law.modulus = static_cast<float>(s.oedometer_modulus);
    law.solids_at_start = static_cast<float>(1 - s.porosity);
    law.water_viscosity = static_cast<float>(water.viscosity);
  }
  law.stiffness = static_cast<float>(s.bed_density() * from.sound_speed * from.sound_speed);
}

template void PoreModel::make(const SceneSource&, Scene<2>&);
template void PoreModel::make(const SceneSource&, Scene<3>&);

}  // namespace thalweg
