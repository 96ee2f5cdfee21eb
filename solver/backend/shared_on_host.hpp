#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "solver/backend/buffer.hpp"
#include "solver/backend/ranks.hpp"

namespace thalweg {

/// The verbs with which a device on the host brings together what the ranks of a run have. On one rank they do nothing.
struct SharedOnHost {
  SharedScene* shared = nullptr;  // on several ranks

  /// True if it is true on any rank.
  [[nodiscard]] bool any(bool mine) const {
    if (shared == nullptr) return mine;
    std::uint8_t found = mine ? 1 : 0;
    shared->ranks.largest(&found, 1);
    return found != 0;
  }
  /// Adds up over all ranks what each has added to counters in space, or takes the largest of what each has marked there.
  template <class Counters>
  void share_sums(HostBuffer<Counters>& counters) const {
    static_assert(sizeof(Counters) % sizeof(std::int64_t) == 0, "whole numbers of 64 bits");
    if (shared == nullptr) return;
    auto* const numbers = reinterpret_cast<std::int64_t*>(counters.data());
    shared->ranks.sum(numbers, counters.size() * (sizeof(Counters) / sizeof(std::int64_t)));
  }
  void share_marks(HostBuffer<std::uint8_t>& marks) const {
    if (shared != nullptr) shared->ranks.largest(marks.data(), marks.size());
  }

  /// Adds to the boxes of the list cells' blocks what other ranks found in the same blocks.
  void share_drift(const DriftBlocks& blocks, HostBuffer<DriftBox>& of_block) const {
    if (shared != nullptr) shared->merge(blocks, of_block.data());
  }

  /// Brings to all ranks what one of them has changed since `before`, which becomes a copy of the result.
  template <class T>
  void share_changes(HostBuffer<T>& now, HostBuffer<T>& before) const {
    static_assert(sizeof(T) % sizeof(std::int64_t) == 0 && std::is_trivially_copyable_v<T>);
    if (shared == nullptr) return;
    const std::size_t words = now.size() * (sizeof(T) / sizeof(std::int64_t));
    std::vector<std::uint64_t> old(words);
    std::vector<std::int64_t> change(words);
    std::ranges::copy(std::as_bytes(std::span(before)), std::as_writable_bytes(std::span(old)).begin());
    std::ranges::copy(std::as_bytes(std::span(now)), std::as_writable_bytes(std::span(change)).begin());
    for (std::size_t w = 0; w < words; ++w) {  // differences of their bits, which wrap around
      change[w] = static_cast<std::int64_t>(static_cast<std::uint64_t>(change[w]) - old[w]);
    }
    shared->ranks.sum(change.data(), words);
    for (std::size_t w = 0; w < words; ++w) {
      change[w] = static_cast<std::int64_t>(static_cast<std::uint64_t>(change[w]) + old[w]);
    }
    std::ranges::copy(std::as_bytes(std::span(change)), std::as_writable_bytes(std::span(now)).begin());
    before = now;
  }
};

}  // namespace thalweg
