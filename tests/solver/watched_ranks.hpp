#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "common/ranks.hpp"

namespace thalweg::test {

/// Ranks that note what comes in from others.
class WatchedRanks final : public Ranks {
 public:
  explicit WatchedRanks(Ranks& of) : of_(of) {}
  [[nodiscard]] int rank() const override { return of_.rank(); }
  [[nodiscard]] int size() const override { return of_.size(); }
  void gather(const void* mine, std::size_t bytes, void* all) override { of_.gather(mine, bytes, all); }
  void start_exchange(const std::vector<std::span<const std::byte>>& to,
                      const std::vector<std::span<std::byte>>& from) override {
    int together = 0;
    for (const auto& bytes : from) {
      together += bytes.empty() ? 0 : 1;
      largest_message = std::max(largest_message, bytes.size());
    }
    most = std::max(most, together);
    in_all += together;
    of_.start_exchange(to, from);
  }
  void finish_exchange() override { of_.finish_exchange(); }
  void sum(std::int64_t* numbers, std::size_t n) override { of_.sum(numbers, n); }
  void largest(std::uint8_t* numbers, std::size_t n) override { of_.largest(numbers, n); }
  [[nodiscard]] Traffic sent() const override { return of_.sent(); }
  [[nodiscard]] double waited() const override { return of_.waited(); }
  [[nodiscard]] int on_this_machine() const override { return of_.on_this_machine(); }
  [[nodiscard]] int place_on_this_machine() const override { return of_.place_on_this_machine(); }
  [[noreturn]] void abandon() override { std::abort(); }

  void forget() {
    most = in_all = 0;
    largest_message = 0;
  }

  int most = 0;                     // messages in one exchange
  int in_all = 0;                   // messages
  std::size_t largest_message = 0;  // [bytes]

 private:
  Ranks& of_;
};

}  // namespace thalweg::test
