#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/ranks.hpp"

// Messages that the devices of ranks carry themselves, from the memory of one to that of another (NCCL, nccl/nccl_link.cpp).
namespace thalweg {

/// Messages in the order of the device's work, for which the host does not wait. All ranks call start() and finish() in the
/// same order. They throw std::runtime_error, which names the call that has failed.
class DeviceLink {
 public:
  DeviceLink() = default;
  virtual ~DeviceLink() = default;
  DeviceLink(const DeviceLink&) = delete;
  DeviceLink& operator=(const DeviceLink&) = delete;

  /// to[r] goes to rank r, and from[r], whose size is known, comes from there, after what the device was given so far. Empty
  /// ones are no messages. The device may be given other work meanwhile, which touches none of these bytes.
  virtual void start(const std::vector<std::span<const std::byte>>& to,
                     const std::vector<std::span<std::byte>>& from) = 0;
  /// From here on the device does what it is given after the messages have come and gone.
  virtual void finish() = 0;
  /// Ends the messages that another rank will not send, for which the device would wait for ever.
  virtual void give_up() noexcept = 0;
};

/// A rank says this of itself before devices are linked.
struct LinkPart {
  std::array<unsigned char, 16> device{};  // its device, among those of all machines
  std::array<char, 128> meeting{};         // where the ranks find each other; the first rank's is taken
};

/// Makes links. Each rank calls the functions, which may fail on some of them only.
class LinkMaker {
 public:
  LinkMaker() = default;
  virtual ~LinkMaker() = default;
  LinkMaker(const LinkMaker&) = delete;
  LinkMaker& operator=(const LinkMaker&) = delete;

  virtual LinkPart part(bool is_first) = 0;
  /// queue: where the device takes its work from, in order (Runtime::queue(); a CUDA stream).
  virtual std::unique_ptr<DeviceLink> link(const LinkPart& first, Ranks& ranks, void* queue) = 0;
};

/// Why these ranks' devices cannot be linked: two of them are one device. Empty if each rank has its own.
inline std::string shared_device(const std::vector<LinkPart>& parts) {
  for (std::size_t b = 1; b < parts.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      if (parts[a].device != parts[b].device) continue;
      return "ranks " + std::to_string(a) + " and " + std::to_string(b) +
             " share a GPU, and NCCL needs one for each; start no more ranks on a machine than it has GPUs";
    }
  }
  return {};
}

/// The way of copies of particles from one GPU to another.
enum class MessageWay {
  automatic,  // by MPI from the GPUs' memory where that works, else by way of the host
  host,
  mpi,
  nccl
};

struct MessageWish {
  MessageWay way = MessageWay::automatic;
  LinkMaker* links = nullptr;  // of MessageWay::nccl
};

}  // namespace thalweg
