#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <new>
#include <vector>

#include "solver/backend/gpu.hpp"

namespace thalweg::test {

/// Stands for a GPU where there is none: what Gpu and the passes do runs as on one, a thread after the other. Its
/// memory can be touched only while "the device" works, and ends where an inaccessible page begins: host code that
/// reads device memory, and a thread that writes past an array's end, crash at once.
struct GuardedRuntime {
  static void* allocate(std::size_t bytes) {
    const std::size_t page = page_size();
    const std::size_t used = (bytes + 15) / 16 * 16;
    const std::size_t whole = (used + page - 1) / page * page;
    void* block = mmap(nullptr, whole + page, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (block == MAP_FAILED) throw std::bad_alloc();
    char* memory = static_cast<char*>(block) + whole - used;
    blocks()[memory] = {block, whole};
    return memory;
  }
  static void release(void* p) noexcept {
    if (p == nullptr) return;
    const auto found = blocks().find(p);
    munmap(found->second.begin, found->second.bytes + page_size());
    blocks().erase(found);
  }
  static void copy_to_device(void* to, const void* from, std::size_t bytes) {
    const AtWork at_work;
    memcpy(to, from, bytes);
  }
  static void copy_to_host(void* to, const void* from, std::size_t bytes) { copy_to_device(to, from, bytes); }
  static void copy_on_device(void* to, const void* from, std::size_t bytes) { copy_to_device(to, from, bytes); }

  static void wait() {}
  static void atomic_add(std::int64_t* counter, std::int64_t amount) { *counter += amount; }

  template <class Body>
  static void launch(Index n, const Body& body) {
    const AtWork at_work;
    for (Index i = 0; i < n; ++i) body(i);
  }
  template <class T, class Of, class Combine>
  static T reduce(Index n, const T& start, const Of& of, const Combine& combine) {
    const AtWork at_work;
    T sum = start;
    for (Index i = 0; i < n; ++i) sum = combine(sum, of(i));
    return sum;
  }
  static void scan(const Index* counts, Index n, Index* offsets) {
    const AtWork at_work;
    offsets[0] = 0;
    for (Index i = 0; i < n; ++i) offsets[i + 1] = offsets[i] + counts[i];
  }
  template <class Keep>
  static Index select(Index n, const Keep& keep, Index* kept) {
    const AtWork at_work;
    Index found = 0;
    for (Index i = 0; i < n; ++i) {
      if (keep(i)) kept[found++] = i;
    }
    return found;
  }
  static void sort(std::uint64_t* key, Index* order, Index n) {
    const AtWork at_work;
    std::vector<std::pair<std::uint64_t, Index>> both(n);
    for (Index i = 0; i < n; ++i) both[i] = {key[i], order[i]};
    std::stable_sort(both.begin(), both.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (Index i = 0; i < n; ++i) key[i] = both[i].first, order[i] = both[i].second;
  }

 private:
  struct Block {
    void* begin;
    std::size_t bytes;
  };
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
    AtWork() { protect(PROT_READ | PROT_WRITE); }
    ~AtWork() { protect(PROT_NONE); }
    AtWork(const AtWork&) = delete;
    AtWork& operator=(const AtWork&) = delete;
    static void protect(int access) {
      for (const auto& [memory, block] : blocks()) mprotect(block.begin, block.bytes, access);
    }
  };
};

}  // namespace thalweg::test
