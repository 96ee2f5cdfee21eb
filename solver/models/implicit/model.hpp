#pragma once

#include <algorithm>

#include "solver/models/bed_load/coupling.hpp"
#include "solver/models/implicit/conjugate_gradients.hpp"
#include "solver/models/implicit/explicit_viscosity.hpp"
#include "solver/models/implicit/retry.hpp"
#include "solver/models/implicit/scene.hpp"
#include "solver/models/seepage/coupling.hpp"

namespace thalweg {

struct SceneSource;

/// Buffers and results of the viscous part that live between steps.
template <class Device>
struct ViscousWork {
  ViscousSystem<Device> viscous;
  int viscous_iterations = 0;  // of the last step
  ViscousResult viscous_result;

  [[nodiscard]] std::size_t bytes() const {
    return viscous.coefficient.size() * sizeof(typename Device::PairCoefficient) +
           viscous.vectors.size() * sizeof(Vectors) + viscous.row.size() * sizeof(typename ViscousSystem<Device>::Row);
  }
};

/// Viscosity of the sediment and of the layer between water and sediment, by the treatment the scene has chosen.
struct ViscosityModel {
  template <int Dim>
  using Parameters = ViscosityScene<Dim>;
  template <class Device>
  using Work = ViscousWork<Device>;
  static constexpr const char* heading = "solve_viscosity";

  /// Fills the model's members of the scene (make.cpp).
  template <int Dim>
  static void make(const SceneSource& from, Scene<Dim>& scene);

  template <class Scene>
  static constexpr bool is_on(const Scene& scene) {
    return scene.has_sediment;
  }

  /// Memory of the solve's rows [bytes].
  template <class Scene>
  static double lattice_bytes(const Scene& scene, double particles) {
    const bool solves = scene.viscosity == ViscosityTreatment::implicit;
    return solves ? particles * sizeof(ViscousRow) : 0;
  }

  template <class Scene>
  HOST_DEVICE static bool is_explicit(const Scene& scene) {
    return scene.viscosity == ViscosityTreatment::explicit_steps;
  }
  template <class C>
  static void find_limits(C& step) {
    if (is_explicit(step.scene)) find_sediment_viscosity(step.on, step.p, step.scene, step.state);
  }
  template <class Scene>
  HOST_DEVICE static void limit_step(const Scene& scene, StepState& state) {
    if (is_explicit(scene)) limit_by_sediment_viscosity(scene, state);
  }

  template <class C>
  static void begin_implicit(C& step) {
    auto& on = step.on;
    auto& p = step.p;
    const auto& scene = step.scene;
    if (scene.bed_load.on) prepare_drag(on, p);
    switch (scene.viscosity) {
      case ViscosityTreatment::implicit:
        if (scene.seepage.mixture) prepare_mixture_viscosity(on, p, scene);
        with_coupling(step, [&](const auto& coupling) {
          begin_viscous_solve(on, p, scene, step.work.viscous, step.state, coupling);
        });
        break;
      case ViscosityTreatment::explicit_steps:
        add_viscosity(step);
        break;
      case ViscosityTreatment::capped:
        cap_viscosity(on, p, scene, step.state);
        add_viscosity(step);
        break;
    }
  }

  /// A device that works ahead of the host is given a few iterations more than the last step took, in fours, so that
  /// the launches are often the same.
  template <class C>
  static int iterations_ahead(C& step) {
    return waits_for_device(step.on) ? step.scene.viscous_iterations : iterations_handed_over(step);
  }
  template <class C>
  static int iterations_handed_over(C& step) {
    return std::min(step.work.viscous_iterations / 4 * 4 + 4, 1000);
  }
  template <class C>
  static void iterate_implicit(C& step) {
    if (step.scene.viscosity != ViscosityTreatment::implicit) return;
    with_coupling(step, [&](const auto& coupling) {
      iterate_viscous_solve(step.on, step.p, step.scene, step.work.viscous, step.state, iterations_ahead(step),
                            coupling);
    });
  }
  template <class C>
  static void end_implicit(C& step) {
    if (step.scene.viscosity == ViscosityTreatment::implicit) {
      end_viscous_solve(step.on, step.p, step.work.viscous, step.state);
    }
  }

  /// Goes on with a solve that is not at its end, and tries one that failed again: first without a guess, then with
  /// half the step.
  template <class C, class IterateAndEnd>
  static void finish(C& step, const IterateAndEnd& iterate_and_end) {
    ViscousResult& result = step.work.viscous_result;
    result = {};
    int iterations = 0;  // of solves that failed
    while (step.now.viscous.running != 0 || viscosity::may_retry(step.now.viscous, result.retries)) {
      if (step.now.viscous.running == 0) {
        iterations += step.now.viscous.iterations;
        viscosity::prepare_retry(step.on, step.p, step.state, result.retries > 0);
        begin_implicit(step);
        ++result.retries;
      }
      iterate_and_end();
      step.now = step.on.read(step.state);
    }
    step.work.viscous_iterations = step.now.viscous.iterations;
    result.iterations = iterations + step.now.viscous.iterations;
    result.residual = step.now.viscous.residual;
    result.converged = step.now.viscous.converged != 0;
    result.capped = step.now.capped;
  }

 private:
  template <class C>
  static void add_viscosity(C& step) {
    with_coupling(step, [&](const auto& coupling) {
      apply_explicit_viscosity(step.on, step.p, step.scene, step.state, coupling);
    });
  }

  /// Calls what() with the coupling of the scene's bed.
  template <class C, class What>
  static void with_coupling(C& step, const What& what) {
    constexpr int dimension = C::dimension;
    if (step.scene.seepage.mixture) {
      what(MixtureCoupling<dimension>{step.scene});
    } else if (step.scene.bed_load.on) {
      what(DragCoupling<dimension>{step.scene});
    } else {
      what(ViscousCoupling<dimension>{step.scene});
    }
  }
};

}  // namespace thalweg
