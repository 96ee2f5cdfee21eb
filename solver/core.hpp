#pragma once

#include <algorithm>
#include <bit>
#include <string>
#include <utility>

#include "solver/simulation.hpp"

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
inline constexpr const char* excess_pore_pressure_array = "ExcessPorePressure";

/// The numbers of structs of floats, and back; a checkpoint keeps them exactly.
template <class Struct>
std::vector<double> numbers_of(const Struct* from, std::size_t n) {
  static_assert(sizeof(Struct) % sizeof(float) == 0);
  const auto* numbers = reinterpret_cast<const float*>(from);
  return {numbers, numbers + n * (sizeof(Struct) / sizeof(float))};
}
template <class Struct>
void take_numbers(const ParticleSet& from, const char* name, Struct* to, std::size_t n) {
  const auto found = from.doubles.find(name);
  if (found == from.doubles.end()) return;
  auto* numbers = reinterpret_cast<float*>(to);
  for (std::size_t i = 0; i < n * (sizeof(Struct) / sizeof(float)); ++i) {
    numbers[i] = static_cast<float>(found->second[i]);
  }
}

/// What scenes with moving walls keep of them. Where a file does not say where walls started, they are moved back
/// there.
template <class Device>
void load_motions(Particles<Device>& p, const std::vector<WallMotion>& motions, const ParticleSet& from) {
  const std::size_t n = from.size();
  const std::vector<float>& number = from.scalars.at(motion_array);
  p.motion.assign(number.begin(), number.end());
  p.moved_from.resize(n);
  const auto known = from.doubles.find(checkpoint_array::moved_from);
  for (std::size_t i = 0; i < n; ++i) {
    const Position now{{from.position[i][0], from.position[i][1], from.position[i][2]}};
    Position& start = p.moved_from[i];
    if (known != from.doubles.end()) {
      for (std::size_t c = 0; c < 3; ++c) start.x[c] = known->second[3 * i + c];
    } else if (p.motion[i] == 0) {
      start = now;
    } else {
      const WallMotion& motion = motions[p.motion[i] - 1];
      moved_point(motion.axis, -motion.at(from.info.time).place, now.x, start.x);
    }
  }
}

/// Brings particles to the device's arrays, fluid and walls mixed as they come; lists are made by the first step.
template <int Dim, class Device>
void load_particles(Particles<Device>& p, const Scene<Dim>& scene, const ParticleSet& from) {
  const auto n = static_cast<Index>(from.size());
  p.count = n;
  p.record.assign(n + std::size_t{1}, Record{});
  p.position.resize(n);
  p.mass.assign(from.mass.begin(), from.mass.end());
  p.id.assign(from.id.begin(), from.id.end());
  p.type.resize(n);
  p.rates.assign(n, Rates{});
  if (scene.has_sediment) p.sediment.assign(n, Sediment{});
  if (scene.seepage.pore_pressure) {
    p.excess_pore_pressure.assign(n, 0);
    const auto known = from.scalars.find(excess_pore_pressure_array);
    if (known != from.scalars.end()) p.excess_pore_pressure.assign(known->second.begin(), known->second.end());
  }
  const auto exact_excess = from.scalars.find(checkpoint_array::excess);
  const auto states = from.scalars.find(checkpoint_array::state);
  if (scene.has_sediment) take_numbers(from, checkpoint_array::sediment, p.sediment.data(), n);
  if (scene.has_states) {
    p.bed.assign(n, BedSurface{});
    take_numbers(from, checkpoint_array::bed, p.bed.data(), n);
  }
  Index fluid = 0;
  for (Index i = 0; i < n; ++i) {
    Record& r = p.record[i];
    const auto type = from.type[i];
    p.type[i] = static_cast<std::uint8_t>(type);
    r.phase = type == ParticleType::sediment ? phase_sediment : type == ParticleType::water ? phase_water : phase_wall;
    for (int c = 0; c < 3; ++c) {
      p.position[i].x[c] = from.position[i][c];
      if (!from.velocity.empty()) r.velocity[c] = from.velocity[i][c];
    }
    for (int k = 0; k < Dim; ++k) {
      const int c = axis<Dim>(k);
      r.place[c] = scene.lattice.place(k, p.position[i].x[c]);
    }
    if (!from.pressure.empty()) r.pressure = from.pressure[i];
    if (r.phase == phase_wall) {
      r.volume = static_cast<float>(std::pow(scene.spacing, Dim));
      if (exact_excess != from.scalars.end()) r.excess = exact_excess->second[i];
      continue;
    }
    ++fluid;
    r.excess = exact_excess != from.scalars.end()
                   ? exact_excess->second[i]
                   : static_cast<float>(double(from.density[i]) / double(scene.density_in_files(r.phase)) - 1);
    r.volume = from.mass[i] / (scene.density_at_rest(r.phase) * (1 + r.excess));  // as the step does
    if (!from.viscosity.empty()) r.viscosity = from.viscosity[i];
    if (r.phase == phase_sediment) r.state = states != from.scalars.end() ? states->second[i] : state_deposit;
    if (!scene.may_rest && is_resting(r)) r.state = state_deposit;
  }
  p.fluid_count = fluid;
}

