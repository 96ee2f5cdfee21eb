#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "common/ranks.hpp"
#include "solver/state/drift_blocks.hpp"

// Sums over all ranks of a run.
namespace thalweg {

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
  // One message for as many nodes as a rank usually has, a second one for the rest.
  constexpr std::size_t usual = 24;
  struct Part {
    std::int64_t count;
    std::byte nodes[usual * sizeof(Node)];
  };
  const std::vector<Node>& own = mine.nodes();
  Part part{static_cast<std::int64_t>(own.size()), {}};
  std::ranges::copy(std::as_bytes(std::span(own).first(std::min(usual, own.size()))), part.nodes);
  const std::vector<Part> parts = gather_from(ranks, part);
  std::size_t most = 0;
  for (const Part& p : parts) most = std::max(most, static_cast<std::size_t>(p.count));
  const std::size_t more = most > usual ? most - usual : 0;
  std::vector<Node> rest(more, Node{0, 0, start});
  std::vector<Node> rests(more * parts.size(), Node{0, 0, start});
  if (own.size() > usual) std::copy(own.begin() + usual, own.end(), rest.begin());
  if (more > 0) ranks.gather(rest.data(), more * sizeof(Node), rests.data());
  BlockTree<T, Combine> tree(combine);
  for (std::size_t r = 0; r < parts.size(); ++r) {
    for (std::size_t n = 0; n < static_cast<std::size_t>(parts[r].count); ++n) {
      Node node{0, 0, start};
      if (n < usual) {
        std::memcpy(static_cast<void*>(&node), parts[r].nodes + n * sizeof(Node), sizeof(Node));
      } else {
        node = rests[r * more + n - usual];
      }
      tree.add(node);
    }
  }
  return tree.total(start);
}

/// start combined with the numbers of all ranks, one rank after the other.
template <class T, class Combine>
T total_of_ranks(Ranks& ranks, const T& mine, const T& start, const Combine& combine) {
  struct Own {
    T number;
  };
  T total = start;
  for (const Own& of_rank : gather_from(ranks, Own{mine})) total = combine(total, of_rank.number);
  return total;
}

}  // namespace thalweg
