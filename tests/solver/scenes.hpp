#pragma once

#include <omp.h>

#include "lattice_scene.hpp"
#include "solver/backend/openmp.hpp"
#include "solver/simulation/simulation_on.hpp"

// Scenes on the baseline of the OpenMP backend, for tests that call a pass by itself and look into its arrays.
namespace thalweg::test {

using Device = OpenMp<4>;

/// Particles on the device, lists built; what a pass needs to be called by itself.
template <int Dim, class On = Device>
struct Loaded {
  On on;
  Particles<On> p;
  Scene<Dim> scene;
};

template <class On = Device, int Dim>
Loaded<Dim, On> load(const Scene<Dim>& scene, const ParticleSet& from) {
  Loaded<Dim, On> l{On{}, {}, scene};
  load_particles(l.on, l.p, scene, from);
  rebuild_lists(l.on, l.p, scene);
  return l;
}

/// A step of dt seconds, for passes called by themselves.
inline StepState step_of(double dt) {
  StepState state;
  state.step.dt = dt;
  return state;
}

/// update_rest, and the lists after it if they change, as the step does.
inline void update_rest_and_lists(Loaded<2>& l, const Scene<2>& scene, double dt) {
  StepState state = step_of(dt);
  update_rest(l.on, l.p, scene, &state);
  if (state.woken + state.stopped > 0) list_active_clusters(l.on, l.p);
}

}  // namespace thalweg::test
