#pragma once

#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

#include "common/particles.hpp"
#include "solver/models/all.hpp"

// Checkpoints: a snapshot, and the state that a looked-at file would round or leave out. Which arrays belong to it
// follows from their declaration (`checkpointed`).
namespace thalweg {

/// Names of what checkpoints hold of the records and of the lists.
namespace checkpoint_array {
inline constexpr const char* excess = "Excess";
inline constexpr const char* kind = "ResolvedState";  // of sediment, its rest included; 0 of others
inline constexpr const char* listed_at = "ListedAt";  // three integers kept as doubles, exact
}  // namespace checkpoint_array

/// The numbers of one entry of an array: a number, a position, or a struct of floats.
template <class T>
constexpr std::size_t numbers_in() {
  if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
    return 1;
  } else if constexpr (std::is_same_v<T, Position>) {
    return 3;
  } else {
    static_assert(sizeof(T) % sizeof(float) == 0, "a checkpointed array holds numbers, positions or structs of floats");
    return sizeof(T) / sizeof(float);
  }
}

/// Writes an entry as numbers, and reads it back; doubles keep all of them exactly.
template <class T>
void encode(const T& entry, double* to) {
  if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
    to[0] = static_cast<double>(entry);
  } else if constexpr (std::is_same_v<T, Position>) {
    for (std::size_t c = 0; c < 3; ++c) to[c] = entry.x[c];
  } else {
    const auto* numbers = reinterpret_cast<const float*>(&entry);
    for (std::size_t k = 0; k < numbers_in<T>(); ++k) to[k] = double(numbers[k]);
  }
}
template <class T>
void decode(const double* from, T& entry) {
  if constexpr (std::is_arithmetic_v<T>) {
    entry = static_cast<T>(from[0]);
  } else if constexpr (std::is_enum_v<T>) {
    entry = static_cast<T>(static_cast<std::underlying_type_t<T>>(from[0]));
  } else if constexpr (std::is_same_v<T, Position>) {
    for (std::size_t c = 0; c < 3; ++c) entry.x[c] = from[c];
  } else {
    auto* numbers = reinterpret_cast<float*>(&entry);
    for (std::size_t k = 0; k < numbers_in<T>(); ++k) numbers[k] = static_cast<float>(from[k]);
  }
}

/// Adds to a snapshot of particles [from, to) what a restart needs besides, in the order of the neighbour lists.
template <int Dim, class Device>
void add_full_state(Device& on, Particles<Device>& p, const Scene<Dim>& scene, std::size_t from, std::size_t to,
                    ParticleSet& out) {
  // Of an array that may be empty.
  const auto part = [&](const auto& buffer) {
    return on.download(buffer, std::min(buffer.size(), from), std::min(buffer.size(), to));
  };
  const auto records = on.download(p.record, from, to);
  auto& excess = out.scalars[checkpoint_array::excess];
  excess.resize(records.size());
  // A snapshot shows bed load with its drift, which has an array of its own here.
  for (std::size_t i = 0; i < records.size(); ++i) {
    excess[i] = records[i].excess;
    out.velocity[i] = {records[i].velocity[0], records[i].velocity[1], records[i].velocity[2]};
  }
  if (scene.has_sediment) {
    auto& kinds = out.scalars[checkpoint_array::kind];
    for (const Record& record : records) kinds.push_back(is_sediment(record) ? record.kind : 0);
  }
  auto& listed = out.doubles[checkpoint_array::listed_at];
  for (const Place& place : part(p.listed_at)) listed.insert(listed.end(), place.c, place.c + 3);

  EachArray keep(checkpointed, [&](const Field& field, auto& buffer, const auto& newborn) {
    using T = std::remove_cvref_t<decltype(newborn)>;
    const auto entries = part(buffer);
    if constexpr (std::is_same_v<T, float>) {
      out.scalars[field.name].assign(entries.begin(), entries.end());
    } else {
      auto& numbers = out.doubles[field.name];
      numbers.resize(entries.size() * numbers_in<T>());
      for (std::size_t i = 0; i < entries.size(); ++i) encode(entries[i], numbers.data() + i * numbers_in<T>());
    }
  });
  p.describe(scene, keep);
}

}  // namespace thalweg
