#pragma once

#include <algorithm>
#include <barrier>
#include <cstdlib>
#include <functional>
#include <thread>
#include <utility>
#include <vector>

#include "common/ranks.hpp"

namespace thalweg::test {

/// Ranks that are threads of the test.
class ThreadRanks {
 public:
  /// Copies between devices.
  using Copy = std::function<void(void* to, const void* from, std::size_t bytes)>;

  /// With `between_devices` messages may lie in a device's memory.
  explicit ThreadRanks(int n, Copy between_devices = {})
      : n_(n), between_devices_(std::move(between_devices)), barrier_(n), data_(static_cast<std::size_t>(n)) {}

  /// Runs what(ranks) on all ranks at once.
  void run(const std::function<void(Ranks&)>& what) {
    std::vector<std::thread> threads;
    for (int r = 0; r < n_; ++r) {
      threads.emplace_back([&, r] {
        One one(*this, r);
        what(one);
      });
    }
    for (std::thread& thread : threads) thread.join();
  }

 private:
  class One final : public Ranks {
   public:
    One(ThreadRanks& all, int r) : all_(all), rank_(r) {}
    [[nodiscard]] int rank() const override { return rank_; }
    [[nodiscard]] int size() const override { return all_.n_; }

    void gather(const void* mine, std::size_t bytes, void* to) override {
      show(mine);
      for (std::size_t r = 0; r < all_.data_.size(); ++r) {
        const auto* from = static_cast<const std::byte*>(all_.data_[r]);
        std::copy_n(from, bytes, static_cast<std::byte*>(to) + r * bytes);
      }
      all_.barrier_.arrive_and_wait();
    }
    /// Messages arrive as late as they may.
    void start_exchange(const std::vector<std::span<const std::byte>>& to,
                        const std::vector<std::span<std::byte>>& from) override {
      to_ = to;
      from_ = from;
      for (const auto& bytes : from) {
        const Bytes nothing(bytes.size(), std::byte{0xFF});
        all_.copy(bytes, nothing);
      }
    }
    void finish_exchange() override {
      show(&to_);
      for (std::size_t r = 0; r < from_.size(); ++r) {
        const auto& theirs = *static_cast<const std::vector<std::span<const std::byte>>*>(all_.data_[r]);
        const auto& message = theirs[static_cast<std::size_t>(rank_)];
        if (message.size() != from_[r].size()) std::abort();
        all_.copy(from_[r], message);
      }
      all_.barrier_.arrive_and_wait();
    }
    void sum(std::int64_t* numbers, std::size_t n) override {
      std::vector<std::int64_t> all(n * all_.data_.size());
      gather(numbers, n * sizeof(std::int64_t), all.data());
      std::fill_n(numbers, n, 0);
      for (std::size_t i = 0; i < all.size(); ++i) numbers[i % n] += all[i];
    }
    void largest(std::uint8_t* numbers, std::size_t n) override {
      std::vector<std::uint8_t> all(n * all_.data_.size());
      gather(numbers, n, all.data());
      for (std::size_t i = 0; i < all.size(); ++i) numbers[i % n] = std::max(numbers[i % n], all[i]);
    }
    [[nodiscard]] Traffic sent() const override { return {}; }
    [[nodiscard]] double waited() const override { return 0; }
    [[nodiscard]] int on_this_machine() const override { return all_.n_; }
    [[nodiscard]] int place_on_this_machine() const override { return rank_; }
    [[nodiscard]] bool takes_device_memory() const override { return bool(all_.between_devices_); }
    [[noreturn]] void abandon() override { std::abort(); }

   private:
    void show(const void* what) {
      all_.data_[static_cast<std::size_t>(rank_)] = what;
      all_.barrier_.arrive_and_wait();
    }
    ThreadRanks& all_;
    int rank_;
    std::vector<std::span<const std::byte>> to_;
    std::vector<std::span<std::byte>> from_;
  };

  void copy(std::span<std::byte> to, std::span<const std::byte> from) const {
    if (between_devices_) {
      between_devices_(to.data(), from.data(), from.size());
    } else {
      std::copy(from.begin(), from.end(), to.begin());
    }
  }

  int n_;
  Copy between_devices_;
  std::barrier<> barrier_;
  std::vector<const void*> data_;
};

}  // namespace thalweg::test
