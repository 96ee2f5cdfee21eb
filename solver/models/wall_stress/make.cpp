#include <algorithm>
#include <cmath>

#include "solver/models/all.hpp"
#include "solver/models/make.hpp"
#include "solver/passes/time_step.hpp"

namespace thalweg {

namespace {

/// Sum of V W over half a layer of water, a spacing from the wall particle [-].
template <int Dim>
float weight_of_half_a_layer(const Scene<Dim>& scene) {
  const auto reach = static_cast<int>(2 * scene.smoothing_length / scene.spacing);
  const auto dp = static_cast<float>(scene.spacing);
  float sum = 0;
  for (int x = -reach; x <= reach; ++x) {
    for (int y = Dim == 3 ? -reach : 0; y <= (Dim == 3 ? reach : 0); ++y) {
      sum += scene.kernel.value(scene.kernel.closeness(dp * std::sqrt(static_cast<float>(1 + x * x + y * y))));
    }
  }
  return 0.5F * sum * std::pow(dp, static_cast<float>(Dim));
}

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
