#include <thrust/execution_policy.h>
#include <thrust/sort.h>
#include <thrust/system/omp/execution_policy.h>

#include "solver/backend/openmp.hpp"

namespace thalweg {

void stable_sort_by_key(HostBuffer<std::uint64_t>& key, HostBuffer<Index>& order) {
  // Below this a parallel sort costs more in waiting than it saves.
  constexpr std::size_t worth_threads = 100'000;
  if (key.size() < worth_threads) {
    thrust::stable_sort_by_key(thrust::seq, key.begin(), key.end(), order.begin());
  } else {
    thrust::stable_sort_by_key(thrust::omp::par, key.begin(), key.end(), order.begin());
  }
}

}  // namespace thalweg
