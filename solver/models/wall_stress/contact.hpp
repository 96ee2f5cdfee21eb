#pragma once

#include <cmath>

#include "solver/state/scene.hpp"

namespace thalweg {

/// Sum of V W over half a layer of water, a spacing from the particle of a wall or bed [-]. Less than that is partly dry.
template <int Dim>
inline float weight_of_half_a_layer(const Scene<Dim>& scene) {
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

}  // namespace thalweg
