#include "common/io/block_spool.hpp"

#include <vtkBase64Utilities.h>

#include <algorithm>
#include <stdexcept>
#include <system_error>
#include <tuple>
#include <utility>

#include "common/error.hpp"

namespace thalweg {
namespace {

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

void BlockSpool::put(const BlockPiece& piece) {
  kept_.seekp(static_cast<std::streamoff>(end_));
  if (!kept_.write(piece.bytes.data(), static_cast<std::streamsize>(piece.bytes.size()))) {
    throw RunError(file_.string() + ": cannot be written; is the disk full?");
  }
  const auto size = static_cast<std::uint32_t>(piece.bytes.size());
  pieces_.push_back({piece.block, end_, static_cast<std::uint32_t>(piece.at), size, piece.is_compressed});
  end_ += size;
}

std::string BlockSpool::bytes_of(const Kept& piece) {
  std::string bytes(piece.size, '\0');
  kept_.seekg(static_cast<std::streamoff>(piece.place));
  if (!kept_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
    throw RunError(file_.string() + ": cannot be read again; is the disk full?");
  }
  return bytes;
}

/// A block whose parts have come from several places.
std::string BlockSpool::joined(Pieces from, Pieces to) {
  std::string block;
  for (; from != to; ++from) {
    if (from->is_compressed || from->at != block.size()) throw std::logic_error("a block lacks a part");
    block += bytes_of(*from);
  }
  return block;
}

/// Sorts the pieces, and makes one of the parts of every block. Returns the size of the last block [bytes].
std::uint64_t BlockSpool::join_parts() {
  const auto place = [](const Kept& piece) { return std::tuple(piece.block, piece.at); };
  std::sort(pieces_.begin(), pieces_.end(), [&](const Kept& a, const Kept& b) { return place(a) < place(b); });
  const std::vector<Kept> all = std::exchange(pieces_, {});
  std::uint64_t last = block_size;
  for (auto from = all.begin(); from != all.end();) {
    const auto to = std::find_if(from, all.end(), [&](const Kept& piece) { return piece.block != from->block; });
    if (from->block != pieces_.size() || last != block_size) throw std::logic_error("an array lacks a block");
    if (from->is_compressed) {
      pieces_.push_back(*from);
    } else {
      const std::string block = joined(from, to);
      last = block.size();
      put({from->block, 0, true, compressed_block(block)});
    }
    from = to;
  }
  return last;
}

void BlockSpool::write_to(const std::function<void(std::string_view)>& sink) {
  const std::uint64_t last = join_parts();
  // The number of blocks, their size, that of the last one if it is smaller, and their compressed sizes.
  std::vector<std::uint64_t> sizes{pieces_.size(), block_size, last == block_size ? 0 : last};
  for (const Kept& piece : pieces_) sizes.push_back(piece.size);
  Base64 text(sink);
  text.add(size_bytes(sizes));
  text.end();
  for (const Kept& piece : pieces_) text.add(bytes_of(piece));
  text.end();
}

}  // namespace thalweg
