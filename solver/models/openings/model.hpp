#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "common/error.hpp"
#include "solver/backend/buffer.hpp"
#include "solver/models/openings/feed.hpp"
#include "solver/models/openings/flow.hpp"
#include "solver/models/openings/openings.hpp"
#include "solver/models/openings/scene.hpp"
#include "solver/models/surface_bed/surface_bed.hpp"

namespace thalweg {

struct SceneSource;

/// The openings on the host, and their state on the device.
template <class Device>
struct OpeningsWork {
  template <class T>
  using Buffer = typename Device::template Buffer<T>;

  std::shared_ptr<Openings> openings;  // null without any
  Buffer<Zone> zones;
  Buffer<double> levels;  // [m]
  Buffer<double> takes;   // [m^3/s] that pumps take (2-D: [m^2/s])
  Buffer<BesideOpening> beside;
  Buffer<float> speeds;  // [m/s] of the inlets' columns
  Buffer<double> feeds;  // [m/s] of the inlets' bed load
};

/// Time in the tables of the openings [s]: the bed's, where it has one of its own.
template <class Workspace>
double time_of_openings(const Workspace& work) {
  return work.surface_bed ? work.surface_bed->bed_time() : work.time;
}

/// Tells the inlets what the bed feels in front of them.
template <class Workspace>
void tell_bed_stress(Workspace& work) {
  if (!work.surface_bed) return;
  const std::vector<Zone>& zones = work.openings->zones();
  for (std::size_t n = 0; n < zones.size() && zones[n].enters; ++n) {
    work.openings->set_bed_stress(n, work.surface_bed->stress_at_inlet(n));
  }
}

template <class Device>
void upload_openings(Device& on, OpeningsWork<Device>& work) {
  const Openings& openings = *work.openings;
  on.upload(HostBuffer<double>(openings.levels().begin(), openings.levels().end()), work.levels);
  on.upload(HostBuffer<double>(openings.takes().begin(), openings.takes().end()), work.takes);
  on.upload(HostBuffer<double>(openings.feeds().begin(), openings.feeds().end()), work.feeds);
  on.upload(HostBuffer<float>(openings.speeds().begin(), openings.speeds().end()), work.speeds);
}

/// The water next to the opening `n`.
template <int Dim, class Device>
WaterBesidePass<Dim> water_beside(const Particles<Device>& p, const Scene<Dim>& scene, const OpeningsWork<Device>& work,
                                  std::size_t n, bool in_section) {
  return {p.record.data(), p.position.data(), p.mass.data(), p.roles(), work.zones.data() + n, in_section, scene};
}

/// True if the zone follows the water next to it.
inline bool uses_water_beside(const Zone& zone) { return zone.enters ? zone.is_full : !zone.falls; }

/// Bed load behind an inlet's plane [m^2/s].
template <int Dim, class Device>
double bed_load_beside(Device& on, const Particles<Device>& p, const Scene<Dim>& scene,
                       const OpeningsWork<Device>& work, std::size_t n, FluidCount all) {
  const double grains = double(scene.bed_load.layer) / scene.spacing;
  return on.reduce(all, 0.0,
                   BedLoadBesidePass<Dim>{p.record.data(), p.position.data(), p.roles(), p.drift.data(),
                                          work.zones.data() + n, grains},
                   [] HOST_DEVICE(double a, double b) { return a + b; });
}

/// The water next to each opening; none at those that do not stand upright. all: p.fluid(), or all particles where they
/// are not in order yet.
template <int Dim, class Device>
std::vector<WaterAtOpening> waters_at_openings(Device& on, const Particles<Device>& p, const Scene<Dim>& scene,
                                               const OpeningsWork<Device>& work, FluidCount all) {
  const std::vector<Zone>& zones = work.openings->zones();
  std::vector<WaterAtOpening> waters(zones.size());
  for (std::size_t n = 0; n < zones.size(); ++n) {
    if (!zones[n].upright) continue;
    const WaterBeside sum = on.reduce(all, WaterBeside{}, water_beside(p, scene, work, n, false),
                                      [] HOST_DEVICE(WaterBeside a, const WaterBeside& b) { return a += b; });
    waters[n].depth = sum.volume / (zones[n].length * 2 * zones[n].half_across);
    if (zones[n].feeds) waters[n].bed_load = bed_load_beside(on, p, scene, work, n, all);
    const double weight = -double(scene.water_density) * double(scene.gravity[Dim - 1]);
    waters[n].level = zones[n].at[2] + (sum.volume > 0 ? sum.pressure / sum.volume / weight : 0);
  }
  return waters;
}

/// Mass of the grains that water takes with it where it leaves [kg].
template <int Dim, class Device>
double grains_leaving(Device& on, const Particles<Device>& p, const Scene<Dim>& scene, const LeavesThrough& leaving) {
  if (!scene.suspended_load.on) return 0;
  const double volume = on.reduce(p.fluid(), 0.0, GrainsLeaving{p.grains.data(), leaving},
                                  [] HOST_DEVICE(double a, double b) { return a + b; });
  return volume * double(scene.erosion.grain_density);
}

/// Water that enters and leaves: [[inlet]], [[outlet]].
struct OpeningsModel {
  template <int Dim>
  using Parameters = OpeningsScene<Dim>;
  template <class Device>
  using Work = OpeningsWork<Device>;
  static constexpr const char* heading = "open_boundaries";

