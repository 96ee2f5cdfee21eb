#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

namespace thalweg {

/// Allocator on cache-line boundaries that leaves numbers uninitialised: large arrays are written before they are read.
template <class T>
struct CacheLineAllocator {
  using value_type = T;
  static constexpr std::size_t line = 64;

  CacheLineAllocator() = default;
  template <class U>
  CacheLineAllocator(const CacheLineAllocator<U>&) {}

  T* allocate(std::size_t n) {
    const std::size_t bytes = (n * sizeof(T) + line - 1) / line * line;
    void* memory = std::aligned_alloc(line, bytes == 0 ? line : bytes);
    if (memory == nullptr) throw std::bad_alloc();
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }
  template <class U>
  bool operator==(const CacheLineAllocator<U>&) const {
    return true;
  }
};

/// An array in the memory of the OpenMP backend's device, which is the host.
template <class T>
using HostBuffer = std::vector<T, CacheLineAllocator<T>>;

}  // namespace thalweg
