#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/particles.hpp"
#include "common/ranks.hpp"

namespace thalweg {

/// A particle set as bytes, without ParticleSet::info, and back.
void append_to(Bytes& message, const ParticleSet& set);
ParticleSet particles_in(MessageReader& message);
Bytes to_message(const ParticleSet& set);
ParticleSet from_message(const Bytes& message);

/// messages[r] of the first rank to rank r; each returns its own. The others' are not read.
Bytes scatter(Ranks& ranks, const std::vector<Bytes>& messages);

/// The number of a set's particles, and of those that belong to its fluid part, which stands first.
struct SetSizes {
  std::uint64_t all;
  std::uint64_t fluid;
};
/// Of a set of one rank among several (own_fluid_fact).
SetSizes sizes_of(const ParticleSet& of_rank);

/// The sets of all ranks as one rank would have it: the fluid of all, then the walls of all; facts are those of the first. It
/// is put together message by message, so that no more than one has to be in memory beside it.
class JointSet {
 public:
  explicit JointSet(std::vector<SetSizes> of_ranks);
  /// Takes the message of a rank (to_message), of each once, in any order.
  void add(std::size_t rank, const Bytes& message);
  ParticleSet take() { return std::move(joint_); }

 private:
  template <class T>
  void place(std::size_t rank, MessageReader& message, std::vector<T>& to) const;
  template <class T>
  void place_map(std::size_t rank, MessageReader& message, std::map<std::string, std::vector<T>>& to) const;

  std::vector<SetSizes> of_ranks_;
  SetSizes total_{};
  ParticleSet joint_;
};

}  // namespace thalweg
