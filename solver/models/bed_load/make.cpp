#include <cmath>

#include "case/models/three_state.hpp"
#include "solver/models/all.hpp"
#include "solver/models/make.hpp"
#include "solver/models/wall_stress/contact.hpp"

namespace thalweg {

template <int Dim>
void BedLoadModel::make(const SceneSource& from, Scene<Dim>& scene) {
  const Case& of = from.of;
  BedLoadConstants& law = scene.bed_load;
  law.on = scene.has_states && of.model.implementation == Implementation::law;
  if (!law.on) return;
  scene.has_drift = true;
  const SedimentParameters& s = of.sediment();
  const double g = of.domain.gravity.norm();
  const double rho = of.water.density;
  law.law = of.model.bed_load;
  law.slope_effect = of.model.slope_effect;
  law.holds_surface = of.model.bed_surface == SurfaceHold::held;
  law.scale = static_cast<float>(bed_load_scale(s.grain_diameter, s.grain_density, rho, g));
  law.layer = static_cast<float>((1 - s.porosity) * scene.spacing);
  law.area = static_cast<float>(std::pow(scene.spacing, Dim - 1));
  law.contact = weight_of_half_a_layer(scene);
  law.saturation = static_cast<float>(3 * scene.spacing);
  law.submerged_weight = static_cast<float>((double(scene.sediment_density) - rho) * g);
}

template void BedLoadModel::make(const SceneSource&, Scene<2>&);
template void BedLoadModel::make(const SceneSource&, Scene<3>&);

}  // namespace thalweg
