#pragma once

#include <cmath>
#include <cstdint>

#include "solver/models/suspended_load/bed_change.hpp"
#include "solver/models/suspended_load/exchange.hpp"
#include "solver/models/suspended_load/scene.hpp"
#include "solver/models/suspended_load/settling.hpp"
#include "solver/models/suspended_load/surface_exchange.hpp"

namespace thalweg {

struct SceneSource;

/// Grains that the water carries as a concentration: [suspended_load].
struct SuspendedLoadModel {
  template <int Dim>
  using Parameters = SuspendedLoadScene<Dim>;
  template <class Device>
  using Arrays = SuspendedLoadArrays<Device>;
  static constexpr const char* heading = "carry_suspended_load";

  /// Fills the model's members of the scene (make.cpp).
  template <int Dim>
  static void make(const SceneSource& from, Scene<Dim>& scene);

  template <class Scene>
  static constexpr bool is_on(const Scene& scene) {
    return scene.suspended_load.on;
  }
  template <class Device, class Scene, class Workspace>
  static void before_lists(Device& on, Particles<Device>& p, const Scene& scene, Workspace&) {
    if (!scene.surface_bed.on) change_bed(on, p, scene);
  }
  template <class C>
  static void at_start(C& step) {
    find_concentrations(step.on, step.p, step.scene);
  }
  template <class C>
  static void add_forces(C& step) {
    add_mixture_forces(step.on, step.p, step.scene);
  }
  template <class C>
  static void after_step(C& step) {
    auto& p = step.p;
    const SubParticle* sub_particle = step.scene.sub_particle_stress ? p.sub_particle.data() : nullptr;
    const Eddies* eddies = step.scene.mixing_length ? p.eddies.data() : nullptr;
    step.on.for_each(p.fluid_count, DiffusivityPass<C::dimension>{p.record.data(), p.roles(), sub_particle, eddies,
                                                                  p.suspended.data(), step.scene});
    settle(step.on, p, step.scene, step.state);
    if (step.scene.surface_bed.on) {
      exchange_with_surface(step.on, p, step.scene, step.state, step.work.bed_lifted);
    } else {
      exchange_with_bed(step.on, p, step.scene, step.state);
    }
  }
  template <class C>
  static void after_reading(C& step) {
    if (step.scene.surface_bed.on) return;
    if (is_bed_change_due(step.now.number + 1)) step.now.squared_drift = INFINITY;
  }
};

}  // namespace thalweg
