#include <algorithm>
#include <cmath>

#include "solver/models/all.hpp"
#include "solver/models/make.hpp"
#include "solver/models/wall_stress/contact.hpp"
#include "solver/passes/time_step.hpp"

namespace thalweg {

namespace {

/// Bound of tau/(rho |u|) [m/s]. The water of one layer is slowed by tau/(rho dp) of each wall it lies on, three in a
/// corner, and twice that where the layer is half empty: a bound of dp/(6 dt) takes at most its whole speed in a step
/// of dt, the longest the scene can make.
template <int Dim>
float most_drag(const Scene<Dim>& scene) {
  const double h = scene.smoothing_length;
  const double nu = double(scene.water_viscosity) / double(scene.water_density);
  const double longest = std::min(longest_stable_step(scene), 0.125 * h * h / nu);
  return static_cast<float>(scene.spacing / (6 * longest));
}

}  // namespace

template <int Dim>
void WallStressModel::make(const SceneSource& from, Scene<Dim>& scene) {
  const WallFriction friction = from.of.model.wall_friction;
  scene.wall_stress.on = friction == WallFriction::smooth || friction == WallFriction::rough;
  if (!scene.wall_stress.on) return;
  scene.needs_near_walls = true;
  scene.wall_stress.viscosity = scene.water_viscosity / scene.water_density;
  scene.wall_stress.contact = weight_of_half_a_layer(scene);
  scene.wall_stress.most_drag = most_drag(scene);
}

template void WallStressModel::make(const SceneSource&, Scene<2>&);
template void WallStressModel::make(const SceneSource&, Scene<3>&);

}  // namespace thalweg
