#include "common/particle_slices.hpp"

#include "common/particle_pairs.hpp"

namespace thalweg {

ParticleSet slice(const ParticleSet& of, std::size_t from, std::size_t to) {
  ParticleSet part;
  for_each_pair(part, of, [&](const std::string&, auto& array, const auto& of_all) {
    const std::size_t each = of_all.empty() ? 0 : of_all.size() / of.size();
    array.assign(of_all.begin() + static_cast<std::ptrdiff_t>(from * each),
                 of_all.begin() + static_cast<std::ptrdiff_t>(to * each));
  });
  return part;
}

void append(ParticleSet& to, const ParticleSet& particles) {
  for_each_pair(to, particles, [&](const std::string&, auto& array, const auto& more) {
    array.insert(array.end(), more.begin(), more.end());
  });
}

void reserve(ParticleSet& set, const ParticleSet& like, std::size_t particles) {
  for_each_pair(set, like, [&](const std::string&, auto& array, const auto& of_like) {
    array.reserve(of_like.size() / like.size() * particles);
  });
}

}  // namespace thalweg
