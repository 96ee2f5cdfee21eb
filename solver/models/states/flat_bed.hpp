#pragma once

#include "solver/models/wall_stress/contact.hpp"

namespace thalweg {

/// The water that a particle of a flat bed's surface sees, and what one sees more that stands out by a spacing: it has water
/// in its own layer, too.
template <int Dim>
inline void know_flat_beds(Scene<Dim>& scene) {
  scene.erosion.share_over_flat = 0;
  for (int layer = 1; layer <= layers_in_reach(scene); ++layer) {
    scene.erosion.share_over_flat += weight_of_layer(scene, layer);
  }
  scene.erosion.rise_of_share = static_cast<float>(scene.spacing) / weight_of_layer(scene, 0);
}

}  // namespace thalweg
