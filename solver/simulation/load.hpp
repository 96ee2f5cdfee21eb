#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "common/error.hpp"
#include "common/particles.hpp"
#include "solver/backend/buffer.hpp"
#include "solver/lists/rebuild.hpp"
#include "solver/simulation/checkpoint.hpp"

// From files to the device: particles as gencase leaves them, or a checkpoint.
namespace thalweg {

/// The kind of particle i of a file.
template <int Dim>
float kind_of(const Scene<Dim>& scene, const ParticleSet& from, std::size_t i) {
  switch (from.type[i]) {
    case ParticleType::wall:
    case ParticleType::moving_wall:
      return kind::wall;
    case ParticleType::water:
      return kind::water;
    case ParticleType::sediment:
      break;
  }
  if (scene.surface_bed.on) return kind::wall;
  const auto kinds = from.scalars.find(checkpoint_array::kind);
  const float known = kinds == from.scalars.end() ? kind::deposit : kinds->second[i];
  if (known == kind::resting) return scene.may_rest ? known : kind::deposit;
  return scene.has_states ? known : kind::deposit;  // a state that no model keeps would be read out of bounds
}

/// A particle as it starts or goes on; walls have the volume of a spacing.
template <int Dim>
Record record_of(const Scene<Dim>& scene, const ParticleSet& from, std::size_t i) {
  Record r{};
  const auto exact_excess = from.scalars.find(checkpoint_array::excess);
  r.kind = kind_of(scene, from, i);
  for (int k = 0; k < Dim; ++k) r.place[axis<Dim>(k)] = scene.lattice.place(k, from.position[i][axis<Dim>(k)]);
  if (!from.velocity.empty()) {
    for (int c = 0; c < 3; ++c) r.velocity[c] = from.velocity[i][c];
  }
  if (!from.pressure.empty()) r.pressure = from.pressure[i];
  if (exact_excess != from.scalars.end()) r.excess = exact_excess->second[i];
  if (is_wall(r)) {
    r.volume = static_cast<float>(std::pow(scene.spacing, Dim));
    return r;
  }
  if (exact_excess == from.scalars.end()) {
    r.excess = static_cast<float>(double(from.density[i]) / double(density_in_files(scene, r.kind)) - 1);
  }
  r.volume = from.mass[i] / (scene.density_at_rest(r.kind) * (1 + r.excess));  // as the step does
  if (!from.viscosity.empty()) r.viscosity = from.viscosity[i];
  return r;
}

/// Refuses an array that is too short or too long.
inline void check_size(const std::string& name, std::size_t numbers, std::size_t needed) {
  if (numbers == needed) return;
  throw InputError("the checkpoint's array " + name + " has " + std::to_string(numbers) + " numbers and needs " +
                   std::to_string(needed) + "; it is from another version: start again from particles.vtp");
}

/// Visitor of particle arrays: gives each its n entries, from a checkpoint that has them or newborn.
template <class Device>
struct LoadArrays : ArraysOnly {
  Device& on;
  const ParticleSet& from;
  Index n;
  LoadArrays(Device& device, const ParticleSet& file, Index count) : on(device), from(file), n(count) {}

  template <class Buffer, class T>
  void array(const Field& field, Buffer& buffer, ArrayTraits traits, const T& newborn) {
    if ((traits & sorted) == 0) return;
    HostBuffer<T> entries(n, newborn);
    if ((traits & checkpointed) != 0) read(field, entries);
    on.upload(std::move(entries), buffer);
  }

 private:
  template <class T>
  void read(const Field& field, HostBuffer<T>& entries) const {
    if constexpr (std::is_same_v<T, float>) {
      const auto found = from.scalars.find(field.name);
      if (found == from.scalars.end()) return;
      check_size(field.name, found->second.size(), entries.size());
      entries.assign(found->second.begin(), found->second.end());
    } else {
      const auto found = from.doubles.find(field.name);
      if (found == from.doubles.end()) return;
      check_size(field.name, found->second.size(), entries.size() * numbers_in<T>());
      for (std::size_t i = 0; i < entries.size(); ++i) {
        decode(found->second.data() + i * numbers_in<T>(), entries[i]);
      }
    }
  }
};

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
    if (!is_wall(record[i])) ++p.fluid_count;
  }
  if (from.doubles.contains(field::role.name)) Population::open(on, p);
  LoadArrays<Device> load(on, from, n);
  p.describe(scene, load);
  on.upload(std::move(record), p.record);
  on.upload(std::move(position), p.position);
  on.upload(std::move(type), p.type);
  on.upload(HostBuffer<float>(from.mass.begin(), from.mass.end()), p.mass);
  on.upload(HostBuffer<std::int64_t>(from.id.begin(), from.id.end()), p.id);
}

