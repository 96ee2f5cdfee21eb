#pragma once

#include <omp.h>

#include "lattice_scene.hpp"
#include "solver/backend/openmp.hpp"
#include "solver/core.hpp"

// Scenes on the baseline of the OpenMP backend, for tests that call a pass by itself and look into its arrays.
namespace thalweg::test {

using Device = OpenMp<4>;

/// Particles on the device, lists built; what a pass needs to be called by itself.
template <int Dim>
struct Loaded {
  Device on;
  Particles<Device> p;
  Scene<Dim> scene;
};

template <int Dim>
Loaded<Dim> load(const Scene<Dim>& scene, const ParticleSet& from) {
  Loaded<Dim> l{Device{}, {}, scene};
  load_particles(l.on, l.p, scene, from);
  std::int64_t rebuilt = 0;
  refresh_neighbours(l.on, l.p, scene, rebuilt);
  return l;
}

}  // namespace thalweg::test
