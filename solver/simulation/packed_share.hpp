#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/packed_particles.hpp"
#include "common/ranks.hpp"
#include "solver/simulation/simulation.hpp"

namespace thalweg {

/// A rank's particles on their way into a file of all ranks, which has the fluid of all, then the walls of all. They are packed
/// range by range, on all ranks at the same time.
class PackedShare {
 public:
  /// Particles that are packed at a time: some megabytes.
  static constexpr std::uint64_t at_once = std::uint64_t{1} << 15;

  /// Called by all ranks. `spacing` [m]: pack().
  PackedShare(OwnRanges& own, Ranks& ranks, FileContents of, double spacing);

  [[nodiscard]] const PackedFrame& frame() const { return frame_; }
  /// Ranges of the rank that has most.
  [[nodiscard]] std::uint64_t rounds() const { return rounds_; }
  /// The next range of this rank, empty if it has none left.
  PackedRange next();

 private:
  /// Particles of this rank that stand one after the other in the file.
  struct Part {
    std::uint64_t from;
    std::uint64_t to;
    ParticlePacker packer;
  };

  OwnRanges& own_;
  FileContents of_;
  PackedFrame frame_{};
  std::vector<Part> parts_;  // fluid and walls
  std::uint64_t rounds_ = 0;
};

/// A range as bytes, and back.
Bytes to_message(const PackedRange& range);
PackedRange packed_range_in(const Bytes& message);

}  // namespace thalweg
