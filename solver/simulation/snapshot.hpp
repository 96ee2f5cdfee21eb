#pragma once

#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "common/particles.hpp"
#include "solver/backend/device.hpp"
#include "solver/models/all.hpp"

// Snapshots. The device gathers what they show in arrays of their own, so that steps can go on while those are brought
// to the host and made into a ParticleSet.
namespace thalweg {

/// The numbers that a snapshot shows of every particle; models show more (Arrays::describe, `shown`).
struct SnapshotParticle {
  double x[3];  // [m]
  std::int64_t id;
  float velocity[3];  // [m/s]
  float mass;         // [kg]
  float excess;       // rho/rho0 - 1 [-]; 0 of walls
  float pressure;     // [Pa]
  float viscosity;    // [Pa s]
  float kind;         // kind::water …
  std::uint8_t type;
};

/// Particle pass: gathers the particles named in `of`, or all.
struct SnapshotGather {
  using reads = Reads<field::place, field::flow, field::matter, field::position, field::id, field::mass, field::type>;
  using writes = Writes<>;

  const Record* records;
  const Position* positions;
  const std::int64_t* id;
  const float* mass;
  const std::uint8_t* type;
  const Index* of;  // nullptr: 0, 1, 2 …
  SnapshotParticle* to;

  HOST_DEVICE void operator()(Index n) const {
    const Index i = of == nullptr ? n : of[n];
    const Record& r = records[i];
    SnapshotParticle s{};
    for (int c = 0; c < 3; ++c) s.x[c] = positions[i].x[c], s.velocity[c] = r.velocity[c];
    s.id = id[i];
    s.mass = mass[i];
    s.excess = is_wall(r) ? 0 : r.excess;
    s.pressure = r.pressure;
    s.viscosity = r.viscosity;
    s.kind = r.kind;
    s.type = type[i];
    to[n] = s;
  }
};

/// Particle pass: adds to the velocities shown the drift of bed load over the skeleton.
struct DriftGather {
  using reads = Reads<field::drift>;
  using writes = Writes<>;

  const Drift* drift;
  const Index* of;    // nullptr: 0, 1, 2 …
  Index fluid_count;  // walls do not drift
  SnapshotParticle* to;

  HOST_DEVICE void operator()(Index n) const {
    const Index i = of == nullptr ? n : of[n];
    if (i >= fluid_count) return;
    for (int c = 0; c < 3; ++c) to[n].velocity[c] += drift[i].velocity[c];
  }
};

/// Particle pass: gathers one number of an array of numbers or of structs.
template <class T, class Member>
struct ColumnGather {
  using reads = Reads<field::any>;
  using writes = Writes<>;

  const T* from;
  Member member;    // nullptr: the number itself
  const Index* of;  // nullptr: 0, 1, 2 …
  Index known;      // particles from here on are shown as `otherwise`
  float otherwise;
  float* to;

  HOST_DEVICE void operator()(Index n) const {
    const Index i = of == nullptr ? n : of[n];
    if (i >= known) {
      to[n] = otherwise;
    } else if constexpr (std::is_same_v<Member, std::nullptr_t>) {
      to[n] = static_cast<float>(from[i]);
    } else {
      to[n] = from[i].*member;
    }
  }
};

/// A snapshot on the device.
template <class Device>
struct SnapshotArrays {
  template <class T>
  using Buffer = typename Device::template Buffer<T>;
  struct Column {
    std::string name;
    float unit;
    Buffer<float> values;
  };
  struct KindColumn {
    std::string name;
    float (*of)(float);
  };

  Buffer<SnapshotParticle> particles;
  std::vector<Column> columns;
  std::vector<KindColumn> kind_columns;
};

/// Visitor of particle arrays: gathers what models show of n particles, those named in `of` or all.
template <class Device>
struct GatherShown {
  Device& on;
  SnapshotArrays<Device>& into;
  const Index* of;
  Index n;
  Index fluid_count;

  template <class Buffer, class T>
  void array(const Field&, Buffer&, ArrayTraits, const T&) {}

  template <class Buffer>
  void shown(const char* name, const Buffer& buffer) {
    gather(name, buffer, nullptr, {});
  }
  template <class Buffer, class Member>
  void shown(const char* name, const Buffer& buffer, Member member, const ShownAs& as = {}) {
    gather(name, buffer, member, as);
  }
  void shown_kind(const char* name, float (*number_of)(float)) { into.kind_columns.push_back({name, number_of}); }

