#pragma once

#include "case/case.hpp"
#include "common/particles.hpp"

// From a case to the constants of the models. Each model has a make.cpp beside it with
//   template <int Dim> void Model::make(const SceneSource& from, Scene<Dim>& scene)
// which fills its own members of the scene. Models are made in the order of their list (models/all.hpp).
namespace thalweg {

class WaterBody;

/// The source of a scene.
struct SceneSource {
  const Case& of;
  const ParticleSet& particles;      // as filled; bounds and counts depend on them
  double sound_speed = 0;            // [m/s]
  const WaterBody* water = nullptr;  // of the whole scene, where `particles` are few of it (current/water_body.hpp)
};

}  // namespace thalweg
