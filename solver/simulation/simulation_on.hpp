#pragma once

#include <algorithm>
#include <bit>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "common/error.hpp"
#include "solver/backend/buffer.hpp"
#include "solver/simulation/simulation.hpp"
#include "solver/simulation/snapshot.hpp"

namespace thalweg {

/// Names of the arrays that only checkpoints have: the state that a looked-at file would round or leave out.
namespace checkpoint_array {
inline constexpr const char* excess = "Excess";
inline constexpr const char* listed_at = "ListedAt";      // three integers kept as doubles, exact
inline constexpr const char* sediment = "SedimentState";  // structs Sediment and BedSurface, number by number
inline constexpr const char* bed = "BedSurface";
inline constexpr const char* state = "ResolvedState";   // State, and rest
inline constexpr const char* moved_from = "MovedFrom";  // three doubles [m]
}  // namespace checkpoint_array

/// The numbers of structs of floats, and back; a checkpoint keeps them exactly.
template <class Struct>
std::vector<double> numbers_of(const Struct* from, std::size_t n) {
  static_assert(sizeof(Struct) % sizeof(float) == 0);
  const auto* numbers = reinterpret_cast<const float*>(from);
  return {numbers, numbers + n * (sizeof(Struct) / sizeof(float))};
}
template <class Struct>
HostBuffer<Struct> structs_of(const ParticleSet& from, const char* name, std::size_t n) {
  HostBuffer<Struct> structs(n, Struct{});
  const auto found = from.doubles.find(name);
  if (found == from.doubles.end()) return structs;
  auto* numbers = reinterpret_cast<float*>(structs.data());
  for (std::size_t i = 0; i < n * (sizeof(Struct) / sizeof(float)); ++i) {
    numbers[i] = static_cast<float>(found->second[i]);
  }
  return structs;
}

/// A particle as it starts or goes on; walls have the volume of a spacing.
template <int Dim>
Record record_of(const Scene<Dim>& scene, const ParticleSet& from, std::size_t i) {
  Record r{};
  const auto exact_excess = from.scalars.find(checkpoint_array::excess);
  const auto states = from.scalars.find(checkpoint_array::state);
  const auto type = from.type[i];
  r.phase = type == ParticleType::sediment ? phase_sediment : type == ParticleType::water ? phase_water : phase_wall;
  for (int k = 0; k < Dim; ++k) r.place[axis<Dim>(k)] = scene.lattice.place(k, from.position[i][axis<Dim>(k)]);
  if (!from.velocity.empty()) {
    for (int c = 0; c < 3; ++c) r.velocity[c] = from.velocity[i][c];
  }
  if (!from.pressure.empty()) r.pressure = from.pressure[i];
  if (exact_excess != from.scalars.end()) r.excess = exact_excess->second[i];
  if (r.phase == phase_wall) {
    r.volume = static_cast<float>(std::pow(scene.spacing, Dim));
    return r;
  }
  if (exact_excess == from.scalars.end()) {
    r.excess = static_cast<float>(double(from.density[i]) / double(scene.density_in_files(r.phase)) - 1);
  }
  r.volume = from.mass[i] / (scene.density_at_rest(r.phase) * (1 + r.excess));  // as the step does
  if (!from.viscosity.empty()) r.viscosity = from.viscosity[i];
  if (r.phase == phase_sediment) r.state = states != from.scalars.end() ? states->second[i] : state_deposit;
  if (!scene.may_rest && is_resting(r)) r.state = state_deposit;
  return r;
}

/// What scenes with moving walls keep of them. Where a file does not say where walls started, they are moved back
/// there.
template <class Device>
void load_motions(Device& on, Particles<Device>& p, const std::vector<WallMotion>& motions, const ParticleSet& from) {
  const std::size_t n = from.size();
  const std::vector<float>& numbers = from.scalars.at(motion_array);
  HostBuffer<Index> number(n);
  HostBuffer<Position> moved_from(n);
  const auto known = from.doubles.find(checkpoint_array::moved_from);
  for (std::size_t i = 0; i < n; ++i) {
    const Position now{{from.position[i][0], from.position[i][1], from.position[i][2]}};
    Position& start = moved_from[i];
    number[i] = static_cast<Index>(numbers[i]);
    if (known != from.doubles.end()) {
      for (std::size_t c = 0; c < 3; ++c) start.x[c] = known->second[3 * i + c];
    } else if (number[i] == 0) {
      start = now;
    } else {
      const WallMotion& motion = motions[number[i] - 1];
      moved_point(motion.axis, -motion.at(from.info.time).place, now.x, start.x);
    }
  }
  on.put(std::move(number), p.motion);
  on.put(std::move(moved_from), p.moved_from);
}

/// Brings particles to the device's arrays, fluid and walls mixed as they come; lists are made by the first step.
template <int Dim, class Device>
void load_particles(Device& on, Particles<Device>& p, const Scene<Dim>& scene, const ParticleSet& from) {
  const auto n = static_cast<Index>(from.size());
  HostBuffer<Record> record(n + std::size_t{1}, Record{});
  HostBuffer<Position> position(n);
  HostBuffer<std::uint8_t> type(n);
  p.count = n;
  p.fluid_count = 0;
  for (Index i = 0; i < n; ++i) {
    record[i] = record_of(scene, from, i);
    type[i] = static_cast<std::uint8_t>(from.type[i]);
    for (int c = 0; c < 3; ++c) position[i].x[c] = from.position[i][c];
    if (record[i].phase != phase_wall) ++p.fluid_count;
  }
  on.put(std::move(record), p.record);
  on.put(std::move(position), p.position);
  on.put(std::move(type), p.type);
  on.put(HostBuffer<float>(from.mass.begin(), from.mass.end()), p.mass);
  on.put(HostBuffer<std::int64_t>(from.id.begin(), from.id.end()), p.id);
  on.fill(p.rates, n, Rates{});
  if (scene.has_sediment) on.put(structs_of<Sediment>(from, checkpoint_array::sediment, n), p.sediment);
  if (scene.has_states) on.put(structs_of<BedSurface>(from, checkpoint_array::bed, n), p.bed);
  if (!scene.seepage.pore_pressure) return;
  const auto known = from.scalars.find(excess_pore_pressure_array);
  if (known == from.scalars.end()) {
    on.fill(p.excess_pore_pressure, n, 0.0F);
  } else {
    on.put(HostBuffer<float>(known->second.begin(), known->second.end()), p.excess_pore_pressure);
  }
}

/// Exchanges the particles' places for those that the lists are built for.
template <class Device>
void swap_places(Device& on, Particles<Device>& p) {
  Record* records = p.record.data();
  Place* listed = p.listed_at.data();
  on.for_each(p.count, [=] HOST_DEVICE(Index i) {
    for (int c = 0; c < 3; ++c) {
      const std::int32_t place = records[i].place[c];
      records[i].place[c] = listed[i].c[c];
      listed[i].c[c] = place;
    }
  });
}

/// Particles within the kernel's support of a fluid particle, itself included, averaged over a sample.
template <int Dim, class Device>
double mean_neighbours(Device& on, const Particles<Device>& p, const Scene<Dim>& scene) {
  if (p.fluid_count == 0 || p.list_begin.empty()) return 0;
  const ClusterList list = p.list();
  const Record* records = p.record.data();
  const float support2 = scene.support() * scene.support();
  const Index stride = std::max<Index>(1, p.fluid_clusters / 1000);
  const Index samples = (p.fluid_clusters + stride - 1) / stride;
  const auto sum = [] HOST_DEVICE(std::int64_t a, std::int64_t b) { return a + b; };
  const std::int64_t particles = on.reduce(
      samples, std::int64_t{0},
      [=] HOST_DEVICE(Index n) { return std::int64_t{list.last(n * stride)} - list.first(n * stride); }, sum);
  const std::int64_t found = on.reduce(
      samples, std::int64_t{0},
      [=] HOST_DEVICE(Index n) {
        const Index c = n * stride;
        std::int64_t neighbours = 0;
        for (Index i = list.first(c); i < list.last(c); ++i) {
          for (Index e = list.begin[c]; e < list.begin[c + 1]; ++e) {
            const Index j = list.entries[e];
            if (j == list.count) continue;
            float r2 = 0;
            for (int k = 0; k < Dim; ++k) {
              const float d = scene.distance(k, records[i].place[axis<Dim>(k)], records[j].place[axis<Dim>(k)]);
              r2 += d * d;
            }
            if (r2 < support2) ++neighbours;
          }
        }
        return neighbours;
      },
      sum);
  return double(found) / double(particles);
}

/// The simulation in dimension Dim on Device: particles on the device and the step over them.
template <int Dim, class Device>
class SimulationOn final : public Simulation {
 public:
  SimulationOn(Device device, std::string name, const Scene<Dim>& scene, const ParticleSet& from, bool profile = false,
               const std::vector<WallMotion>& motions = {})
      : on_(std::move(device)), name_(std::move(name)), scene_(scene) {
    if (profile) timing_.wait_with([this] { on_.finish(); });
    load_particles(on_, p_, scene_, from);
    work_.motions = motions;
    work_.time = from.info.time;
    if (scene_.has_moving_walls) load_motions(on_, p_, motions, from);
    const auto listed = from.doubles.find(checkpoint_array::listed_at);
    if (listed != from.doubles.end()) restore_lists(listed->second);
  }

