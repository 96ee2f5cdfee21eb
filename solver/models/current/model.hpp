#pragma once

#include "solver/backend/buffer.hpp"
#include "solver/models/current/drive.hpp"
#include "solver/models/current/guide.hpp"
#include "solver/models/current/scene.hpp"
#include "solver/state/report.hpp"

namespace thalweg {

struct SceneSource;

/// The state of the drive.
template <class Device>
struct CurrentWork {
  typename Device::template Buffer<CurrentControl> control;  // one
  typename Device::template Buffer<Guide> guide;             // one; empty without a zone
};

/// A current that something drives around a period: [flow].
struct CurrentModel {
  template <int Dim>
  using Parameters = CurrentScene<Dim>;
  template <class Device>
  using Work = CurrentWork<Device>;
  static constexpr const char* heading = "drive_current";

  /// Fills the model's members of the scene (make.cpp).
  template <int Dim>
  static void make(const SceneSource& from, Scene<Dim>& scene);

  template <class Scene>
  static constexpr bool is_on(const Scene& scene) {
    return scene.current.on;
  }
  template <class C>
  static void add_forces(C& step) {
    auto& p = step.p;
    step.on.for_each(p.fluid_count, DrivePass{p.record.data(), p.rates.data(), step.work.control.data(),
                                              step.scene.current.component});
    if (!step.scene.current.guide.on) return;
    guide_current(step.on, p, p.rates.data(), step.scene, step.work.guide.data());
  }
  template <class C>
  static void after_step(C& step) {
    if (!step.scene.current.controlled) return;
    control_current(step.on, step.p, step.scene, step.state, step.work.control.data());
  }
};

/// Brings control and guide to the device.
template <int Dim, class Device>
void load_control(Device& on, CurrentWork<Device>& work, const Scene<Dim>& scene, const ParticleSet& from) {
  on.upload(HostBuffer<CurrentControl>{control_of(from, scene.current)}, work.control);
  if (scene.current.guide.on) on.upload(HostBuffer<Guide>{guide_of_run(from, scene.current)}, work.guide);
}

/// Adds them to a checkpoint.
template <int Dim, class Device>
void add_current(Device& on, const CurrentWork<Device>& work, const Scene<Dim>& scene, ParticleSet& to) {
  add_control(on.read(work.control.data()), to);
  if (!scene.current.guide.on) return;
  const Guide guide = on.read(work.guide.data());
  to.facts[guide_fact] = {guide.friction, guide.scale, guide.rate, guide.next};
}

/// Adds velocity and drive of the current to the sums over the fluid.
template <int Dim, class Device>
void add_current_sums(Device& on, const Particles<Device>& p, const Scene<Dim>& scene, const CurrentWork<Device>& work,
                      Totals& totals) {
  if (!scene.current.on) return;
  const WaterMotion sum =
      on.reduce(p.fluid(), WaterMotion{}, WaterMotionPass{p.record.data(), p.mass.data(), scene.current.component},
                [] HOST_DEVICE(WaterMotion a, const WaterMotion& b) { return a += b; });
  totals.bulk_velocity = sum.mass > 0 ? sum.momentum / sum.mass : 0;
  totals.drive = on.read(work.control.data()).acceleration;
}

}  // namespace thalweg
