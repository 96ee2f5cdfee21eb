#include "solver/models/make.hpp"
#include "case/models/openings.hpp"
#include "solver/models/all.hpp"

namespace thalweg {

template <int Dim>
void OpeningsModel::make(const SceneSource& from, Scene<Dim>& scene) {
  scene.has_openings = models::OpenBoundaries::is_on(from.of);
}

template void OpeningsModel::make(const SceneSource&, Scene<2>&);
template void OpeningsModel::make(const SceneSource&, Scene<3>&);

}  // namespace thalweg
