#include <cmath>

#include "case/models/grains.hpp"
#include "case/models/surface_bed.hpp"
#include "case/models/suspended_load.hpp"
#include "solver/models/all.hpp"
#include "solver/models/make.hpp"
#include "solver/models/wall_stress/contact.hpp"

namespace thalweg {

template <int Dim>
void SuspendedLoadModel::make(const SceneSource& from, Scene<Dim>& scene) {
  const Case& of = from.of;
  SuspendedLoadConstants& law = scene.suspended_load;
  law.on = (scene.has_states || models::SurfaceBedOfCase::is_on(of)) && models::SuspendedLoadOfWater::is_on(of);
  scene.water_has_grains = law.on;
  if (!law.on) return;
  const SedimentParameters& s = of.sediment();
  law.pick_up = of.suspended_load.pick_up;
  law.settling_velocity = static_cast<float>(suspended_settling_velocity(of));
  law.excess_density = static_cast<float>(s.grain_density / of.water.density - 1);
  law.packing = static_cast<float>(1 - s.porosity);
  const double level = of.suspended_load.reference_level;
  law.reference_level = level > 0 ? static_cast<float>(level) : scene.erosion.roughness;
  law.diffusivity = static_cast<float>(of.suspended_load.diffusivity);
  law.schmidt = static_cast<float>(of.suspended_load.schmidt);
  law.area = static_cast<float>(std::pow(scene.spacing, Dim - 1));
  law.contact = weight_of_half_a_layer(scene);
}

template void SuspendedLoadModel::make(const SceneSource&, Scene<2>&);
template void SuspendedLoadModel::make(const SceneSource&, Scene<3>&);

}  // namespace thalweg
