#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "common/particles.hpp"
#include "solver/backend/buffer.hpp"
#include "solver/models/surface_bed/arrays.hpp"
#include "solver/models/surface_bed/passes.hpp"
#include "solver/models/surface_bed/scene.hpp"
#include "solver/models/surface_bed/surface_bed.hpp"

namespace thalweg {

struct SceneSource;

/// The bed on the host, and its columns on the device.
template <class Device>
struct SurfaceBedWork {
  std::shared_ptr<SurfaceBed> surface_bed;  // null without one
  typename Device::template Buffer<BedColumn> bed_columns;
  typename Device::template Buffer<ColumnShear> bed_sums;
  typename Device::template Buffer<double> bed_lifted;  // [m^dim] grains of each column that the water took
  // On several ranks: the two as all ranks knew them last.
  typename Device::template Buffer<ColumnShear> shared_bed_sums;
  typename Device::template Buffer<double> shared_bed_lifted;
  double dt_of_bed = 0;    // [s] of the step under way
  bool bed_moved = false;  // since the lists were made, to a place where it stays
};

template <class Device>
void upload_bed_columns(Device& on, SurfaceBedWork<Device>& work) {
  const std::vector<BedColumn>& columns = work.surface_bed->columns();
  on.upload(HostBuffer<BedColumn>(columns.begin(), columns.end()), work.bed_columns);
}

/// Gives the columns their sums, on every rank those of all.
template <class Device>
void set_bed_sums(Device& on, SurfaceBedWork<Device>& work, const HostBuffer<ColumnShear>& sums,
                  const HostBuffer<double>& lifted) {
  on.upload(HostBuffer<ColumnShear>(sums), work.bed_sums);
  on.upload(HostBuffer<double>(lifted), work.bed_lifted);
  on.upload(HostBuffer<ColumnShear>(sums), work.shared_bed_sums);
  on.upload(HostBuffer<double>(lifted), work.shared_bed_lifted);
}

template <class Device>
void clear_bed_sums(Device& on, SurfaceBedWork<Device>& work) {
  const std::size_t n = work.surface_bed->columns().size();
  set_bed_sums(on, work, HostBuffer<ColumnShear>(n, ColumnShear{}), HostBuffer<double>(n, 0.0));
}

/// Tells all ranks the sums. Between lists the surface of a column lies on one rank, which alone adds to them.
template <class Device>
void share_bed_sums(Device& on, SurfaceBedWork<Device>& work) {
  on.share_changes(work.bed_sums, work.shared_bed_sums);
  on.share_changes(work.bed_lifted, work.shared_bed_lifted);
}

/// The bed's particles stand where the surface is after a share [-] of its way, and move at the rate [1/s] of that share.
template <int Dim, class Device, class Workspace>
void put_bed(Device& on, Particles<Device>& p, const Scene<Dim>& scene, Workspace& work, double share, double rate) {
  const auto volume = static_cast<float>(std::pow(scene.spacing, Dim));
  on.for_each(p.count - p.fluid_count,
              MoveBedPass<Dim>{p.record.data(), p.position.data(), p.mass.data(), p.type.data(), p.bed_place.data(),
                               work.bed_columns.data(), share, rate, scene, volume, p.fluid_count});
  p.walls_sorted = false;
}

template <int Dim, class Device, class Workspace>
void find_bed_elements(Device& on, Particles<Device>& p, const Scene<Dim>& scene, Workspace& work) {
  WallNormal* normals = scene.has_moving_walls ? p.wall_normal.data() : nullptr;
  on.for_each(p.count - p.fluid_count,
              BedElementsPass<Dim>{p.position.data(), p.bed_place.data(), work.bed_columns.data(),
                                   p.wall_element.data(), normals, p.bed_shear.data(), scene, p.fluid_count});
}

/// A bed that is a surface under water: model.sediment = "surface". Its particles are walls. The water's shear stress on
/// them is gathered in windows of time; between windows the host moves the columns of grains (physics/bed), and the
/// walls follow.
struct SurfaceBedModel {
  template <int Dim>
  using Parameters = SurfaceBedScene<Dim>;
  template <class Device>
  using Arrays = SurfaceBedArrays<Device>;
  template <class Device>
  using Work = SurfaceBedWork<Device>;
  static constexpr const char* heading = "move_surface_bed";

  /// Fills the model's members of the scene (make.cpp).
  template <int Dim>
  static void make(const SceneSource& from, Scene<Dim>& scene);

  template <class Scene>
  static constexpr bool is_on(const Scene& scene) {
    return scene.surface_bed.on;
  }
  /// The host hands over how far the surface has moved.
  template <class Scene>
  static bool varies(const Scene&) {
    return true;
  }