  void set_time(double time) override { work_.time = time; }

  StepReport advance(double longest) override {
    StepResult r;
    try {
      r = thalweg::advance(on_, p_, scene_, work_, longest, timing_);
    } catch (const RunError& e) {
      throw RunError(std::string(e.what()) + " (in or shortly before " + timing_.current() + ")");
    }
    work_.time += r.step.dt;
    StepReport report;
    report.dt = r.step.dt;
    report.limiter = r.step.limiter;
    report.largest_speed = std::sqrt(double(r.step.extremes.speed2));
    report.viscous = r.viscous;
    report.pressure_sweeps = r.pressure_sweeps;
    report.diverged = has_diverged(r);
    report.excluded = std::move(r.excluded);
    return report;
  }

  std::vector<ExcludedParticle> take_excluded() override {
    if (!neighbours::has_excluded(on_, p_)) return {};
    work_.squared_drift = INFINITY;  // the lists' skin or not
    return refresh_neighbours(on_, p_, scene_, work_);
  }

  Totals totals() override { return sum_totals(on_, p_, scene_); }
  const Timing& timing() const override { return timing_; }
  Timing& timing() override { return timing_; }

  SimulationFacts facts() override {
    SimulationFacts f;
    f.particles = p_.count;
    f.fluid_particles = p_.fluid_count;
    f.list_rebuilds = work_.list_rebuilds;
    f.device = name_;
    if (p_.count == 0) return f;
    f.list_entries_per_particle = double(p_.list_entries.size()) / p_.count;
    const double bytes = double(
        p_.record.size() * sizeof(Record) + p_.position.size() * sizeof(Position) +
        p_.count * (sizeof(float) + sizeof(std::int64_t) + 1 + sizeof(Rates) + sizeof(Place)) +
        p_.motion.size() * sizeof(Index) + p_.moved_from.size() * sizeof(Position) +
        p_.sediment.size() * sizeof(Sediment) + p_.bed.size() * sizeof(BedSurface) +
        p_.list_entries.size() * sizeof(Index) +
        work_.viscous.coefficient.size() * sizeof(typename Device::PairCoefficient) +
        work_.viscous.vectors.size() * sizeof(Vectors) +
        work_.viscous.row.size() * sizeof(typename ViscousSystem<Device>::Row) +
        work_.mixture.pores.size() * sizeof(PoreState) +
        (p_.excess_pore_pressure.size() + work_.pore_diffusion.loss.size() + work_.pore_diffusion.before.size()) *
            sizeof(float));
    f.bytes_per_particle = bytes / p_.count;
    f.neighbours_mean = mean_neighbours(on_, p_, scene_);
    return f;
  }

