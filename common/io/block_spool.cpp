#include "common/io/block_spool.hpp"

#include <vtkBase64Utilities.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "common/error.hpp"

namespace thalweg {
namespace {

/// As the writer of whole files does (poly_data_file.cpp): VTK's size of a block, and the quickest compression.
constexpr std::size_t block_size = 32768;
constexpr int compression_level = 1;

/// Base64 of bytes that come in parts.
class Base64 {
 public:
  explicit Base64(const std::function<void(std::string_view)>& sink) : sink_(sink) {}
  void add(std::string_view bytes) {
    left_.append(bytes);
    const std::size_t whole = left_.size() / 3 * 3;
    hand_over(whole);
    left_.erase(0, whole);
  }
  void end() {
    hand_over(left_.size());
    left_.clear();
  }

 private:
  void hand_over(std::size_t bytes) {
    if (bytes == 0) return;
    std::string text((bytes + 2) / 3 * 4, '\0');
    vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(left_.data()), bytes,
                               reinterpret_cast<unsigned char*>(text.data()));
    sink_(text);
  }

  const std::function<void(std::string_view)>& sink_;
  std::string left_;  // less than three bytes between two calls
};

std::string_view size_bytes(const std::vector<std::uint64_t>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(std::uint64_t)};
}

}  // namespace

BlockSpool::BlockSpool(std::filesystem::path file)
    : file_(std::move(file)), kept_(file_, std::ios::in | std::ios::out | std::ios::trunc | std::ios::binary) {
  if (!kept_) throw RunError(file_.string() + ": cannot be made; check the folder's permissions and free space");
}

BlockSpool::~BlockSpool() {
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
}

void BlockSpool::add(std::string_view bytes) {
  while (!bytes.empty()) {
    if (pending_.empty() && bytes.size() >= block_size) {
      compress_block(bytes.substr(0, block_size));
      bytes.remove_prefix(block_size);
      continue;
    }
    const std::size_t taken = std::min(bytes.size(), block_size - pending_.size());
    pending_.append(bytes.substr(0, taken));
    bytes.remove_prefix(taken);
    if (pending_.size() == block_size) compress_block(std::exchange(pending_, {}));
  }
}

void BlockSpool::compress_block(std::string_view block) {
  std::string compressed(compressBound(block.size()), '\0');
  uLongf size = compressed.size();
  compress2(reinterpret_cast<Bytef*>(compressed.data()), &size, reinterpret_cast<const Bytef*>(block.data()),
            block.size(), compression_level);
  compressed_.push_back(size);
  last_block_ = block.size();
  if (!kept_.write(compressed.data(), static_cast<std::streamsize>(size))) {
    throw RunError(file_.string() + ": cannot be written; is the disk full?");
  }
}

void BlockSpool::write_to(const std::function<void(std::string_view)>& sink) {
  if (!pending_.empty()) compress_block(std::exchange(pending_, {}));
  // The number of blocks, their size, that of the last one if it is smaller, and their compressed sizes.
  std::vector<std::uint64_t> sizes{compressed_.size(), block_size, last_block_ == block_size ? 0 : last_block_};
  sizes.insert(sizes.end(), compressed_.begin(), compressed_.end());
  Base64 text(sink);
  text.add(size_bytes(sizes));
  text.end();
  kept_.flush();
  kept_.seekg(0);
  std::string part(std::size_t{3} << 18, '\0');
  for (std::uint64_t left = 0, all = 0;; left = all) {
    kept_.read(part.data(), static_cast<std::streamsize>(part.size()));
    all = left + static_cast<std::uint64_t>(kept_.gcount());
    if (all == left) break;
    text.add(std::string_view(part).substr(0, all - left));
  }
  text.end();
}

}  // namespace thalweg
