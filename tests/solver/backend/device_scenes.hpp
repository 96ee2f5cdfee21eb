#pragma once

#include <memory>
#include <string>
#include <vector>

#include "solver/simulation/input.hpp"
#include "tests/solver/lattice_scene.hpp"

namespace thalweg::test {

/// A small scene in motion, and for how many steps it is worth comparing.
struct DeviceScene {
  std::string name;
  AnyScene scene;
  ParticleSet particles;
  int steps = 20;
  std::vector<WallMotion> motions = {};
  bool has_openings = false;

  /// Those of the scene, fresh for a simulation; null without any.
  [[nodiscard]] std::shared_ptr<Openings> openings() const;
  ParticleSet before_laying = {};  // the particles before their sediment became a bed that is a surface
  /// That bed, for a simulation that starts with `from`; null without one.
  [[nodiscard]] std::shared_ptr<SurfaceBed> surface_bed(const ParticleSet& from) const;
};

/// Scenes that together go through every pass.
std::vector<DeviceScene> device_scenes();

/// The differences of two outcomes of one start, by particle.
struct Difference {
  double moved = 0;      // the longest way from the start [m]
  double apart = 0;      // the largest distance between the outcomes [m]
  int other_states = 0;  // particles in another state
};
Difference difference(const ParticleSet& start, const ParticleSet& a, const ParticleSet& b);

}  // namespace thalweg::test
