#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "common/packed_particles.hpp"

namespace thalweg {

/// The blocks of an array on their way into a VTK XML file, in any order. They are kept in a temporary file until all are
/// there, because their sizes stand before them.
class BlockSpool {
 public:
  /// `file` is made, and removed at the end.
  explicit BlockSpool(std::filesystem::path file);
  ~BlockSpool();
  BlockSpool(const BlockSpool&) = delete;
  BlockSpool& operator=(const BlockSpool&) = delete;

  /// Throws RunError if the disk is full.
  void put(const BlockPiece& piece);

  /// Hands the array's text over in parts, sizes first, in base64. No piece is put any more. Throws RunError if a temporary
  /// file cannot be read, and std::logic_error if a part of a block is missing.
  void write_to(const std::function<void(std::string_view)>& sink);

 private:
  /// A piece in the temporary file.
  struct Kept {
    std::uint64_t block;
    std::uint64_t place;  // [bytes]
    std::uint32_t at;
    std::uint32_t size;  // [bytes]
    bool is_compressed;
  };
  using Pieces = std::vector<Kept>::const_iterator;

  [[nodiscard]] std::string bytes_of(const Kept& piece);
  [[nodiscard]] std::string joined(Pieces from, Pieces to);
  [[nodiscard]] std::uint64_t join_parts();

  std::filesystem::path file_;
  std::fstream kept_;
  std::uint64_t end_ = 0;  // of the temporary file [bytes]
  std::vector<Kept> pieces_;
};

}  // namespace thalweg