  ParticleSet snapshot() override { return begin_snapshot()(); }

  std::function<ParticleSet()> begin_snapshot() override {
    const auto shown = std::make_shared<typename Device::template Buffer<ShownParticle>>();
    shown->resize(p_.count);
    on_.for_each(p_.count, ShowPass{show(), nullptr, shown->data()});
    return [shown, beside = on_.beside(), scene = scene_] { return particle_set(scene, beside.on_host(*shown)); };
  }

  ParticleSet snapshot_within(const std::vector<Eigen::AlignedBox3d>& regions) override {
    HostBuffer<ShownRegion> boxes;
    for (const auto& region : regions) {
      ShownRegion& box = boxes.emplace_back();
      for (int c = 0; c < 3; ++c) box.from[c] = region.min()[c], box.to[c] = region.max()[c];
    }
    const std::size_t number = boxes.size();
    typename Device::template Buffer<ShownRegion> on_device;
    on_.put(std::move(boxes), on_device);
    typename Device::template Buffer<Index> chosen;
    Selection<Device> selection(on_);
    selection.choose(p_.count, WithinRegions{p_.position.data(), on_device.data(), number}, chosen);
    selection.finish();
    typename Device::template Buffer<ShownParticle> shown;
    shown.resize(chosen.size());
    on_.for_each(static_cast<Index>(chosen.size()), ShowPass{show(), chosen.data(), shown.data()});
    return particle_set(scene_, on_.on_host(shown));
  }

