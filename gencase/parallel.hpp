#pragma once

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <cstdint>

#include "gencase/progress.hpp"

namespace thalweg::gencase {

/// Calls `body(begin, end)` for parts of [0, count) on all cores and reports the progress.
template <class Body>
void for_parts(std::int64_t count, Progress& progress, Body&& body) {
  tbb::parallel_for(tbb::blocked_range<std::int64_t>(0, count, 16), [&](const tbb::blocked_range<std::int64_t>& part) {
    body(part.begin(), part.end());
    progress.add(part.end() - part.begin());
  });
}

/// One value for each thread. `total()` sums them up by `add(sum, part)`.
template <class T>
class PerThread {
 public:
  T& local() { return values_.local(); }
  template <class Add>
  T total(Add&& add) {
    T sum{};
    values_.combine_each([&](const T& part) { add(sum, part); });
    return sum;
  }

 private:
  tbb::enumerable_thread_specific<T> values_;
};

}  // namespace thalweg::gencase
