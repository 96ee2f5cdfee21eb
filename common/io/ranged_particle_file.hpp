#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "common/io/block_spool.hpp"
#include "common/particles.hpp"

namespace thalweg {

/// A particle file that is written range by range, for more particles than memory holds. It has the bytes that
/// write_particles gives of the whole set in double precision. Until the end the arrays lie in temporary files beside it, which
/// take as much room as the file.
class RangedParticleFile {
 public:
  explicit RangedParticleFile(std::filesystem::path file);

  /// Adds particles behind those that are there. All ranges have the same arrays; their info and facts are not read. Throws
  /// RunError: an array that does not fit the number of particles, or another range's; a disk that is full.
  void add(const ParticleSet& range);

  /// Writes the file, which appears whole or not at all. Throws RunError without a particle.
  void finish(const ParticleFileInfo& info);

  [[nodiscard]] std::int64_t size() const { return size_; }

 private:
  /// `of_file`: as the array stands in the file.
  template <class T>
  void add_array(const std::string& of_file, const std::vector<T>& array, std::vector<T>& extremes, std::size_t n);
  BlockSpool& spool(const std::string& of_file);
  void add_vertices();
  void write_only_particle();

  std::filesystem::path file_;
  std::int64_t size_ = 0;
  ParticleSet extremes_;  // particles 0 and 1 have the least and the largest entries
  std::map<std::string, std::unique_ptr<BlockSpool>> spools_;
};

}  // namespace thalweg
