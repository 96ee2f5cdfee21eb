#include "solver/simulation/particle_messages.hpp"

#include <string>

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

/// The particles of a rank that belong to the fluid part of a joint set, or to the walls'.
struct Part {
  std::size_t from;
  std::size_t to;
};

Part part_of(const ParticleSet& set, bool walls) {
  const double fluid = set.facts.at(own_fluid_fact).at(0);
  const std::size_t middle = fluid < 0 ? set.size() : static_cast<std::size_t>(fluid);
  return walls ? Part{middle, set.size()} : Part{0, middle};
}

/// Joins an array of every rank; of(set) is it.
template <class T, class Of>
void join(const std::vector<ParticleSet>& of_ranks, const Of& of, std::vector<T>& to) {
  for (const bool walls : {false, true}) {
    for (const ParticleSet& set : of_ranks) {
      const std::vector<T>& array = of(set);
      if (array.empty()) continue;
      const std::size_t components = array.size() / set.size();
      const Part part = part_of(set, walls);
      to.insert(to.end(), array.begin() + static_cast<std::ptrdiff_t>(part.from * components),
                array.begin() + static_cast<std::ptrdiff_t>(part.to * components));
    }
  }
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

ParticleSet join_sets(const std::vector<ParticleSet>& of_ranks) {
  ParticleSet joint;
  const ParticleSet& first = of_ranks.front();
  for_each_array(joint, [&](const char* name, auto& array) {
    join(
        of_ranks,
        [&](const ParticleSet& set) -> const std::remove_cvref_t<decltype(array)>& {
          const std::remove_cvref_t<decltype(array)>* found = nullptr;
          for_each_array(set, [&](const char* other, const auto& candidate) {
            if constexpr (std::is_same_v<decltype(candidate), decltype(*found)>) {
              if (std::string(other) == name) found = &candidate;
            }
          });
          return *found;
        },
        array);
  });
  join(
      of_ranks, [](const ParticleSet& set) -> const std::vector<Vec3>& { return set.position; }, joint.position);
  for (const auto& [name, array] : first.scalars) {
    join(
        of_ranks, [&name = name](const ParticleSet& set) -> const std::vector<float>& { return set.scalars.at(name); },
        joint.scalars[name]);
  }
  for (const auto& [name, array] : first.doubles) {
    join(
        of_ranks, [&name = name](const ParticleSet& set) -> const std::vector<double>& { return set.doubles.at(name); },
        joint.doubles[name]);
  }
  joint.facts = first.facts;
  joint.facts.erase(own_fluid_fact);
  return joint;
}

}  // namespace thalweg
