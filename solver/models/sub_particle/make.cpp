#include "solver/models/make.hpp"
#include "case/models/turbulence.hpp"
#include "solver/models/all.hpp"

namespace thalweg {

template <int Dim>
void SubParticleModel::make(const SceneSource& from, Scene<Dim>& scene) {
  scene.sub_particle_stress = models::SubParticleStress::is_on(from.of);
}

template void SubParticleModel::make(const SceneSource&, Scene<2>&);
template void SubParticleModel::make(const SceneSource&, Scene<3>&);

}  // namespace thalweg
