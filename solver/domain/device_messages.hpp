#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

#include "common/ranks.hpp"
#include "solver/backend/device.hpp"

// Messages that go from the memory of one rank's device to that of another. An MPI may say that it takes them and fail, so
// that they are tried before they are used.
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

/// Sends so many bytes to the next rank. True if those of the rank before have arrived.
template <class Device>
bool trial_arrives(Device& on, Ranks& ranks, Index bytes) {
  const auto n = static_cast<std::size_t>(ranks.size());
  const auto rank = static_cast<std::size_t>(ranks.rank());
  const std::size_t before = (rank + n - 1) % n;
  typename Device::Message sent(true);
  typename Device::Message received(true);
  sent.resize(bytes);
  received.resize(bytes);
  on.for_each(bytes, TrialPass{sent.data(), static_cast<Index>(rank)});
  on.for_each(bytes, TrialPass{received.data(), static_cast<Index>(n)});  // no rank's
  on.finish();
  std::vector<std::span<const std::byte>> to(n);
  std::vector<std::span<std::byte>> from(n);
  to[(rank + 1) % n] = {sent.data(), bytes};
  from[before] = {received.data(), bytes};
  ranks.exchange(to, from);
  return on.reduce_here(bytes, Index{0}, WrongByte{received.data(), static_cast<Index>(before)}, AddIndices{}) == 0;
}

/// True on all ranks if each can send from its device's memory to that of another: the ranks say so, and the right bytes
/// arrive, few and many, for which MPI takes different ways.
template <class Device>
bool messages_go_between_devices(Device& on, Ranks& ranks) {
  std::uint8_t fails = ranks.takes_device_memory() && ranks.size() > 1 ? 0 : 1;
  ranks.largest(&fails, 1);
  for (const Index bytes : {Index{1000}, Index{1} << 20}) {
    if (fails != 0) return false;
    fails = trial_arrives(on, ranks, bytes) ? 0 : 1;
    ranks.largest(&fails, 1);
  }
  return fails == 0;
}

}  // namespace thalweg