/// The simulation in dimension Dim on Device: particles on the device and the step over them.
template <int Dim, class Device>
class SimulationOn final : public Simulation {
 public:
  SimulationOn(Device device, std::string name, const Scene<Dim>& scene, const ParticleSet& from,
               const std::vector<WallMotion>& motions = {})
      : on_(std::move(device)), name_(std::move(name)), scene_(scene) {
    load_particles(p_, scene_, from);
    work_.motions = motions;
    work_.time = from.info.time;
    if (scene_.has_moving_walls) load_motions(p_, motions, from);
    const auto listed = from.doubles.find(checkpoint_array::listed_at);
    if (listed != from.doubles.end()) restore_lists(listed->second);
  }

  void set_time(double time) override { work_.time = time; }

  StepReport advance(double longest) override {
    StepResult r = thalweg::advance(on_, p_, scene_, work_, longest, timing_);
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
    return refresh_neighbours(on_, p_, scene_, work_.list_rebuilds);
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
        p_.list_entries.size() * sizeof(Index) + work_.viscous.coefficient.size() * sizeof(float) +
        work_.viscous.row.size() * sizeof(typename ViscousSystem<Device>::Row) +
        work_.mixture.pores.size() * sizeof(PoreState) +
        (p_.excess_pore_pressure.size() + work_.pore_diffusion.loss.size() + work_.pore_diffusion.before.size()) *
            sizeof(float));
    f.bytes_per_particle = bytes / p_.count;
    f.neighbours_mean = mean_neighbours();
    return f;
  }

  ParticleSet snapshot() override {
    ParticleSet out;
    copy_common(out);
    return out;
  }

  ParticleSet full_state() override {
    ParticleSet out;
    copy_common(out);
    auto& excess = out.scalars[checkpoint_array::excess];
    auto& listed = out.doubles[checkpoint_array::listed_at];
    excess.resize(p_.count);
    listed.resize(3 * p_.listed_at.size());
    for (Index i = 0; i < p_.count; ++i) excess[i] = p_.record[i].excess;
    for (std::size_t i = 0; i < p_.listed_at.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) listed[3 * i + c] = p_.listed_at[i].c[c];
    }
    if (scene_.has_moving_walls) {
      auto& start = out.doubles[checkpoint_array::moved_from];
      for (Index i = 0; i < p_.count; ++i) start.insert(start.end(), p_.moved_from[i].x, p_.moved_from[i].x + 3);
    }
    if (scene_.has_sediment) {
      out.doubles[checkpoint_array::sediment] = numbers_of(p_.sediment.data(), p_.count);
      if (scene_.has_states) out.doubles[checkpoint_array::bed] = numbers_of(p_.bed.data(), p_.count);
      auto& state = out.scalars[checkpoint_array::state];
      for (Index i = 0; i < p_.count; ++i) state.push_back(p_.record[i].state);
    }
    return out;
  }

 private:
  /// A checkpoint holds the particles in list order: lists are built for the places they were built for, which makes
  /// the continued run the same, bit for bit, as one that never stopped.
  void restore_lists(const std::vector<double>& listed) {
    p_.listed_at.resize(p_.count);
    std::vector<Place> now(p_.count);
    for (Index i = 0; i < p_.count; ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        now[i].c[c] = p_.record[i].place[c];
        p_.listed_at[i].c[c] = static_cast<std::int32_t>(listed[3 * std::size_t{i} + c]);
        p_.record[i].place[c] = p_.listed_at[i].c[c];
      }
    }
    neighbours::build_lists(on_, p_, scene_);
    if (scene_.may_rest) list_active_clusters(on_, p_);
    for (Index i = 0; i < p_.count; ++i) {
      for (std::size_t c = 0; c < 3; ++c) p_.record[i].place[c] = now[i].c[c];
    }
  }

  void copy_common(ParticleSet& out) {
    const std::size_t n = p_.count;
    out.id.assign(p_.id.begin(), p_.id.end());
    out.mass.assign(p_.mass.begin(), p_.mass.end());
    out.type.resize(n);
    out.position.resize(n);
    out.velocity.resize(n);
    out.density.resize(n);
    out.pressure.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const Record& r = p_.record[i];
      out.type[i] = static_cast<ParticleType>(p_.type[i]);
      out.position[i] = Vec3(p_.position[i].x[0], p_.position[i].x[1], p_.position[i].x[2]);
      out.velocity[i] = Eigen::Vector3f(r.velocity[0], r.velocity[1], r.velocity[2]);
      out.density[i] = scene_.density_in_files(r.phase) * (1 + (r.phase == phase_wall ? 0 : r.excess));
      out.pressure[i] = r.pressure;
    }
    if (!work_.mixture.pores.empty()) {
      auto& porosity = out.scalars["Porosity"];
      for (std::size_t i = 0; i < n; ++i) porosity.push_back(i < p_.fluid_count ? work_.mixture.pores[i].porosity : 1);
    }
    if (scene_.has_moving_walls) out.scalars[motion_array].assign(p_.motion.begin(), p_.motion.end());
    if (scene_.seepage.pore_pressure) {
      out.scalars[excess_pore_pressure_array].assign(p_.excess_pore_pressure.begin(), p_.excess_pore_pressure.end());
    }
    if (!scene_.has_sediment) return;
    auto& strain = out.scalars["StrainRate"];
    auto& effective = out.scalars["EffectivePressure"];
    auto& yield = out.scalars["YieldStress"];
    out.viscosity.assign(n, scene_.water_viscosity);
    strain.resize(n);
    effective.resize(n);
    yield.resize(n);
    std::vector<float>* resting = scene_.may_rest ? &out.scalars["Resting"] : nullptr;
    if (resting != nullptr) resting->assign(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
      if (p_.record[i].phase == phase_sediment) out.viscosity[i] = p_.record[i].viscosity;
      strain[i] = p_.sediment[i].strain_rate;
      effective[i] = p_.sediment[i].effective_pressure;
      yield[i] = p_.sediment[i].yield_stress;
      if (resting != nullptr && is_resting(p_.record[i])) (*resting)[i] = 1;
    }
    if (scene_.has_states) copy_states(out);
  }

  void copy_states(ParticleSet& out) {
    auto& shields = out.scalars["ShieldsNumber"];
    shields.resize(p_.count);
    out.state.resize(p_.count);
    for (Index i = 0; i < p_.count; ++i) {
      const float state = is_resting(p_.record[i]) ? state_deposit : p_.record[i].state;
      out.state[i] = static_cast<SedimentState>(static_cast<int>(state));
      shields[i] = shields_number(p_.bed[i].shear_stress, scene_.erosion.grain_weight);
    }
  }

  /// Particles within the kernel's support of a fluid particle, itself included, averaged over a sample.
  double mean_neighbours() const {
    if (p_.fluid_count == 0 || p_.list_begin.empty()) return 0;
    const ClusterList list = p_.list();
    const double support2 = double(scene_.support()) * double(scene_.support());
    const Index stride = std::max<Index>(1, p_.fluid_clusters / 1000);
    double found = 0, particles = 0;
    for (Index c = 0; c < p_.fluid_clusters; c += stride) {
      for (Index i = list.first(c); i < list.last(c); ++i, ++particles) {
        for (Index e = list.begin[c]; e < list.begin[c + 1]; ++e) {
          if (list.entries[e] == p_.count) continue;
          double r2 = 0;
          for (int k = 0; k < Dim; ++k) {
            const int axis_k = axis<Dim>(k);
            const auto d =
                Lattice<Dim>::difference(p_.record[i].place[axis_k], p_.record[list.entries[e]].place[axis_k]);
            r2 += std::pow(double(d) * double(scene_.lattice.quantum[k]), 2);
          }
          if (r2 < support2) found += 1;
        }
      }
    }
    return found / particles;
  }

  Device on_;
  std::string name_;
  Scene<Dim> scene_;
  Particles<Device> p_;
  Workspace<Device> work_;
  Timing timing_;
};

}  // namespace thalweg
