#include "solver/models/make.hpp"
#include "case/models/two_pass.hpp"
#include "solver/models/all.hpp"

namespace thalweg {

template <int Dim>
void TwoPassModel::make(const SceneSource& from, Scene<Dim>& scene) {
  scene.two_pass = models::TwoPass::is_on(from.of);
}

template void TwoPassModel::make(const SceneSource&, Scene<2>&);
template void TwoPassModel::make(const SceneSource&, Scene<3>&);

}  // namespace thalweg
