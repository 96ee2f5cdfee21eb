#pragma once

#include "physics/water/viscosity_treatment.hpp"
#include "solver/models/sub_particle/arrays.hpp"
#include "solver/models/sub_particle/stress_sweep.hpp"
#include "solver/passes/time_step.hpp"

namespace thalweg {

struct SceneSource;

/// Stress in the water by eddies smaller than the particles: model.turbulence = "sps".
struct SubParticleModel {
  template <int Dim>
  using Parameters = SubParticleScene<Dim>;
  template <class Device>
  using Arrays = SubParticleArrays<Device>;

  /// Fills the model's members of the scene (make.cpp).
  template <int Dim>
  static void make(const SceneSource& from, Scene<Dim>& scene);

  template <class Scene>
  static constexpr bool is_on(const Scene& scene) {
    return scene.sub_particle_stress;
  }
  template <class C>
  static void add_forces(C& step) {
    add_sub_particle_stress(step.on, step.p, step.scene);
  }

  template <class C>
  static void find_limits(C& step) {
    const SubParticle* sub_particle = step.p.sub_particle.data();
    StepState* state = step.state;
    step.on.reduce_then(
        step.p.fluid_count, 0.0F, declare<Reads<field::sub_particle>, Writes<>>([=] HOST_DEVICE(Index i) {
          return sub_particle[i].eddy_viscosity;
        }),
        [] HOST_DEVICE(float a, float b) { return a > b ? a : b; },
        [=] HOST_DEVICE(float found) { state->eddy_viscosity = found; });
  }
  /// To 0.125 h^2 over the largest viscosity of the water, its own and that of the eddies. It takes velocities that
  /// differ by many times the sound speed between neighbours to get there.
  template <class Scene>
  HOST_DEVICE static void limit_step(const Scene& scene, StepState& state) {
    const double nu = double(scene.water_viscosity) / double(scene.water_density) + double(state.eddy_viscosity);
    if (nu > 0) shorten(state.step, viscous_time_step(scene.smoothing_length, nu), Limiter::viscosity);
  }
};

}  // namespace thalweg
