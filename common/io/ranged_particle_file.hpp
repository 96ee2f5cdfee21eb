#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/error.hpp"
#include "common/io/block_spool.hpp"
#include "common/packed_particles.hpp"
#include "common/particles.hpp"
#include "common/whole_file.hpp"

namespace thalweg {

/// A particle file as a whole: what it holds beside the particles' arrays.
struct ParticleFileFrame {
  ParticleFileInfo info;
  std::map<std::string, std::vector<double>> facts{};
  std::map<std::string, std::string> texts{};
  PositionPrecision precision = PositionPrecision::double_precision;  // of the ranges that were added
};

/// A particle file that is written range by range, for more particles than memory holds. It has the bytes that
/// write_particles gives of the whole set. Until the end the arrays lie in temporary files beside it, which
/// take three quarters of its room.
class RangedParticleFile {
 public:
  explicit RangedParticleFile(std::filesystem::path file, WholeFile how = {});

  /// Adds particles behind those that are there, with positions in double precision. All ranges have the same arrays; their
  /// info and facts are not read. Throws RunError: an array that does not fit the number of particles, or another range's; a
  /// disk that is full.
  void add(const ParticleSet& range);
  /// Adds particles that ParticlePackers have packed, in any order. Throws RunError likewise.
  void add(const PackedRange& range);

  /// Writes the file, which appears whole or not at all. Throws RunError.
  void finish(const ParticleFileFrame& frame);

  [[nodiscard]] std::int64_t size() const { return size_; }
  /// Two particles with the least and the largest entry of every array so far; none without a particle.
  [[nodiscard]] const ParticleSet& extremes() const { return extremes_; }

 private:
  /// `of_file`: as the array stands in the file.
  BlockSpool& spool(const std::string& of_file);
  [[noreturn]] void refuse(const RunError& what) const;
  void write_few(const ParticleFileFrame& frame);

  std::filesystem::path file_;
  WholeFile how_;
  std::int64_t size_ = 0;
  ParticleSet extremes_;
  ParticlePacker packer_{0, PositionPrecision::double_precision};  // of particles that come as they are
  std::map<std::string, std::unique_ptr<BlockSpool>> spools_;
};

}  // namespace thalweg
