#pragma once

#include "solver/models/bed/strain.hpp"
#include "solver/models/rest/resting_pressure.hpp"
#include "solver/models/two_pass/scene.hpp"
#include "solver/models/two_pass/two_pass.hpp"
#include "solver/passes/momentum.hpp"
#include "solver/passes/pressure.hpp"

namespace thalweg {

struct SceneSource;

template <class Device>
struct TwoPassWork {
  typename Device::template Buffer<StepStart> start;  // of the particles; empty unless scene.two_pass
};

/// The explicit midpoint rule in place of leapfrog.
struct TwoPassModel {
  template <int Dim>
  using Parameters = TwoPassScene<Dim>;
  template <class Device>
  using Work = TwoPassWork<Device>;
  static constexpr const char* heading = "drift";

  /// Fills the model's members of the scene (make.cpp).
  template <int Dim>
  static void make(const SceneSource& from, Scene<Dim>& scene);

  template <class Scene>
  static constexpr bool is_on(const Scene& scene) {
    return scene.two_pass;
  }
  /// Accelerations and density rates of half-way.
  template <class C>
  static void at_midpoint(C& step) {
    auto& on = step.on;
    auto& p = step.p;
    const auto& scene = step.scene;
    step.time("compute_density_rates", [&] { compute_density_rates(on, p, scene); });
    go_half_way(on, p, scene, step.state, step.work.start);
    step.time("apply_equation_of_state", [&] { apply_equation_of_state(on, p, scene); });
    step.time("extrapolate_to_walls", [&] {
      if (p.any_resting) extrapolate_to_resting(on, p, scene);
      extrapolate_to_walls(on, p, scene);
    });
    step.time("compute_accelerations", [&] { compute_accelerations(on, p, scene); });
    step.time("compute_density_rates", [&] { compute_density_rates(on, p, scene); });
  }
  template <class C>
  static void at_kick(C& step) {
    kick_from_start(step.on, step.p, step.state, step.work.start);
  }
  template <class C>
  static void at_motion(C& step) {
    go_all_the_way(step.on, step.p, step.scene, step.state, step.work.start);
  }
};

}  // namespace thalweg
