#include "solver/models/make.hpp"
#include "solver/models/all.hpp"

namespace thalweg {

template <int Dim>
void NoSlipModel::make(const SceneSource& from, Scene<Dim>& scene) {
  scene.water_sticks = from.of.model.wall_friction == WallFriction::no_slip;
  scene.needs_near_walls = scene.needs_near_walls || scene.water_sticks;
  if (scene.water_sticks || scene.has_sediment) {
    scene.no_slip = NoSlip<Dim>(scene.smoothing_length, scene.spacing);
  }
}

template void NoSlipModel::make(const SceneSource&, Scene<2>&);
template void NoSlipModel::make(const SceneSource&, Scene<3>&);

}  // namespace thalweg