  /// Fills the model's members of the scene (make.cpp).
  template <int Dim>
  static void make(const SceneSource& from, Scene<Dim>& scene);

  template <class Scene>
  static constexpr bool is_on(const Scene& scene) {
    return scene.has_openings;
  }
  /// The host hands over levels and speeds.
  template <class Scene>
  static bool varies(const Scene&) {
    return true;
  }

  /// Those who enter are let in with the new lists, and those who have left go.
  template <class Device, class Scene, class Workspace>
  static void before_lists(Device& on, Particles<Device>& p, const Scene& scene, Workspace& work) {
    Openings& openings = *work.openings;
    tell_bed_stress(work);
    openings.fill(time_of_openings(work), waters_at_openings(on, p, scene, work, p.fluid()), work.population);
    upload_openings(on, work);
    for (std::size_t n = 0; n < openings.zones().size(); ++n) {
      const double grains = grains_leaving(on, p, scene, leaving(p, work, n, false));
      const double water = leave(on, p, work, leaving(p, work, n, false));
      openings.count_out(n, water, scene.has_sediment ? leave(on, p, work, leaving(p, work, n, true)) : 0, grains);
    }
  }

  template <class C>
  static void at_start(C& step) {
    auto& work = step.work;
    auto& p = step.p;
    tell_bed_stress(work);
    if (work.openings->set_time(time_of_openings(work))) upload_openings(step.on, work);
    step.on.for_each(p.fluid_count,
                     PrescribePass<C::dimension>{p.record.data(), p.position.data(), p.role.data(), work.zones.data(),
                                                 work.levels.data(), work.beside.data(), work.speeds.data(),
                                                 static_cast<Index>(work.zones.size()), step.scene});
    if (!brings_bed_load(*work.openings)) return;
    step.on.for_each(p.fluid_count, PrescribeFeedPass<C::dimension>{
                                        p.record.data(), p.position.data(), p.role.data(), p.drift.data(),
                                        work.zones.data(), work.levels.data(), work.beside.data(), work.feeds.data(),
                                        static_cast<Index>(work.feeds.size()), step.scene});
  }

  template <class C>
  static void before_motion(C& step) {
    if (!brings_bed_load(*step.work.openings)) return;
    step.on.for_each(step.p.fluid_count, HoldFeedPass{step.p.record.data(), step.p.role.data()});
  }

  template <class C>
  static void after_step(C& step) {
    const double sound_time = step.scene.smoothing_length / double(step.scene.sound_speed);
    const StepState* state = step.state;
    const std::vector<Zone>& zones = step.work.openings->zones();
    for (std::size_t n = 0; n < zones.size(); ++n) {
      if (!uses_water_beside(zones[n])) continue;
      BesideOpening* beside = step.work.beside.data() + n;
      const double* takes = step.work.takes.data() + n;
      const double* level = step.work.levels.data() + n;
      const Zone zone = zones[n];
      const double gravity = -double(step.scene.gravity[C::dimension - 1]);
      step.on.reduce_then(
          step.p.fluid(), WaterBeside{}, water_beside(step.p, step.scene, step.work, n, true),
          [] HOST_DEVICE(WaterBeside a, const WaterBeside& b) { return a += b; },
          [=] HOST_DEVICE(const WaterBeside& sum) {
            *beside =
                thalweg::after_step(*beside, sum, state->step.dt, sound_time, zone, *takes,
                                    zone.pumps || zone.enters ? 0 : *level - (zone.at[2] - zone.half_up), gravity);
          });
    }
  }

