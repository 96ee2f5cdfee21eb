#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "solver/state/drift_blocks.hpp"

// Several processes that compute one scene together, each a part of its particles. They run the same code in the same
// order: what a rank does next depends on numbers that all ranks have. The communication itself is behind Ranks: MPI's
// (solver/domain/mpi), or, in the tests, that of threads.
namespace thalweg {

using Bytes = std::vector<std::byte>;

/// The ranks of a run. Every function is called by all of them, in the same order.
class Ranks {
 public:
  Ranks() = default;
  virtual ~Ranks() = default;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  [[nodiscard]] virtual int rank() const = 0;
  [[nodiscard]] virtual int size() const = 0;
  /// `bytes` bytes of every rank, one rank after the other, to all.
  virtual void gather(const void* mine, std::size_t bytes, void* all) = 0;
  /// to[r] goes to rank r; from[r], whose size is known, comes from there. Empty ones are no messages.
  virtual void exchange(const std::vector<std::span<const std::byte>>& to,
                        const std::vector<std::span<std::byte>>& from) = 0;
  /// Replaces n numbers by their sums over all ranks.
  virtual void sum(std::int64_t* numbers, std::size_t n) = 0;
  /// Ends the run on all ranks, now; for a rank that cannot go on.
  [[noreturn]] virtual void abandon() = 0;
};

/// A number of every rank.
template <class T>
std::vector<T> gather_from(Ranks& ranks, const T& mine) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::vector<T> all(static_cast<std::size_t>(ranks.size()));
  ranks.gather(&mine, sizeof(T), all.data());
  return all;
}

/// Messages whose sizes only their senders know: to[r] goes to rank r, the result's r-th has come from there.
inline std::vector<Bytes> exchange_any(Ranks& ranks, const std::vector<Bytes>& to) {
  const auto n = static_cast<std::size_t>(ranks.size());
  std::vector<std::int64_t> sizes(n);
  for (std::size_t r = 0; r < n; ++r) sizes[r] = static_cast<std::int64_t>(to[r].size());
  std::vector<std::int64_t> table(n * n);
  ranks.gather(sizes.data(), n * sizeof(std::int64_t), table.data());
  std::vector<Bytes> from(n);
  std::vector<std::span<const std::byte>> out(to.begin(), to.end());
  std::vector<std::span<std::byte>> in(n);
  for (std::size_t r = 0; r < n; ++r) {
    from[r].resize(static_cast<std::size_t>(table[r * n + static_cast<std::size_t>(ranks.rank())]));
    in[r] = from[r];
  }
  ranks.exchange(out, in);
  return from;
}

/// The bytes of one rank to all.
inline Bytes broadcast(Ranks& ranks, const Bytes& mine, int root = 0) {
  const auto n = static_cast<std::size_t>(ranks.size());
  return exchange_any(ranks, std::vector<Bytes>(n, ranks.rank() == root ? mine : Bytes()))[static_cast<std::size_t>(root)];
}

/// Adds n numbers to the end of a message.
template <class T>
void append_to(Bytes& message, const T* numbers, std::size_t n) {
  static_assert(std::is_trivially_copyable_v<T>);
  const std::size_t at = message.size();
  message.resize(at + n * sizeof(T));
  if (n > 0) std::memcpy(message.data() + at, numbers, n * sizeof(T));
}

/// Reads a message's numbers from its beginning on.
class MessageReader {
 public:
  explicit MessageReader(const Bytes& message) : message_(message) {}
  template <class T>
  void read(T* numbers, std::size_t n) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (at_ + n * sizeof(T) > message_.size()) throw std::logic_error("a rank's message is shorter than announced");
    if (n > 0) std::memcpy(numbers, message_.data() + at_, n * sizeof(T));
    at_ += n * sizeof(T);
  }
  template <class T>
  T number() {
    T one{};
    read(&one, 1);
    return one;
  }

 private:
  const Bytes& message_;
  std::size_t at_ = 0;
};

/// The part that a device has in a scene of several ranks; nullptr where there is one.
class SharedScene {
 public:
  explicit SharedScene(Ranks& of) : ranks(of) {}
  virtual ~SharedScene() = default;
  SharedScene(const SharedScene&) = delete;
  SharedScene& operator=(const SharedScene&) = delete;

  /// Adds to the boxes of the list cells' blocks what other ranks found in the same blocks.
  virtual void merge(const DriftBlocks& blocks, DriftBox* of_block) = 0;

  Ranks& ranks;
  std::int64_t first_block = 0;  // of sums: number of the block in which this rank's fluid begins
};

/// A sum over blocks that is added up along a binary tree over the blocks' numbers, so that it has the same bits
/// whatever part of the blocks each rank has.
template <class T, class Combine>
class BlockTree {
 public:
  explicit BlockTree(const Combine& combine) : combine_(combine) {}

  /// A node holds the blocks [index, index + 1) 2^level.
  struct Node {
    std::int64_t index;
    std::int64_t level;
    T value;
  };

  /// Adds the next block.
  void add(std::int64_t block, const T& value) { add(Node{block, 0, value}); }
  void add(const Node& node) {
    nodes_.push_back(node);
    join_the_last();
  }

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }

  /// The sum of all, `start` of none.
  T total(const T& start) {
    while (nodes_.size() > 1) {
      Node& last = nodes_.back();
      last.index /= 2;  // its right neighbour has no blocks
      if (++last.level > 62) throw std::logic_error("a sum over blocks has a gap");
      join_the_last();
    }
    return nodes_.empty() ? start : nodes_.front().value;
  }

 private:
  static bool joins(const Node& left, const Node& right) {
    return left.level == right.level && left.index % 2 == 0 && right.index == left.index + 1;
  }
  void join_the_last() {
    while (nodes_.size() > 1 && joins(nodes_[nodes_.size() - 2], nodes_.back())) {
      const Node right = nodes_.back();
      nodes_.pop_back();
      Node& left = nodes_.back();
      left = {left.index / 2, left.level + 1, combine_(left.value, right.value)};
    }
  }

  const Combine& combine_;
  std::vector<Node> nodes_;
};

/// The total of a tree of which every rank has added its part.
template <class T, class Combine>
T total_of(Ranks& ranks, const BlockTree<T, Combine>& mine, const T& start, const Combine& combine) {
  using Node = typename BlockTree<T, Combine>::Node;
  static_assert(std::is_trivially_copyable_v<T>);
  // Short messages stay short: all ranks have about as many nodes.
  std::vector<std::int64_t> counts = gather_from(ranks, static_cast<std::int64_t>(mine.nodes().size()));
  std::int64_t largest = 0;
  for (const std::int64_t n : counts) largest = largest > n ? largest : n;
  const auto slot = static_cast<std::size_t>(largest);
  std::vector<Node> padded(mine.nodes().begin(), mine.nodes().end());
  padded.resize(slot, Node{0, 0, start});
  std::vector<Node> all(slot * counts.size(), Node{0, 0, start});
  if (slot > 0) ranks.gather(padded.data(), slot * sizeof(Node), all.data());
  BlockTree<T, Combine> tree(combine);
  for (std::size_t r = 0; r < counts.size(); ++r) {
    for (std::int64_t n = 0; n < counts[r]; ++n) tree.add(all[r * slot + static_cast<std::size_t>(n)]);
  }
  return tree.total(start);
}

}  // namespace thalweg
