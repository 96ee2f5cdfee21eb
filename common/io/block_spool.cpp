#include "common/io/block_spool.hpp"

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
    hand_over(std::string_view(left_).substr(0, whole));
    left_.erase(0, whole);
  }
  void end() {
    if (left_.empty()) return;
    const std::size_t bytes = left_.size();
    left_.resize(3, '\0');
    std::string text = encoded(left_);
    for (std::size_t c = bytes + 1; c < 4; ++c) text[c] = '=';
    sink_(text);
    left_.clear();
  }

 private:
  static std::string encoded(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve(bytes.size() / 3 * 4);
    for (std::size_t i = 0; i + 2 < bytes.size(); i += 3) {
      const auto byte = [&](std::size_t k) {
        return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i + k]));
      };
      const std::uint32_t three = byte(0) << 16 | byte(1) << 8 | byte(2);
      for (int shift = 18; shift >= 0; shift -= 6) text += digits[three >> shift & 63];
    }
    return text;
  }
  void hand_over(std::string_view bytes) {
    if (!bytes.empty()) sink_(encoded(bytes));
  }

  const std::function<void(std::string_view)>& sink_;
  std::string left_;  // less than three bytes
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