  template <class Device, class Scene, class Workspace>
  static void before_lists(Device& on, Particles<Device>&, const Scene&, Workspace& work) {
    share_bed_sums(on, work);
  }
  template <class C>
  static bool lists_due(C& step) {
    return step.work.new_lists;
  }
  /// Walls out of reach of the water are not swept: nothing drags them.
  template <class C>
  static void at_lists(C& step) {
    step.on.fill(step.p.wall_shear, step.p.count, WallShear{});
    step.work.bed_moved = false;
  }
  template <class C>
  static void at_start(C& step) {
    const SurfaceBed& bed = *step.work.surface_bed;
    if (!bed.is_moving()) return;
    put_bed(step.on, step.p, step.scene, step.work, bed.share_at(step.work.time), bed.rate_at(step.work.time));
  }
  template <class C>
  static void before_motion(C& step) {
    if (step.work.surface_bed->is_moving()) step.work.dt_of_bed = step.on.read(&step.state->step.dt);
  }
  template <class C>
  static void at_half_way(C& step) {
    move(step, 0.5);
  }
  template <class C>
  static void at_arrival(C& step) {
    move(step, 1);
  }
  template <class C>
  static void after_step(C& step) {
    auto& p = step.p;
    if (step.work.surface_bed->is_moving()) return;
    step.on.for_each(p.count - p.fluid_count,
                     SumShearPass{p.bed_place.data(), p.wall_element.data(), p.wall_shear.data(),
                                  step.work.bed_sums.data(), step.state, p.fluid_count});
  }
  template <class C>
  static void after_reading(C& step) {
    SurfaceBed& bed = *step.work.surface_bed;
    const double time = step.work.time + step.now.step.dt;
    if (time < bed.due()) return;
    share_bed_sums(step.on, step.work);
    const auto lifted = step.on.download(step.work.bed_lifted);
    bed.lift({lifted.begin(), lifted.end()});
    if (bed.is_moving()) {
      bed.arrive(time);
      upload_bed_columns(step.on, step.work);
      put_bed(step.on, step.p, step.scene, step.work, 1, 0);
      find_bed_elements(step.on, step.p, step.scene, step.work);
      step.now.squared_drift = INFINITY;  // lists, and the distances found with them, are of the bed before
      step.work.bed_moved = true;
    } else {
      const auto sums = step.on.download(step.work.bed_sums);
      bed.take({sums.begin(), sums.end()}, time);
      upload_bed_columns(step.on, step.work);
      if (!bed.is_moving()) find_bed_elements(step.on, step.p, step.scene, step.work);
    }
    clear_bed_sums(step.on, step.work);
  }

 private:
  template <class C>
  static void move(C& step, double part) {
    const SurfaceBed& bed = *step.work.surface_bed;
    if (!bed.is_moving()) return;
    const double dt = step.work.dt_of_bed;
    const double from = bed.share_at(step.work.time);
    const double way = bed.share_at(step.work.time + dt) - from;
    put_bed(step.on, step.p, step.scene, step.work, from + part * way, way / dt);
  }
};

/// Lays the bed: its columns on the device, and its particles where they belong.
template <int Dim, class Device, class Workspace>
void load_surface_bed(Device& on, Particles<Device>& p, const Scene<Dim>& scene, Workspace& work,
                      const std::shared_ptr<SurfaceBed>& bed, const ParticleSet& from) {
  work.surface_bed = bed;
  HostBuffer<ColumnShear> sums(bed->columns().size(), ColumnShear{});
  HostBuffer<double> lifted(bed->columns().size(), 0.0);
  const auto known = from.facts.find(surface_bed_fact);
  const bool is_new = known == from.facts.end();
  if (!is_new) {
    const double* last = known->second.data() + known->second.size() - numbers_of_sums * sums.size() - 1;
    if (known->second.back() != 0) work.squared_drift = INFINITY;
    for (std::size_t c = 0; c < sums.size(); ++c, last += numbers_of_sums) {
      sums[c] = {last[0], last[1], last[2]};
      lifted[c] = last[3];
    }
  }
  set_bed_sums(on, work, sums, lifted);
  upload_bed_columns(on, work);
  if (is_new) {
    BedPlace* places = p.bed_place.data();
    const WallElement* elements = p.wall_element.data();
    on.for_each(p.count, declare<Reads<field::wall_element>, Writes<field::bed_place>>(
                             [=] HOST_DEVICE(Index i) { places[i].area = elements[i].area; }));
    // Particles lie as files bring them, fluid and walls mixed, until the first lists.
    const Index fluid = p.fluid_count;
    p.fluid_count = 0;
    find_bed_elements(on, p, scene, work);
    put_bed(on, p, scene, work, 1, 0);
    p.fluid_count = fluid;
    return;
  }
  on.for_each(p.count, BuriedRowsPass{p.record.data(), p.type.data(), p.bed_place.data()});
}

/// Adds to a checkpoint what load_surface_bed() needs.
template <class Device>
void add_surface_bed(Device& on, SurfaceBedWork<Device>& work, ParticleSet& to) {
  share_bed_sums(on, work);
  std::vector<double>& numbers = to.facts[surface_bed_fact];
  numbers = work.surface_bed->numbers();
  const auto sums = on.download(work.bed_sums);
  const auto lifted = on.download(work.bed_lifted);
  for (std::size_t c = 0; c < sums.size(); ++c) {
    numbers.insert(numbers.end(), {sums[c].x, sums[c].y, sums[c].time, lifted[c]});
  }
  numbers.push_back(work.bed_moved ? 1 : 0);
}

}  // namespace thalweg
