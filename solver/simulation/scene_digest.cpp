#include "solver/simulation/scene_digest.hpp"

#include "common/particle_slices.hpp"

namespace thalweg {

bool SceneDigest::belongs(std::size_t slot, const ParticleSet& of, std::size_t i) const {
  const ParticleType type = of.type[i];
  if (slot < of_type) return type != ParticleType::moving_wall;
  if (slot < lowest_wall) return static_cast<std::size_t>(type) == slot - of_type;
  if (slot == lowest_wall) return type == ParticleType::wall;
  if (slot == highest) return true;
  if (type != ParticleType::moving_wall) return false;
  const auto numbers = of.scalars.find(motion_array);
  const float number = numbers == of.scalars.end() ? 0 : numbers->second[i];
  return !(number >= 1 && number <= static_cast<float>(motions_));
}

/// Particle i is to be kept rather than particle j, which came before it.
bool SceneDigest::is_better(std::size_t slot, const ParticleSet& of, std::size_t i, const ParticleSet& than,
                            std::size_t j) {
  if (slot < of_type) {
    const auto axis = static_cast<Eigen::Index>(slot / 2);
    const double mine = of.position[i][axis];
    const double other = than.position[j][axis];
    return slot % 2 == 0 ? mine < other : mine > other;
  }
  if (slot == lowest_wall) return of.id[i] < than.id[j];
  return slot == highest && of.id[i] > than.id[j];
}

void SceneDigest::add(const ParticleSet& range) {
  for (std::size_t slot = 0; slot < slots; ++slot) {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < range.size(); ++i) {
      if (!belongs(slot, range, i)) continue;
      if (best ? is_better(slot, range, i, range, *best) : !kept_[slot] || is_better(slot, range, i, *kept_[slot], 0)) {
        best = i;
      }
    }
    if (best) kept_[slot] = slice(range, *best, *best + 1);
  }
}

ParticleSet SceneDigest::particles() const {
  ParticleSet all;
  for (const auto& kept : kept_) {
    if (kept) append(all, *kept);
  }
  return all;
}

}  // namespace thalweg
