#include "solver/simulation/particle_messages.hpp"

#include <span>
#include <string>
#include <utility>

#include "common/particle_arrays.hpp"
#include "solver/simulation/simulation.hpp"

namespace thalweg {
namespace {

/// Arrays of vectors travel as their bytes.
template <class T>
void append_array(Bytes& message, const std::vector<T>& array) {
  const std::uint64_t n = array.size();
  append_to(message, &n, 1);
  append_to(message, reinterpret_cast<const std::byte*>(array.data()), array.size() * sizeof(T));
}
template <class T>
void read_array(MessageReader& message, std::vector<T>& array) {
  array.resize(message.number<std::uint64_t>());
  message.read(reinterpret_cast<std::byte*>(array.data()), array.size() * sizeof(T));
}

template <class Map>
void append_map(Bytes& message, const Map& map) {
  const std::uint64_t n = map.size();
  append_to(message, &n, 1);
  for (const auto& [name, array] : map) {
    append_array(message, std::vector<char>(name.begin(), name.end()));
    append_array(message, array);
  }
}
template <class Map>
void read_map(MessageReader& message, Map& map) {
  for (auto n = message.number<std::uint64_t>(); n > 0; --n) {
    std::vector<char> name;
    read_array(message, name);
    read_array(message, map[std::string(name.begin(), name.end())]);
  }
}

/// Bytes of a message, about: the names of arrays are left out.
std::size_t bytes_of(const ParticleSet& set) {
  std::size_t bytes = set.position.size() * sizeof(Vec3);
  for_each_array(set, [&](const char*, const auto& array) { bytes += std::span(array).size_bytes(); });
  for (const auto& [name, array] : set.scalars) bytes += std::span(array).size_bytes();
  for (const auto& [name, array] : set.doubles) bytes += std::span(array).size_bytes();
  return bytes;
}

}  // namespace

void append_to(Bytes& message, const ParticleSet& set) {
  for_each_array(set, [&](const char*, const auto& array) { append_array(message, array); });
  append_array(message, set.position);
  append_map(message, set.scalars);
  append_map(message, set.doubles);
  append_map(message, set.facts);
}

Bytes to_message(const ParticleSet& set) {
  Bytes message;
  message.reserve(bytes_of(set) + 4096);
  append_to(message, set);
  return message;
}

ParticleSet particles_in(MessageReader& message) {
  ParticleSet set;
  for_each_array(set, [&](const char*, auto& array) { read_array(message, array); });
  read_array(message, set.position);
  read_map(message, set.scalars);
  read_map(message, set.doubles);
  read_map(message, set.facts);
  return set;
}

ParticleSet from_message(const Bytes& bytes) {
  MessageReader message(bytes);
  return particles_in(message);
}

Bytes scatter(Ranks& ranks, const std::vector<Bytes>& messages) {
  const auto n = static_cast<std::size_t>(ranks.size());
  const bool sends = ranks.rank() == 0;
  Bytes sizes;
  for (std::size_t r = 0; sends && r < n; ++r) {
    const std::uint64_t size = messages[r].size();
    append_to(sizes, &size, 1);
  }
  const Bytes known = broadcast(ranks, sizes);
  std::vector<std::uint64_t> of_ranks(n);
  MessageReader(known).read(of_ranks.data(), n);
  Bytes mine(of_ranks[static_cast<std::size_t>(ranks.rank())]);
  std::vector<std::span<const std::byte>> out(n);
  if (sends) out.assign(messages.begin(), messages.end());
  std::vector<std::span<std::byte>> in(n);
  in[0] = mine;
  ranks.exchange(out, in);
  return mine;
}

SetSizes sizes_of(const ParticleSet& of_rank) {
  const double fluid = of_rank.facts.at(own_fluid_fact).at(0);
  return {of_rank.size(), fluid < 0 ? of_rank.size() : static_cast<std::uint64_t>(fluid)};
}

JointSet::JointSet(std::vector<SetSizes> of_ranks) : of_ranks_(std::move(of_ranks)) {
  for (const SetSizes& of_rank : of_ranks_) {
    total_.all += of_rank.all;
    total_.fluid += of_rank.fluid;
  }
}

/// Reads the entries of an array to their places.
template <class T>
void JointSet::place(std::size_t rank, MessageReader& message, std::vector<T>& to) const {
  const auto entries = message.number<std::uint64_t>();
  if (entries == 0) return;
  const SetSizes& own = of_ranks_[rank];
  const std::size_t components = entries / own.all;
  SetSizes before{};
  for (std::size_t r = 0; r < rank; ++r) {
    before.all += of_ranks_[r].all;
    before.fluid += of_ranks_[r].fluid;
  }
  to.resize(total_.all * components);
  const auto read = [&](std::size_t at, std::size_t particles) {
    message.read(reinterpret_cast<std::byte*>(to.data() + at * components), particles * components * sizeof(T));
  };
  read(before.fluid, own.fluid);
  read(total_.fluid + before.all - before.fluid, own.all - own.fluid);
}

template <class T>
void JointSet::place_map(std::size_t rank, MessageReader& message, std::map<std::string, std::vector<T>>& to) const {
  for (auto n = message.number<std::uint64_t>(); n > 0; --n) {
    std::vector<char> name;
    read_array(message, name);
    place(rank, message, to[std::string(name.begin(), name.end())]);
  }
}

void JointSet::add(std::size_t rank, const Bytes& bytes) {
  MessageReader message(bytes);
  for_each_array(joint_, [&](const char*, auto& array) { place(rank, message, array); });
  place(rank, message, joint_.position);
  place_map(rank, message, joint_.scalars);
  place_map(rank, message, joint_.doubles);
  if (rank != 0) return;
  read_map(message, joint_.facts);
  joint_.facts.erase(own_fluid_fact);
}

}  // namespace thalweg
