#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <mutex>
#include <new>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/backend/gpu.hpp"

namespace thalweg::test {

/// The order in which the threads of a launch run: forward, or as the environment's THALWEG_THREAD_ORDER says, "reverse" or
/// "scrambled". A result that depends on it would be a race on a GPU.
class ThreadOrder {
 public:
  explicit ThreadOrder(Index n) : n_(n), step_(1), first_(0) {
    if (kind() == Kind::reverse) first_ = n == 0 ? 0 : n - 1, step_ = n == 0 ? 0 : n - 1;
    if (kind() == Kind::scrambled && n > 1) {
      first_ = n / 3;
      for (step_ = n / 2 + n / 8 + 1; std::gcd(std::uint64_t{step_}, std::uint64_t{n}) != 1; ++step_) continue;
    }
  }
  /// The i-th thread that runs: each once, a fixed step apart around the end.
  Index operator[](Index i) const {
    return static_cast<Index>((std::uint64_t{first_} + std::uint64_t{i} * step_) % n_);
  }

 private:
  enum class Kind { forward, reverse, scrambled };
  static Kind kind() {
    static const Kind chosen = [] {
      const char* name = getenv("THALWEG_THREAD_ORDER");
      const std::string order = name == nullptr ? "forward" : name;
      if (order == "forward") return Kind::forward;
      if (order == "reverse") return Kind::reverse;
      if (order == "scrambled") return Kind::scrambled;
      throw std::invalid_argument("THALWEG_THREAD_ORDER=" + order + ": forward, reverse or scrambled");
    }();
    return chosen;
  }
  Index n_;
  Index step_;
  Index first_;
};

/// A team of 32 threads (solver/backend/gpu.hpp) that run one after the other.
struct GuardedTeam {
  static constexpr Index size = 32;
  template <class T>
  struct PerLane {
    T of[size] = {};
    T& operator[](Index lane) { return of[lane]; }
  };
  template <class What>
  void each(const What& what) {
    const ThreadOrder order(size);
    for (Index i = 0; i < size; ++i) what(order[i]);
  }
  template <class What>
  void once(const What& what) {
    what();
  }
  template <class What>
  std::uint32_t ballot(const What& what) {
    std::uint32_t bits = 0;
    each([&](Index lane) { bits |= what(lane) ? 1U << lane : 0U; });
    return bits;
  }
  template <class What>
  std::uint32_t any_bits(const What& what) {
    std::uint32_t bits = 0;
    each([&](Index lane) { bits |= what(lane); });
    return bits;
  }
  template <class T>
  T get(const PerLane<T>& of, Index lane) {
    return of.of[lane];
  }
};

/// Stands for a GPU where there is none: what Gpu and the passes do runs as on one, a thread after the other, in one of
/// several orders (ThreadOrder). Its memory can be touched only while "the device" works, and ends where an inaccessible
/// page begins: host code that reads device memory, and a thread that writes past an array's end, crash at once. Fresh
/// memory is full of ones, which are NaN as floats and far out of range as numbers: what is read before it is written
/// shows.
struct GuardedRuntime {
  static void* allocate(std::size_t bytes) {
    if (recorder() != nullptr) throw std::logic_error("memory allocated while launches are recorded");
    const std::size_t page = page_size();
    const std::size_t used = (bytes + 15) / 16 * 16;
    const std::size_t whole = (used + page - 1) / page * page;
    const std::lock_guard alone(mutex());
    char* block = arena().take(whole);
    char* memory = block + whole - used;
    memset(memory, 0xFF, used);
    mprotect(block, whole, PROT_NONE);
    blocks()[memory] = {block, whole, bytes};
    in_use() += bytes;
    peak() = std::max(peak(), in_use());
    return memory;
  }
  static void release(void* p) noexcept {
    if (p == nullptr) return;
    const std::lock_guard alone(mutex());
    const auto found = blocks().find(p);
    if (found == blocks().end()) std::abort();  // not from allocate(), or given back twice
    in_use() -= found->second.asked;
    arena().give_back(found->second.begin, found->second.bytes);
    blocks().erase(found);
  }
  static void* allocate_message(std::size_t bytes) { return allocate(bytes); }
  static void release_message(void* p) noexcept { release(p); }
  static void* allocate_on_host(std::size_t bytes) { return ::operator new(bytes); }
  static void release_on_host(void* p) noexcept { ::operator delete(p); }
  static void copy_to_device(void* to, const void* from, std::size_t bytes) { copy(to, from, bytes); }
  static void send(void* to, const void* from, std::size_t bytes) { copy(to, from, bytes); }
  /// The host waits for the device here.
  static void copy_to_host(void* to, const void* from, std::size_t bytes) {
    ++waits();
    copy(to, from, bytes);
  }
  struct Mark {};
  /// Not waited for by the thread that launches.
  static void copy_to_host_after(const Mark&, void* to, const void* from, std::size_t bytes) { copy(to, from, bytes); }
  static void copy_on_device(void* to, const void* from, std::size_t bytes) { copy(to, from, bytes); }