  template <class C>
  static void after_reading(C& step) {
    step.work.openings->advance(step.now.step.dt, step.work.population);
  }

 private:
  static bool brings_bed_load(const Openings& openings) {
    const std::vector<Zone>& zones = openings.zones();
    return std::any_of(zones.begin(), zones.end(), [](const Zone& zone) { return zone.feeds; });
  }
  template <class Device>
  static LeavesThrough leaving(Particles<Device>& p, const OpeningsWork<Device>& work, std::size_t n, bool sediment) {
    return {p.record.data(), p.position.data(), p.role.data(), work.zones.data() + n, work.speeds.data(), sediment};
  }

  /// Lets those who leave die. Returns their mass [kg].
  template <class Device, class Workspace>
  static double leave(Device& on, Particles<Device>& p, Workspace& work, const LeavesThrough& leaving) {
    const double before = work.population.ledger().out;
    work.population.bury(on, p, leaving);
    return work.population.ledger().out - before;
  }
};

/// Numbers of BesideOpening in a checkpoint.
inline constexpr std::size_t numbers_beside = 6;

/// Opens a scene: the particles that inlets hold ready are there from the start, or from a checkpoint on. Throws
/// InputError for a checkpoint of other openings.
template <int Dim, class Device, class Workspace>
void load_openings(Device& on, Particles<Device>& p, const Scene<Dim>& scene, Workspace& work,
                   const std::shared_ptr<Openings>& openings, const ParticleSet& from) {
  work.openings = openings;
  const std::vector<Zone>& zones = openings->zones();
  on.upload(HostBuffer<Zone>(zones.begin(), zones.end()), work.zones);
  HostBuffer<BesideOpening> beside(zones.size());
  Population::open(on, p);
  const auto known = from.facts.find(openings_fact);
  if (known == from.facts.end()) {
    const FluidCount all{p.count};
    for (std::size_t n = 0; n < zones.size(); ++n) {
      const WaterBeside sum = on.reduce(all, WaterBeside{}, water_beside(p, scene, work, n, true),
                                        [] HOST_DEVICE(WaterBeside a, const WaterBeside& b) { return a += b; });
      if (sum.volume > 0) beside[n].pressure = sum.pressure / sum.volume, beside[n].speed = sum.speed / sum.volume;
    }
    const Index before = p.count;
    openings->fill(time_of_openings(work), waters_at_openings(on, p, scene, work, all), work.population);
    work.population.admit(on, p, scene);
    p.fluid_count += p.count - before;
  } else {
    const std::vector<double>& numbers = known->second;
    const std::size_t others = numbers.size() - std::min(numbers.size(), numbers_beside * zones.size());
    const double* next = numbers.data() + others;
    const std::vector<double> of_openings(numbers.data(), next);
    if (!openings->restored(of_openings)) {
      throw InputError("the checkpoint's field data " + std::string(openings_fact) +
                       " is not that of these inlets and outlets; start from a whole checkpoint of the same case");
    }
    for (BesideOpening& water : beside) {
      water = {next[0], next[1], next[2], next[3], next[4], next[5]};
      next += numbers_beside;
    }
    openings->set_time(time_of_openings(work));
  }
  on.upload(std::move(beside), work.beside);
  upload_openings(on, work);
}

/// Adds to a checkpoint what load_openings() needs.
template <class Device>
void add_openings(Device& on, const OpeningsWork<Device>& work, ParticleSet& to) {
  std::vector<double>& numbers = to.facts[openings_fact];
  numbers = work.openings->numbers();
  for (const BesideOpening& water : on.download(work.beside)) {
    numbers.insert(numbers.end(), {water.pressure, water.speed, water.change, water.swell, water.entry, water.share});
  }
}

}  // namespace thalweg