  ParticleSet full_state() override {
    ParticleSet out = snapshot();
    const auto records = on_.on_host(p_.record);
    const auto places = on_.on_host(p_.listed_at);
    auto& excess = out.scalars[checkpoint_array::excess];
    auto& listed = out.doubles[checkpoint_array::listed_at];
    excess.resize(p_.count);
    listed.resize(3 * places.size());
    for (Index i = 0; i < p_.count; ++i) excess[i] = records[i].excess;
    for (std::size_t i = 0; i < places.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) listed[3 * i + c] = places[i].c[c];
    }
    if (scene_.has_moving_walls) {
      auto& start = out.doubles[checkpoint_array::moved_from];
      for (const Position& from : on_.on_host(p_.moved_from)) start.insert(start.end(), from.x, from.x + 3);
    }
    if (scene_.has_sediment) {
      out.doubles[checkpoint_array::sediment] = numbers_of(on_.on_host(p_.sediment).data(), p_.count);
      if (scene_.has_states) out.doubles[checkpoint_array::bed] = numbers_of(on_.on_host(p_.bed).data(), p_.count);
      auto& state = out.scalars[checkpoint_array::state];
      for (Index i = 0; i < p_.count; ++i) state.push_back(records[i].state);
    }
    return out;
  }

 private:
  Show show() const {
    const auto data_of = [](const auto& buffer) { return buffer.empty() ? nullptr : buffer.data(); };
    return {p_.record.data(),
            p_.position.data(),
            p_.id.data(),
            p_.mass.data(),
            p_.type.data(),
            data_of(p_.sediment),
            data_of(p_.bed),
            data_of(p_.excess_pore_pressure),
            data_of(work_.mixture.pores),
            data_of(p_.motion),
            p_.fluid_count};
  }

  /// A checkpoint holds the particles in list order: lists are built for the places they were built for, which makes
  /// the continued run the same, bit for bit, as one that never stopped.
  void restore_lists(const std::vector<double>& listed) {
    HostBuffer<Place> places(p_.count);
    for (std::size_t i = 0; i < places.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) places[i].c[c] = static_cast<std::int32_t>(listed[3 * i + c]);
    }
    on_.put(std::move(places), p_.listed_at);
    swap_places(on_, p_);
    neighbours::build_lists(on_, p_, scene_);
    if (scene_.may_rest) list_active_clusters(on_, p_);
    swap_places(on_, p_);
  }

  Device on_;
  std::string name_;
  Scene<Dim> scene_;
  Particles<Device> p_;
  Workspace<Device> work_;
  Timing timing_;
};

}  // namespace thalweg