  /// Bytes that are allocated, and the most that were.
  static std::size_t& in_use() {
    static std::size_t n = 0;
    return n;
  }
  static std::size_t& peak() {
    static std::size_t n = 0;
    return n;
  }

  /// The number of times that the host has waited for the device.
  static int& waits() {
    static int n = 0;
    return n;
  }
  static void wait() {}
  /// A link between stand-ins needs their copying alone (thread_link.hpp).
  static void* queue() {
    static void (*copy)(void*, const void*, std::size_t) = copy_on_device;
    return &copy;
  }

  /// Narrower access to some memory while the device works (PROT_NONE, PROT_READ): for tests of what bodies touch.
  static std::map<const void*, int>& limits() {
    static std::map<const void*, int> all;
    return all;
  }
  static void atomic_add(std::int64_t* counter, std::int64_t amount) { *counter += amount; }

  template <class Body>
  static void launch(Index n, const Body& body, const int* flag) {
    submit([=] {
      const ThreadOrder order(n);
      for (Index i = 0; is_on(flag) && i < n; ++i) body(order[i]);
    });
  }
  template <class Body>
  static void launch_teams(Index n, const Body& body, const int* flag) {
    submit([=] {
      const ThreadOrder order(n);
      for (Index i = 0; is_on(flag) && i < n; ++i) {
        GuardedTeam team;
        body(order[i], team);
      }
    });
  }
  template <class T, class Of, class Combine, class Then>
  static void reduce(Index n, const T& start, const Of& of, const Combine& combine, const Then& then, const int* flag) {
    submit([=] {
      if (!is_on(flag)) return;
      const ThreadOrder order(n);
      T sum = start;
      for (Index i = 0; i < n; ++i) sum = combine(sum, of(order[i]));
      then(sum);
    });
  }
  template <class T, class Work>
  static T with_result(const Work& work) {
    T* on_device = static_cast<T*>(allocate(sizeof(T)));
    work(on_device);
    T result;
    copy_to_host(&result, on_device, sizeof(T));
    release(on_device);
    return result;
  }

  /// Launches made while it records are kept instead, and all made again by every replay.
  class Recording {
   public:
    template <class What>
    void record(const What& what) {
      launches_.clear();
      recorder() = this;
      what();
      recorder() = nullptr;
    }
    void replay() {
      ++replays();
      for (const auto& launch : launches_) submit(launch);
    }
    static int& replays() {
      static int n = 0;
      return n;
    }

   private:
    friend GuardedRuntime;
    std::vector<std::function<void()>> launches_;
  };

