#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/error.hpp"
#include "solver/models/suspended_load/grain_sums.hpp"
#include "solver/passes/diagnostics.hpp"
#include "solver/simulation/checkpoint.hpp"
#include "solver/simulation/load.hpp"
#include "solver/simulation/memory.hpp"
#include "solver/simulation/neighbour_count.hpp"
#include "solver/simulation/simulation.hpp"
#include "solver/simulation/snapshot.hpp"
#include "solver/step.hpp"

namespace thalweg {

/// The simulation in dimension Dim on a device: particles there, and the step over them. The larger functions are defined
/// behind the class: what stands inside is compiled by all who see it, also where it is declared to be compiled elsewhere.
template <int Dim, Device OnDevice>
class SimulationOn final : public Simulation, public OwnRanges {
 public:
  /// On several ranks `from` are the particles that this one begins with, and `first_block` is the block of sums in which
  /// they do (deal.hpp).
  SimulationOn(OnDevice device, std::string name, const Scene<Dim>& scene, const ParticleSet& from,
               bool profile = false, const std::vector<WallMotion>& motions = {},
               const std::shared_ptr<Openings>& openings = nullptr,
               const std::shared_ptr<SurfaceBed>& surface_bed = nullptr, Ranks* ranks = nullptr,
               std::int64_t first_block = 0, const MessageWish& messages = {});

  void set_time(double time) override { work_.time = time; }
  StepReport advance(double longest) override;
  std::vector<ExcludedParticle> take_excluded() override;
  Totals totals() override;
  MassLedger ledger() const override { return work_.population.ledger(); }
  std::vector<OpeningFlux> openings() const override {
    return work_.openings ? work_.openings->fluxes() : std::vector<OpeningFlux>();
  }
  std::optional<BedReport> bed() const override {
    return work_.surface_bed ? std::make_optional(work_.surface_bed->report()) : std::nullopt;
  }
  double bed_time() const override { return work_.surface_bed ? work_.surface_bed->bed_time() : 0; }
  const Timing& timing() const override { return timing_; }
  Timing& timing() override { return timing_; }
  SimulationFacts facts() override;
  ParticleSet snapshot() override { return begin_snapshot()(); }
  std::function<ParticleSet()> begin_snapshot() override;
  ParticleSet snapshot_within(const std::vector<Eigen::AlignedBox3d>& regions) override;
  ParticleSet full_state() override;
  OwnRanges& own_ranges() override { return *this; }
  Counts counts() override;
  ParticleSet range(FileContents of, std::uint64_t from, std::uint64_t to) override;
  std::map<std::string, std::vector<double>> facts_of(FileContents of) override;

 private:
  using Numbers = typename OnDevice::template Buffer<Index>;
  ParticleSet snapshot_of(const Numbers& chosen);

  /// Number of the particles of a set that are fluid, and stand first; -1 before there is an order. Nothing on one rank.
  [[nodiscard]] std::optional<double> part_of(Index fluid) const {
    if (share_ == nullptr) return std::nullopt;
    return fluid_stands_first_ || p_.has_lists() ? double(fluid) : -1.0;
  }

