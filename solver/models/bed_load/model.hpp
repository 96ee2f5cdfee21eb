#pragma once

#include "solver/models/bed_load/coupling.hpp"
#include "solver/models/bed_load/drag.hpp"
#include "solver/models/bed_load/drift.hpp"
#include "solver/models/bed_load/hold.hpp"
#include "solver/models/bed_load/lent_pressure.hpp"
#include "solver/models/bed_load/lone_parcels.hpp"
#include "solver/models/bed_load/scene.hpp"

namespace thalweg {

struct SceneSource;

/// Bed load at the rate of a measured law, and one shear stress for the water and the grains.
struct BedLoadModel {
  template <int Dim>
  using Parameters = BedLoadScene<Dim>;
  template <class Device>
  using Arrays = BedLoadArrays<Device>;
  static constexpr const char* heading = "move_bed_load";

  /// Fills the model's members of the scene (make.cpp).
  template <int Dim>
  static void make(const SceneSource& from, Scene<Dim>& scene);

  template <class Scene>
  static constexpr bool is_on(const Scene& scene) {
    return scene.bed_load.on;
  }
  template <class C>
  static void at_strength(C& step) {
    lend_pressure(step.on, step.p, step.scene);
  }
  template <class C>
  static void add_forces(C& step) {
    lighten_lone_parcels(step.on, step.p, step.scene);
    if (step.scene.bed_load.holds_surface) hold_surface(step.on, step.p, step.scene);
  }
  template <class C>
  static void before_motion(C& step) {
    find_drift(step.on, step.p, step.scene);
  }
  template <class C>
  static void after_step(C& step) {
    step.on.for_each(step.p.fluid_count, BedDragPass<C::dimension>{step.p.record.data(), step.p.bed.data(),
                                                                   step.p.drift.data(), step.scene});
  }
};

}  // namespace thalweg
