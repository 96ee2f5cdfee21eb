#include "common/particles.hpp"

namespace thalweg {

std::array<std::int64_t, 4> count_by_type(const ParticleSet& particles) {
  std::array<std::int64_t, 4> counts{};
  for (const ParticleType type : particles.type) ++counts[static_cast<std::size_t>(type)];
  return counts;
}

std::array<double, 4> mass_by_type(const ParticleSet& particles) {
  std::array<double, 4> masses{};
  for (std::size_t i = 0; i < particles.mass.size(); ++i) {
    masses[static_cast<std::size_t>(particles.type[i])] += static_cast<double>(particles.mass[i]);
  }
  return masses;
}

}  // namespace thalweg
