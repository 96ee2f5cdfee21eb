#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/error.hpp"
#include "common/first_problem.hpp"
#include "common/ranks.hpp"
#include "solver/backend/device.hpp"
#include "solver/backend/device_link.hpp"

// Messages that go from the memory of one rank's device to that of another. An MPI may say that it takes them and fail, and so
// may a link between the devices, so that they are tried before they are used.
namespace thalweg {

/// The i-th byte of a message that is sent for a trial.
HOST_DEVICE inline std::byte trial_byte(Index sender, Index i) {
  return static_cast<std::byte>((i * 31 + i / 256 * 7 + sender * 101) & 0xFF);
}

/// Particle pass: writes the message.
struct TrialPass {
  using reads = Reads<>;
  using writes = Writes<>;
  std::byte* message;
  Index sender;
  HOST_DEVICE void operator()(Index i) const { message[i] = trial_byte(sender, i); }
};

/// Terms of a sum: 1 for a byte that is wrong.
struct WrongByte {
  using reads = Reads<>;
  using writes = Writes<>;
  const std::byte* message;
  Index sender;
  HOST_DEVICE Index operator()(Index i) const { return message[i] == trial_byte(sender, i) ? 0 : 1; }
};

struct AddIndices {
  HOST_DEVICE Index operator()(Index a, Index b) const { return a + b; }
};

/// A message to the next rank, and room for that of the rank before.
template <class Device>
class Trial {
 public:
  Trial(Device& on, Ranks& ranks, Index bytes)
      : to(static_cast<std::size_t>(ranks.size())),
        from(to.size()),
        on_(on),
        before_((static_cast<std::size_t>(ranks.rank()) + to.size() - 1) % to.size()) {
    const auto rank = static_cast<std::size_t>(ranks.rank());
    sent_.resize(bytes);
    received_.resize(bytes);
    on.for_each(bytes, TrialPass{sent_.data(), static_cast<Index>(rank)});
    on.for_each(bytes, TrialPass{received_.data(), static_cast<Index>(to.size())});  // no rank's
    to[(rank + 1) % to.size()] = {sent_.data(), bytes};
    from[before_] = {received_.data(), bytes};
  }
  /// True if the right bytes are there.
  [[nodiscard]] bool has_arrived() const {
    const WrongByte wrong{received_.data(), static_cast<Index>(before_)};
    return on_.reduce_here(static_cast<Index>(received_.size()), Index{0}, wrong, AddIndices{}) == 0;
  }

  std::vector<std::span<const std::byte>> to;
  std::vector<std::span<std::byte>> from;

 private:
  Device& on_;
  std::size_t before_;
  typename Device::Message sent_{true};
  typename Device::Message received_{true};
};

/// Few and many, for which messages take different ways.
constexpr std::initializer_list<Index> trial_sizes = {Index{1000}, Index{1} << 20};

/// True on all ranks if MPI can send from each device's memory to that of another: the ranks say so, and the right bytes
/// arrive.
template <class Device>
bool messages_go_between_devices(Device& on, Ranks& ranks) {
  std::uint8_t fails = ranks.takes_device_memory() && ranks.size() > 1 ? 0 : 1;
  ranks.largest(&fails, 1);
  for (const Index bytes : trial_sizes) {
    if (fails != 0) return false;
    Trial<Device> trial(on, ranks, bytes);
    on.finish();
    ranks.exchange(trial.to, trial.from);
    fails = trial.has_arrived() ? 0 : 1;
    ranks.largest(&fails, 1);
  }
  return fails == 0;
}

/// Why messages over the link do not arrive on some rank.
template <class Device>
RankProblem try_link(Device& on, Ranks& ranks, DeviceLink& link) {
  for (const Index bytes : trial_sizes) {
    Trial<Device> trial(on, ranks, bytes);
    RankProblem found = first_problem(ranks, problem_of([&] { link.start(trial.to, trial.from); }));
    if (found.text.empty()) {
      found =
          first_problem(ranks, problem_of([&] {
                          link.finish();
                          if (!trial.has_arrived()) {
                            throw RunError("a message of " + std::to_string(bytes) + " bytes arrives with other bytes");
                          }
                        }));
    }
    if (found.text.empty()) continue;
    link.give_up();  // before the memory goes for which a message may still be on its way
    return found;
  }
  return {};
}

/// A link between the ranks' devices that has been tried. Throws InputError on all ranks if there is none.
template <class Device>
std::unique_ptr<DeviceLink> tried_link(Device& on, Ranks& ranks, LinkMaker& links) {
  LinkPart mine;
  std::unique_ptr<DeviceLink> link;
  std::string shared;
  RankProblem found = first_problem(ranks, problem_of([&] { mine = links.part(ranks.rank() == 0); }));
  if (found.text.empty()) {
    const std::vector<LinkPart> parts = gather_from(ranks, mine);
    shared = shared_device(parts);
    if (!shared.empty()) throw InputError("--device-messages nccl: " + shared + ", or leave --device-messages away");
    found = first_problem(ranks, problem_of([&] { link = links.link(parts.front(), ranks, on.queue()); }));
  }
  if (found.text.empty()) {
    found = try_link(on, ranks, *link);
  } else if (link != nullptr) {
    link->give_up();
  }
  if (!found.text.empty()) {
    throw InputError("--device-messages nccl: rank " + std::to_string(found.rank) + ": " + found.text +
                     "; leave --device-messages away to send another way");
  }
  return link;
}

/// The messages of copies between a rank's device and those of others, the way that is wished for.
template <class Device>
class CopyMessages {
 public:
  /// Throws InputError on all ranks if a way that was named does not work.
  void choose(Device& on, Ranks& ranks, const MessageWish& wish) {
    if (ranks.size() == 1 || wish.way == MessageWay::host) return;
    if (wish.way == MessageWay::nccl) {
      link_ = tried_link(on, ranks, *wish.links);
      return;
    }
    by_mpi_ = messages_go_between_devices(on, ranks);
    if (wish.way == MessageWay::mpi && !by_mpi_) {
      throw InputError(
          "--device-messages mpi: this MPI does not send from the memory of the GPUs; take one that is built with "
          "CUDA, or leave --device-messages away to send by way of the host");
    }
  }
  /// True if they lie in the devices' memory, false if the host reaches them, too.
  [[nodiscard]] bool lie_on_devices() const { return by_mpi_ || link_ != nullptr; }
  [[nodiscard]] const char* way() const {
    if (link_ != nullptr) return "messages by NCCL";
    return by_mpi_ ? "messages from its memory" : "messages by way of the host";
  }

  /// Sends what the device has been told to write, and receives where it has been told to read before.
  void start(Device& on, Ranks& ranks, const std::vector<std::span<const std::byte>>& to,
             const std::vector<std::span<std::byte>>& from) {
    if (link_ != nullptr) return link_->start(to, from);
    on.finish();  // the ranks know nothing of the order of the device's work
    ranks.start_exchange(to, from);
  }
  void finish(Ranks& ranks) {
    if (link_ != nullptr) return link_->finish();
    ranks.finish_exchange();
  }
  void progress(Ranks& ranks) {
    if (link_ == nullptr) ranks.progress();
  }

 private:
  bool by_mpi_ = false;
  std::unique_ptr<DeviceLink> link_;
};

}  // namespace thalweg