  static void scan(const Index* counts, Index n, Index* offsets) {
    const AtWork at_work;
    offsets[0] = 0;
    for (Index i = 0; i < n; ++i) offsets[i + 1] = offsets[i] + counts[i];
  }
  template <class Candidate, class Keep>
  static void select(Index n, const Candidate& candidate, const Keep& keep, Index* kept, Index* count) {
    const AtWork at_work;
    std::vector<std::uint8_t> is_kept(n);
    const ThreadOrder order(n);
    for (Index i = 0; i < n; ++i) is_kept[order[i]] = keep(candidate(order[i])) ? 1 : 0;
    Index found = 0;
    for (Index i = 0; i < n; ++i) {
      if (is_kept[i] != 0) kept[found++] = candidate(i);
    }
    *count = found;
  }
  static void sort(std::uint64_t* key, Index* order, Index n, int used_bits) {
    const AtWork at_work;
    std::vector<std::pair<std::uint64_t, Index>> both(n);
    for (Index i = 0; i < n; ++i) {
      if (used_bits < 64 && key[i] >> used_bits != 0) throw std::logic_error("a key has more bits than are sorted");
      both[i] = {key[i], order[i]};
    }
    std::stable_sort(both.begin(), both.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (Index i = 0; i < n; ++i) key[i] = both[i].first, order[i] = both[i].second;
  }

 private:
  static std::recursive_mutex& mutex() {
    static std::recursive_mutex one;
    return one;
  }
  static bool is_on(const int* flag) { return flag == nullptr || *flag != 0; }
  /// A recording holds launches and nothing else.
  static void copy(void* to, const void* from, std::size_t bytes) {
    if (recorder() != nullptr) throw std::logic_error("memory copied while launches are recorded");
    if (bytes == 0) return;  // memcpy would tell the compiler that neither address is null
    const AtWork at_work;
    memcpy(to, from, bytes);
  }
  /// Of this thread: another one may copy meanwhile.
  static Recording*& recorder() {
    static thread_local Recording* now = nullptr;
    return now;
  }
  template <class Launch>
  static void submit(const Launch& launch) {
    if (recorder() != nullptr) {
      recorder()->launches_.emplace_back(launch);
      return;
    }
    const AtWork at_work;
    launch();
  }

  struct Block {
    char* begin;
    std::size_t bytes;
    std::size_t asked;
  };

  /// The addresses of all blocks, one range, so that one call opens or closes all of them: a call for each took three quarters
  /// of the tests' time. Between the blocks and where there is none lies a file without contents, which nobody can touch
  /// even where the range is open.
  class Arena {
   public:
    Arena() {
      void* range = mmap(nullptr, size, PROT_NONE, MAP_SHARED | MAP_NORESERVE, file_, 0);
      if (file_ < 0 || range == MAP_FAILED) throw std::bad_alloc();
      begin_ = end_ = static_cast<char*>(range);
    }
    char* take(std::size_t bytes) {
      std::vector<char*>& free = free_[bytes];
      char* at = end_;
      if (free.empty()) {
        end_ += bytes + page_size();
        if (end_ > begin_ + size) throw std::bad_alloc();
      } else {
        at = free.back();
        free.pop_back();
      }
      constexpr int flags = MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED;
      if (bytes > 0 && mmap(at, bytes, PROT_READ | PROT_WRITE, flags, -1, 0) == MAP_FAILED) throw std::bad_alloc();
      return at;
    }
    void give_back(char* at, std::size_t bytes) {
      if (bytes > 0) mmap(at, bytes, PROT_NONE, MAP_SHARED | MAP_NORESERVE | MAP_FIXED, file_, at - begin_);
      free_[bytes].push_back(at);
    }
    void protect(int access) const {
      if (end_ > begin_) mprotect(begin_, static_cast<std::size_t>(end_ - begin_), access);
    }

   private:
    static constexpr std::size_t size = std::size_t{1} << 42;
    int file_ = memfd_create("nothing", MFD_CLOEXEC);
    char* begin_ = nullptr;
    char* end_ = nullptr;                             // of what has been taken
    std::map<std::size_t, std::vector<char*>> free_;  // by size
  };
  static Arena& arena() {
    static auto* one = new Arena;
    return *one;
  }
  static std::map<void*, Block>& blocks() {
    static auto* all = new std::map<void*, Block>;
    return *all;
  }
  static std::size_t page_size() {
    static const auto size = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    return size;
  }
  /// Opens the device's memory while it lives.
  struct AtWork {
    const std::lock_guard<std::recursive_mutex> alone{mutex()};  // another thread may copy a snapshot meanwhile
    AtWork() { protect(PROT_READ | PROT_WRITE); }
    ~AtWork() { protect(PROT_NONE); }
    AtWork(const AtWork&) = delete;
    AtWork& operator=(const AtWork&) = delete;
    static void protect(int access) {
      arena().protect(access);
      for (const auto& [memory, limit] : limits()) {
        const auto block = blocks().find(const_cast<void*>(memory));
        if (block != blocks().end()) mprotect(block->second.begin, block->second.bytes, access & limit);
      }
    }
  };
};

}  // namespace thalweg::test
