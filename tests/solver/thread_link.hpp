#pragma once

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "solver/backend/device_link.hpp"

// A link between the stand-ins for GPUs (guarded_runtime.hpp) of ranks that are threads.
namespace thalweg::test {

/// Copies on a device.
using DeviceCopy = std::function<void(void* to, const void* from, std::size_t bytes)>;

/// Messages leave as late as they may, in finish(); until then their room is full of ones.
class ThreadLink final : public DeviceLink {
 public:
  ThreadLink(Ranks& ranks, DeviceCopy copy) : ranks_(ranks), copy_(std::move(copy)) {}

  void start(const std::vector<std::span<const std::byte>>& to,
             const std::vector<std::span<std::byte>>& from) override {
    to_ = to;
    from_ = from;
    for (const auto& room : from) {
      const Bytes ones(room.size(), std::byte{0xFF});
      copy_(room.data(), ones.data(), ones.size());
    }
  }
  void finish() override {
    const auto* const mine = &to_;
    const auto all = gather_from(ranks_, mine);
    for (std::size_t r = 0; r < from_.size(); ++r) {
      const auto& message = (*all[r])[static_cast<std::size_t>(ranks_.rank())];
      if (message.size() != from_[r].size()) std::abort();
      copy_(from_[r].data(), message.data(), message.size());
    }
    gather_from(ranks_, 0);  // all have read
  }
  void give_up() noexcept override {}

 private:
  Ranks& ranks_;
  DeviceCopy copy_;
  std::vector<std::span<const std::byte>> to_;
  std::vector<std::span<std::byte>> from_;
};

/// Every rank has a device of its own.
class ThreadLinks : public LinkMaker {
 public:
  LinkPart part(bool /*is_first*/) override {
    LinkPart mine;
    const int number = ++devices_;
    std::memcpy(mine.device.data(), &number, sizeof(number));
    return mine;
  }
  /// The queue of a stand-in is its copying.
  std::unique_ptr<DeviceLink> link(const LinkPart& /*first*/, Ranks& ranks, void* queue) override {
    using Copy = void (*)(void*, const void*, std::size_t);
    return std::make_unique<ThreadLink>(ranks, *static_cast<Copy*>(queue));
  }

 private:
  std::atomic<int> devices_ = 0;
};

}  // namespace thalweg::test
