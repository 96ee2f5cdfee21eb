#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

// Several processes that compute one scene together, each a part of its particles. They run the same code in the same
// order: what a rank does next depends on numbers that all ranks have. The communication itself is behind Ranks: MPI's
// (solver/domain/mpi), or, in the tests, that of threads.
namespace thalweg {

using Bytes = std::vector<std::byte>;

/// Counts of what a rank has sent since it began.
struct Traffic {
  std::int64_t collectives = 0;  // sums, largest numbers and gatherings of all ranks
  std::int64_t messages = 0;     // to single ranks
  std::int64_t bytes = 0;        // of both, of a collective once
};

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
  /// to[r] goes to rank r; from[r], whose size is known, comes from there. Empty ones are no messages. The bytes belong to the
  /// ranks until finish_exchange() is over; until then nothing but progress() is called.
  virtual void start_exchange(const std::vector<std::span<const std::byte>>& to,
                              const std::vector<std::span<std::byte>>& from) = 0;
  virtual void finish_exchange() = 0;
  /// Lets the messages that are on their way go on. A rank that computes meanwhile calls it now and then, in the thread that
  /// has started the exchange.
  virtual void progress() {}
  void exchange(const std::vector<std::span<const std::byte>>& to, const std::vector<std::span<std::byte>>& from) {
    start_exchange(to, from);
    finish_exchange();
  }
  /// Replaces n numbers by their sums over all ranks.
  virtual void sum(std::int64_t* numbers, std::size_t n) = 0;
  /// Replaces n bytes by the largest of all ranks.
  virtual void largest(std::uint8_t* numbers, std::size_t n) = 0;
  [[nodiscard]] virtual Traffic sent() const = 0;
  /// Time that this rank has spent in the functions above, mostly waiting for others [s].
  [[nodiscard]] virtual double waited() const = 0;
  /// Number of the ranks on this machine, and this one's among them.
  [[nodiscard]] virtual int on_this_machine() const = 0;
  [[nodiscard]] virtual int place_on_this_machine() const = 0;
  /// True if exchange() takes addresses of GPUs' memory, as far as MPI knows.
  [[nodiscard]] virtual bool takes_device_memory() const { return false; }
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

/// Bytes from one rank to another, of which all know; empty on the others.
inline Bytes send(Ranks& ranks, const Bytes& mine, int from, int to) {
  const auto n = static_cast<std::size_t>(ranks.size());
  const bool sends = ranks.rank() == from;
  const auto size = gather_from(ranks, std::uint64_t{sends ? mine.size() : 0})[static_cast<std::size_t>(from)];
  Bytes received(ranks.rank() == to ? size : 0);
  std::vector<std::span<const std::byte>> out(n);
  std::vector<std::span<std::byte>> in(n);
  if (sends) out[static_cast<std::size_t>(to)] = mine;
  if (ranks.rank() == to) in[static_cast<std::size_t>(from)] = received;
  ranks.exchange(out, in);
  return received;
}

/// The bytes of one rank to all.
inline Bytes broadcast(Ranks& ranks, const Bytes& mine, int root = 0) {
  const auto n = static_cast<std::size_t>(ranks.size());
  const bool sends = ranks.rank() == root;
  Bytes received(gather_from(ranks, std::uint64_t{sends ? mine.size() : 0})[static_cast<std::size_t>(root)]);
  std::vector<std::span<std::byte>> in(n);
  in[static_cast<std::size_t>(root)] = received;
  ranks.exchange(std::vector<std::span<const std::byte>>(
                     n, sends ? std::span<const std::byte>(mine) : std::span<const std::byte>()),
                 in);
  return received;
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

}  // namespace thalweg
