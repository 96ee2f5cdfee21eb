#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace thalweg {

/// The numbers of an array on their way into a VTK XML file: compressed block by block, and kept in a temporary file until all
/// are there, because the sizes of the blocks stand before them.
class BlockSpool {
 public:
  /// `file` is made, and removed at the end.
  explicit BlockSpool(std::filesystem::path file);
  ~BlockSpool();
  BlockSpool(const BlockSpool&) = delete;
  BlockSpool& operator=(const BlockSpool&) = delete;

  /// Adds bytes to the end. Throws RunError if the disk is full.
  void add(std::string_view bytes);

  /// Hands the array's text over in parts, sizes first, in base64. Nothing is added any more.
  void write_to(const std::function<void(std::string_view)>& sink);

 private:
  void compress_block(std::string_view block);

  std::filesystem::path file_;
  std::fstream kept_;
  std::string pending_;  // less than a block
  std::uint64_t last_block_ = 0;
  std::vector<std::uint64_t> compressed_;  // sizes of the blocks
};

}  // namespace thalweg