/// The grains of the water, from the concentrations of a filled scene; a checkpoint has the grains themselves, but not
/// that lists were due for a change of the bed.
template <int Dim, class Device, class Workspace>
void load_grains(Device& on, Particles<Device>& p, const Scene<Dim>& scene, Workspace& work, const ParticleSet& from) {
  if (!scene.surface_bed.on && is_bed_change_due(work.number)) work.squared_drift = INFINITY;
  const auto known = from.scalars.find(concentration_array);
  if (known == from.scalars.end() || from.doubles.contains(field::grains.name)) return;
  HostBuffer<double> grains(from.size(), 0.0);
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from.type[i] != ParticleType::water) continue;
    grains[i] = double(known->second[i]) * double(from.mass[i]) / double(scene.water_density);
  }
  on.upload(std::move(grains), p.grains);
}

/// The numbers of the walls' motions, and the places where they started. Where a file does not know these, walls are
/// moved back there.
template <class Device>
void load_motions(Device& on, Particles<Device>& p, const std::vector<WallMotion>& motions, const ParticleSet& from) {
  const std::size_t n = from.size();
  const std::vector<float>& numbers = from.scalars.at(motion_array);
  HostBuffer<Index> number(n);
  for (std::size_t i = 0; i < n; ++i) number[i] = static_cast<Index>(numbers[i]);
  if (!from.doubles.contains(field::moved_from.name)) {
    HostBuffer<Position> moved_from(n);
    for (std::size_t i = 0; i < n; ++i) {
      const Position now{{from.position[i][0], from.position[i][1], from.position[i][2]}};
      moved_from[i] = now;
      if (number[i] == 0) continue;
      const WallMotion& motion = motions[number[i] - 1];
      moved_point(motion.axis, -motion.at(from.info.time).place, now.x, moved_from[i].x);
    }
    on.upload(std::move(moved_from), p.moved_from);
  }
  on.upload(std::move(number), p.motion);
}

/// Exchanges the particles' places for those that the lists are built for.
template <class Device>
void swap_places(Device& on, Particles<Device>& p) {
  Record* records = p.record.data();
  Place* listed = p.listed_at.data();
  on.for_each(p.count, declare<Reads<field::place, field::listed_at>, Writes<field::place, field::listed_at>>(
                           [=] HOST_DEVICE(Index i) {
                             for (int c = 0; c < 3; ++c) {
                               const std::int32_t place = records[i].place[c];
                               records[i].place[c] = listed[i].c[c];
                               listed[i].c[c] = place;
                             }
                           }));
}

/// True if the particles of all ranks stand in the order of their list cells, fluid and walls apart.
template <int Dim, class Device>
bool are_in_order(Device& on, const Particles<Device>& p, const Scene<Dim>& scene) {
  const bool here = neighbours::are_in_order(on, p, scene);
  if (on.shared == nullptr) return here;
  struct Keys {
    bool ascend;
    bool any[2];  // of the fluid and of the walls
    std::uint64_t first[2];
    std::uint64_t last[2];
  };
  Keys mine{here, {p.fluid_count > 0, p.fluid_count < p.count}, {}, {}};
  const Index begins[] = {0, p.fluid_count, p.count};
  for (int part = 0; part < 2; ++part) {
    if (!mine.any[part]) continue;
    const auto key_at = [&](Index i) {
      const auto record = on.download(p.record, i, i + 1);
      return neighbours::HilbertKey<Dim>(record.data(), scene.lattice)(0);
    };
    mine.first[part] = key_at(begins[part]);
    mine.last[part] = key_at(begins[part + 1] - 1);
  }
  std::uint64_t before[2] = {0, 0};
  for (const Keys& of_rank : gather_from(on.shared->ranks, mine)) {
    if (!of_rank.ascend) return false;
    for (int part = 0; part < 2; ++part) {
      if (!of_rank.any[part]) continue;
      if (of_rank.first[part] < before[part]) return false;
      before[part] = of_rank.last[part];
    }
  }
  return true;
}

/// Builds the lists of a checkpoint. It holds the particles in list order, and lists are built for the places they were
/// built for, which makes the continued run the same, bit for bit, as one that never stopped. With another reach the list
/// cells differ, and with them the order: then the first step sorts the particles and makes lists of its own.
template <int Dim, class Device>
void restore_lists(Device& on, Particles<Device>& p, const Scene<Dim>& scene, const std::vector<double>& listed) {
  HostBuffer<Place> places(p.count);
  check_size(checkpoint_array::listed_at, listed.size(), 3 * places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) places[i].c[c] = static_cast<std::int32_t>(listed[3 * i + c]);
  }
  on.upload(std::move(places), p.listed_at);
  swap_places(on, p);
  const bool in_order = are_in_order(on, p, scene);
  if (in_order) {
    with_share<Dim>(on, [&](auto& share) { share.find_copies(on, p, scene); });
    neighbours::build_lists(on, p, scene);
    if (scene.may_rest) list_active_clusters(on, p);
  }
  swap_places(on, p);
  if (!in_order) {  // no lists
    p.listed_at.resize(0);
    p.list_begin.resize(0);
    return;
  }
  with_share<Dim>(on, [&](auto& share) { share.bring_all(on, p, scene); });
}

}  // namespace thalweg