 private:
  template <class Buffer, class Member>
  void gather(const char* name, const Buffer& buffer, Member member, const ShownAs& as) {
    using T = std::remove_cvref_t<decltype(*buffer.data())>;
    auto& column = into.columns.emplace_back();
    column.name = name;
    column.unit = as.unit;
    column.values.resize(n);
    const auto size = static_cast<Index>(buffer.size());
    const Index known = as.fluid_only && size > fluid_count ? fluid_count : size;
    on.for_each(n, ColumnGather<T, Member>{buffer.data(), member, of, known, as.otherwise, column.values.data()});
  }
};

/// Gathers a snapshot of n particles, those named in `of` (on the device) or, with nullptr, the first n.
template <int Dim, class Device>
void gather_snapshot(Device& on, Particles<Device>& p, const Scene<Dim>& scene, const Index* of, Index n,
                     SnapshotArrays<Device>& into) {
  into.particles.resize(n);
  on.for_each(n, SnapshotGather{p.record.data(), p.position.data(), p.id.data(), p.mass.data(), p.type.data(), of,
                                into.particles.data()});
  if (scene.has_drift) on.for_each(n, DriftGather{p.drift.data(), of, p.fluid_count, into.particles.data()});
  GatherShown<Device> gather{on, into, of, n, p.fluid_count};
  p.describe(scene, gather);
}

/// The state that files show of a kind of sediment: at rest it is a deposit.
inline SedimentState state_in_files(float kind) {
  if (!(kind > 0)) return SedimentState::none;
  return static_cast<SedimentState>(static_cast<int>(kind == kind::resting ? kind::deposit : kind));
}

/// The particles as files hold them; without ParticleSet::info. `download` brings a buffer to the host.
template <int Dim, class Device, class Download>
ParticleSet particle_set(const Scene<Dim>& scene, const SnapshotArrays<Device>& arrays, const Download& download) {
  const auto& particles = download(arrays.particles);
  const std::size_t n = particles.size();
  ParticleSet out;
  for (const SnapshotParticle& s : particles) {
    out.id.push_back(s.id);
    out.mass.push_back(s.mass);
    out.type.push_back(static_cast<ParticleType>(s.type));
    out.position.emplace_back(s.x[0], s.x[1], s.x[2]);
    out.velocity.emplace_back(s.velocity[0], s.velocity[1], s.velocity[2]);
    out.density.push_back(density_in_files(scene, s.kind) * (1 + s.excess));
    out.pressure.push_back(s.pressure);
  }
  for (const auto& column : arrays.columns) {
    const auto& values = download(column.values);
    auto& named = out.scalars[column.name];
    named.assign(values.begin(), values.end());
    for (float& value : named) value /= column.unit;
  }
  for (const auto& column : arrays.kind_columns) {
    auto& named = out.scalars[column.name];
    for (const SnapshotParticle& s : particles) named.push_back(column.of(s.kind));
  }
  if (!scene.has_sediment) return out;
  out.viscosity.assign(n, scene.water_viscosity);
  for (std::size_t i = 0; i < n; ++i) {
    if (particles[i].kind > 0) out.viscosity[i] = particles[i].viscosity;
  }
  if (!scene.has_states) return out;
  for (const SnapshotParticle& s : particles) out.state.push_back(state_in_files(s.kind));
  return out;
}

/// A box, for the device; its sides may be infinite [m].
struct SnapshotRegion {
  double from[3];
  double to[3];

  [[nodiscard]] HOST_DEVICE bool contains(const Position& at) const {
    for (int c = 0; c < 3; ++c) {
      if (!(at.x[c] >= from[c] && at.x[c] <= to[c])) return false;
    }
    return true;
  }
};

/// True for particles within any of the regions.
struct WithinRegions {
  using reads = Reads<field::position>;
  using writes = Writes<>;

  const Position* positions;
  const SnapshotRegion* regions;
  std::size_t number;

  HOST_DEVICE bool operator()(Index i) const {
    bool within = false;
    for (std::size_t k = 0; k < number; ++k) within = within || regions[k].contains(positions[i]);
    return within;
  }
};

}  // namespace thalweg
