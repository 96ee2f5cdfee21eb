#include "solver/models/make.hpp"
#include "case/models/turbulence.hpp"
#include "solver/models/all.hpp"

namespace thalweg {

template <int Dim>
void MixingLengthModel::make(const SceneSource& from, Scene<Dim>& scene) {
  scene.mixing_length = models::MixingLength::is_on(from.of);
}

template void MixingLengthModel::make(const SceneSource&, Scene<2>&);
template void MixingLengthModel::make(const SceneSource&, Scene<3>&);

}  // namespace thalweg
