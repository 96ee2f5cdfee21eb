#pragma once

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "common/ranks.hpp"

namespace thalweg {

/// A rank without others. A GPU adds up for it as for one of several ranks, so that its results are theirs.
class OneRank final : public Ranks {
 public:
  [[nodiscard]] int rank() const override { return 0; }
  [[nodiscard]] int size() const override { return 1; }
  void gather(const void* mine, std::size_t bytes, void* all) override {
    if (bytes > 0) std::memcpy(all, mine, bytes);
  }
  void start_exchange(const std::vector<std::span<const std::byte>>& to,
                      const std::vector<std::span<std::byte>>& from) override {
    std::copy(to.front().begin(), to.front().end(), from.front().begin());
  }
  void finish_exchange() override {}
  void sum(std::int64_t*, std::size_t) override {}
  void largest(std::uint8_t*, std::size_t) override {}
  [[nodiscard]] Traffic sent() const override { return {}; }
  [[nodiscard]] double waited() const override { return 0; }
  [[nodiscard]] int on_this_machine() const override { return 1; }
  [[nodiscard]] int place_on_this_machine() const override { return 0; }
  [[noreturn]] void abandon() override { std::exit(EXIT_FAILURE); }
};

}  // namespace thalweg