  OnDevice on_;
  std::unique_ptr<Share<Dim, OnDevice>> share_;  // on several ranks
  std::string name_;
  Scene<Dim> scene_;
  Particles<OnDevice> p_;
  Workspace<OnDevice> work_;
  Timing timing_;
  bool fluid_stands_first_ = false;  // before the walls, in the file
};

template <int Dim, Device OnDevice>
SimulationOn<Dim, OnDevice>::SimulationOn(OnDevice device, std::string name, const Scene<Dim>& scene,
                                          const ParticleSet& from, bool profile, const std::vector<WallMotion>& motions,
                                          const std::shared_ptr<Openings>& openings,
                                          const std::shared_ptr<SurfaceBed>& surface_bed, Ranks* ranks,
                                          std::int64_t first_block, const MessageWish& messages)
    : on_(std::move(device)), name_(std::move(name)), scene_(scene) {
  if (ranks != nullptr) share_ = std::make_unique<Share<Dim, OnDevice>>(*ranks);
  on_.shared = share_.get();
  if (share_ != nullptr) share_->choose_messages(on_, messages);
  if (profile) timing_.wait_with([this] { on_.finish(); });
  if (share_ != nullptr) share_->first_block = first_block;
  load_particles(on_, p_, scene_, from);
  work_.motions = motions;
  work_.time = from.info.time;
  work_.number = from.info.step;
  work_.population = Population::of(from);
  if (scene_.has_moving_walls) load_motions(on_, p_, motions, from);
  if (scene_.suspended_load.on) load_grains(on_, p_, scene_, work_, from);
  if (scene_.wall_stress.on) load_wall_elements(on_, p_, scene_, from);
  if (scene_.surface_bed.on) load_surface_bed(on_, p_, scene_, work_, surface_bed, from);
  if (scene_.mixing_length) bring_eddy_viscosity(on_, p_, scene_);
  if (scene_.may_rest) load_rest(work_, from);
  if (scene_.current.on) load_control(on_, work_, scene_, from);
  if (scene_.has_openings) load_openings(on_, p_, scene_, work_, openings, from);
  const auto listed = from.doubles.find(checkpoint_array::listed_at);
  fluid_stands_first_ = listed != from.doubles.end();
  if (fluid_stands_first_) restore_lists(on_, p_, scene_, listed->second);
  if (share_ == nullptr) return;
  share_->set_beside([this](const Field& field) -> PackedQuad* {
    if (&field != &thalweg::field::viscous_vectors) return nullptr;
    return reinterpret_cast<PackedQuad*>(work_.viscous.vectors.data());
  });
}

template <int Dim, Device OnDevice>
StepReport SimulationOn<Dim, OnDevice>::advance(double longest) {
  StepResult r;
  try {
    r = thalweg::advance(on_, p_, scene_, work_, longest, timing_);
  } catch (const RunError& e) {
    throw RunError(std::string(e.what()) + " (in or shortly before " + std::string(timing_.current()) + ")");
  }
  work_.time += r.step.dt;
  StepReport report;
  report.dt = r.step.dt;
  report.limiter = r.step.limiter;
  report.largest_speed = std::sqrt(double(r.step.extremes.speed2));
  report.fluid = p_.fluid_count;
  report.viscous = r.viscous;
  report.pressure_sweeps = r.pressure_sweeps;
  report.pressure_settled = r.pressure_sweeps < laplace::most_sweeps;
  report.diverged = has_diverged(r);
  report.excluded = std::move(r.excluded);
  return report;
}

template <int Dim, Device OnDevice>
std::vector<ExcludedParticle> SimulationOn<Dim, OnDevice>::take_excluded() {
  if (!neighbours::has_excluded(on_, p_)) return {};
  work_.squared_drift = INFINITY;  // the lists' skin or not
  return refresh_neighbours(on_, p_, scene_, work_);
}

template <int Dim, Device OnDevice>
Totals SimulationOn<Dim, OnDevice>::totals() {
  Totals sums = sum_totals(on_, p_, scene_);
  add_grain_sums(on_, p_, scene_, sums);
  add_current_sums(on_, p_, scene_, work_, sums);
  return sums;
}

template <int Dim, Device OnDevice>
SimulationFacts SimulationOn<Dim, OnDevice>::facts() {
  SimulationFacts f;
  f.particles = p_.count;
  f.fluid_particles = p_.fluid_count;
  f.list_rebuilds = work_.list_rebuilds;
  f.fixed_launches = work_.launches.fixed;
  f.repeated_launches = work_.launches.repeated;
  f.device = name_;
  if (p_.count == 0 && share_ == nullptr) return f;
  const double n = std::max(1.0, double(p_.count));
  f.list_entries_per_particle = double(p_.list_entries.size()) / n;
  f.bytes_per_particle = double(bytes_of(p_, scene_, work_)) / n;
  if (share_ != nullptr) {
    if (!OnDevice::is_host && share_->ranks.size() > 1) f.device += std::string(", ") + share_->way_of_messages();
    f.copies_per_particle = double(share_->copies()) / n;
    f.imbalance = share_->imbalance();
    f.waited = share_->waited();
    f.waited_for_copies = share_->waited_for_copies();
  }
  f.neighbours_mean = mean_neighbours(on_, p_, scene_);
  return f;
}

template <int Dim, Device OnDevice>
std::function<ParticleSet()> SimulationOn<Dim, OnDevice>::begin_snapshot() {
  const auto arrays = std::make_shared<SnapshotArrays<OnDevice>>();
  gather_snapshot(on_, p_, scene_, nullptr, p_.count, *arrays);
  return [arrays, later = on_.async_download(), scene = scene_, part = part_of(p_.fluid_count)] {
    ParticleSet set = particle_set(scene, *arrays, [&](const auto& buffer) { return later.download(buffer); });
    if (part) set.facts[own_fluid_fact] = {*part};
    return set;
  };
}

template <int Dim, Device OnDevice>
ParticleSet SimulationOn<Dim, OnDevice>::snapshot_within(const std::vector<Eigen::AlignedBox3d>& regions) {
  HostBuffer<SnapshotRegion> boxes;
  for (const auto& region : regions) {
    SnapshotRegion& box = boxes.emplace_back();
    for (int c = 0; c < 3; ++c) box.from[c] = region.min()[c], box.to[c] = region.max()[c];
  }
  const std::size_t number = boxes.size();
  typename OnDevice::template Buffer<SnapshotRegion> on_device;
  on_.upload(std::move(boxes), on_device);
  Numbers chosen;
  Selection<OnDevice> selection(on_);
  selection.choose(p_.count, WithinRegions{p_.position.data(), on_device.data(), number}, chosen);
  selection.finish();
  ParticleSet set = snapshot_of(chosen);
  if (share_ != nullptr) {
    const auto indices = on_.download(chosen);
    const auto fluid = std::lower_bound(indices.begin(), indices.end(), p_.fluid_count) - indices.begin();
    set.facts[own_fluid_fact] = {*part_of(static_cast<Index>(fluid))};
  }
  return set;
}

template <int Dim, Device OnDevice>
ParticleSet SimulationOn<Dim, OnDevice>::snapshot_of(const Numbers& chosen) {
  SnapshotArrays<OnDevice> arrays;
  gather_snapshot(on_, p_, scene_, chosen.data(), static_cast<Index>(chosen.size()), arrays);
  return particle_set(scene_, arrays, [&](const auto& buffer) { return on_.download(buffer); });
}

template <int Dim, Device OnDevice>
OwnRanges::Counts SimulationOn<Dim, OnDevice>::counts() {
  constexpr Index at_once = 1 << 16;
  Counts own{p_.count, p_.count, 0};
  if (fluid_stands_first_ || p_.has_lists()) own.fluid = p_.fluid_count;
  for (Index from = 0; from < p_.count; from += at_once) {
    for (const Position& at : on_.download(p_.position, from, std::min<Index>(from + at_once, p_.count))) {
      for (const double coordinate : at.x) own.farthest = std::max(own.farthest, std::abs(coordinate));
    }
  }
  return own;
}

template <int Dim, Device OnDevice>
ParticleSet SimulationOn<Dim, OnDevice>::range(FileContents of, std::uint64_t from, std::uint64_t to) {
  HostBuffer<Index> numbers(to - from);
  std::iota(numbers.begin(), numbers.end(), static_cast<Index>(from));
  Numbers chosen;
  on_.upload(std::move(numbers), chosen);
  ParticleSet set = snapshot_of(chosen);
  if (of == FileContents::full_state) add_full_state(on_, p_, scene_, from, to, set);
  return set;
}

template <int Dim, Device OnDevice>
std::map<std::string, std::vector<double>> SimulationOn<Dim, OnDevice>::facts_of(FileContents of) {
  if (of == FileContents::snapshot) return {};
  ParticleSet out;
  work_.population.add_to(out);
  if (scene_.may_rest) add_rest(work_, out);
  if (scene_.current.on) add_current(on_, work_, scene_, out);
  if (scene_.has_openings) add_openings(on_, work_, out);
  if (scene_.surface_bed.on) add_surface_bed(on_, work_, out);
  return std::move(out.facts);
}

template <int Dim, Device OnDevice>
ParticleSet SimulationOn<Dim, OnDevice>::full_state() {
  ParticleSet out = snapshot();
  add_full_state(on_, p_, scene_, 0, p_.count, out);
  out.facts.merge(facts_of(FileContents::full_state));
  return out;
}

}  // namespace thalweg
