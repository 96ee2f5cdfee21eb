#pragma once

#include <cmath>

#include "solver/state/scene.hpp"

namespace thalweg {

/// Spacings within the kernel's reach.
template <int Dim>
inline int layers_in_reach(const Scene<Dim>& scene) {
  return static_cast<int>(2 * scene.smoothing_length / scene.spacing);
}

/// Sum of V W over a layer of a lattice, `layer` spacings from a particle, which does not count itself [-].
template <int Dim>
inline float weight_of_layer(const Scene<Dim>& scene, int layer) {
  const int reach = layers_in_reach(scene);
  const auto dp = static_cast<float>(scene.spacing);
  float sum = 0;
  for (int x = -reach; x <= reach; ++x) {
    for (int y = Dim == 3 ? -reach : 0; y <= (Dim == 3 ? reach : 0); ++y) {
      const int square = layer * layer + x * x + y * y;
      if (square == 0) continue;
      sum += scene.kernel.value(scene.kernel.closeness(dp * std::sqrt(static_cast<float>(square))));
    }
  }
  return sum * std::pow(dp, static_cast<float>(Dim));
}

/// Sum of V W over half a layer of water, a spacing from the particle of a wall or bed [-]. Less than that is partly dry.
template <int Dim>
inline float weight_of_half_a_layer(const Scene<Dim>& scene) {
  return 0.5F * weight_of_layer(scene, 1);
}

}  // namespace thalweg
