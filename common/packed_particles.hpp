#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "common/particles.hpp"
#include "common/position_precision.hpp"

// Particles on their way into a particle file: ranges of them, compressed where they lie, in the blocks that the file has.
namespace thalweg {

/// Names of arrays that a particle file has beside those of the set.
inline constexpr const char* array_of_points = "Points";
inline constexpr const char* array_of_vertices = "connectivity";
inline constexpr const char* array_of_offsets = "offsets";

/// An array's block in a file, compressed, or a part of the block as it is.
struct BlockPiece {
  std::uint64_t block = 0;  // among those of the array
  std::uint64_t at = 0;     // byte of the block at which the piece begins
  bool is_compressed = false;
  std::string bytes;
};

/// Bytes of a block but for an array's last one, as VTK has them.
inline constexpr std::size_t block_size = 32768;

/// A block as files hold it: zlib at the quickest level, as the writer of whole files does (io/poly_data_file.cpp).
std::string compressed_block(std::string_view block);

/// Cuts bytes of an array, which come one after the other, into blocks.
class BlockCutter {
 public:
  using Sink = std::function<void(BlockPiece)>;

  /// `begin`: the place of the first byte in the array.
  explicit BlockCutter(std::uint64_t begin) : at_(begin) {}

  /// Hands over every block that is whole, and the end of one of which the beginning lies elsewhere.
  void add(std::string_view bytes, const Sink& sink);
  /// Hands over the beginning of a block that is left.
  void end(const Sink& sink);

 private:
  void hand_over(std::string_view part, const Sink& sink);

  std::uint64_t at_;     // of the first byte that was not handed over
  std::string pending_;  // less than a block
};

/// Particles of a range, packed.
struct PackedRange {
  std::uint64_t particles = 0;
  ParticleSet extremes;                                   // widen(), of the range
  std::map<std::string, std::vector<BlockPiece>> pieces;  // of each array, by its name in the file
};

/// Packs particles that stand one after the other in a file, range by range.
class ParticlePacker {
 public:
  /// `begin`: the number of the first one in the file.
  ParticlePacker(std::uint64_t begin, PositionPrecision precision) : begin_(begin), precision_(precision) {}

  /// Packs the next particles. All ranges have the same arrays; their info and facts are not read. Throws RunError for an array
  /// that does not fit the number of particles.
  PackedRange add(const ParticleSet& range);
  /// The parts of blocks that are left behind the last range.
  PackedRange end();

 private:
  void add_bytes(const std::string& array, std::string_view bytes, std::size_t of_particles, PackedRange& to);
  void add_points(const std::vector<Vec3>& points, PackedRange& to);
  void add_vertices(std::size_t n, PackedRange& to);

  std::uint64_t begin_;  // of the next range
  PositionPrecision precision_;
  std::map<std::string, BlockCutter> cutters_;
};

}  // namespace thalweg
