#include <cmath>

#include "case/models/mixture.hpp"
#include "physics/seepage/skeleton.hpp"
#include "solver/models/all.hpp"
#include "solver/models/make.hpp"

namespace thalweg {

template <int Dim>
void MixtureModel::make(const SceneSource& from, Scene<Dim>& scene) {
  MixtureScene& law = scene.seepage;
  law.mixture = scene.has_sediment && models::Mixture::is_on(from.of);
  if (!law.mixture) return;
  const SedimentParameters& s = from.of.sediment();
  const double solids = 1 - s.porosity;
  law.solids_at_rest = static_cast<float>(solids);
  law.grain_diameter = static_cast<float>(s.grain_diameter);
  law.skeleton_stiffness =
      static_cast<float>(skeleton_stiffness(solids, s.grain_density, s.pore_density, from.sound_speed));
  // The particles of a mixture are the grains alone.
  scene.sediment_density = static_cast<float>(s.grain_density);
  // Both sets free of each other: c^2 (1 + phi rho_w/(n rho_grain)), the fastest wave (docs/theory.md).
  scene.fast_wave = std::sqrt(1 + solids * s.pore_density / (s.porosity * s.grain_density));
}

template void MixtureModel::make(const SceneSource&, Scene<2>&);
template void MixtureModel::make(const SceneSource&, Scene<3>&);

}  // namespace thalweg
