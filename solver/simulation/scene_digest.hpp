#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "common/particles.hpp"

namespace thalweg {

/// The few particles of a set of which the same scene is made as of all (make_scene), and the same population: those that lie
/// outermost, the first of every type, those with the least and the largest id that count, and a moving wall whose motion is
/// unknown. They are found range by range.
class SceneDigest {
 public:
  /// `motions`: number of the case's.
  explicit SceneDigest(std::size_t motions) : motions_(motions) {}

  /// The ranges come in the order of the file.
  void add(const ParticleSet& range);

  /// Without info and facts.
  [[nodiscard]] ParticleSet particles() const;

 private:
  enum Slot : std::size_t {
    outermost = 0,
    of_type = 6,
    lowest_wall = 10,
    highest = 11,
    unknown_motion = 12,
    slots = 13
  };

  [[nodiscard]] bool belongs(std::size_t slot, const ParticleSet& of, std::size_t i) const;
  [[nodiscard]] static bool is_better(std::size_t slot, const ParticleSet& of, std::size_t i, const ParticleSet& than,
                                      std::size_t j);

  std::size_t motions_;
  std::array<std::optional<ParticleSet>, slots> kept_;  // one particle each
};

}  // namespace thalweg
