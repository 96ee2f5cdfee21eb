#include "solver/models/make.hpp"
#include "case/models/shifting.hpp"
#include "solver/models/all.hpp"

namespace thalweg {

template <int Dim>
void ShiftingModel::make(const SceneSource& from, Scene<Dim>& scene) {
  if (models::ParticleShifting::is_on(from.of)) use_shifting(scene);
}

template void ShiftingModel::make(const SceneSource&, Scene<2>&);
template void ShiftingModel::make(const SceneSource&, Scene<3>&);

}  // namespace thalweg
