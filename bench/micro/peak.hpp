#pragma once

#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>

#include "solver/backend/buffer.hpp"
#include "solver/backend/pack.hpp"

/// The largest rates that the machine reaches.
namespace thalweg::peak {

/// Twelve independent chains of multiply-add hide its latency.
inline void multiply_add(benchmark::State& state) {
  using L = Pack<native_width>;
  constexpr int chains = 12, turns = 256;
  std::array<L, chains> sum{};
  L factor(0.999F), term(1e-3F);
  for (auto _ : state) {
    benchmark::DoNotOptimize(factor);
    for (int n = 0; n < turns; ++n) {
      for (L& s : sum) s = s * factor + term;
    }
    benchmark::DoNotOptimize(sum);
  }
  state.counters["flop/s"] =
      benchmark::Counter(2.0 * chains * turns * native_width, benchmark::Counter::kIsIterationInvariantRate);
}

/// Reads an array of so many bytes once an iteration.
inline void read_memory(benchmark::State& state) {
  using L = Pack<native_width>;
  const HostBuffer<float> numbers(static_cast<std::size_t>(state.range(0)) / sizeof(float), 1.0F);
  for (auto _ : state) {
    std::array<L, 8> sum{};
    for (std::size_t i = 0; i < numbers.size(); i += 8 * native_width) {
      for (std::size_t k = 0; k < 8; ++k) {
        L read;
        lane_load(&numbers[i + k * native_width], read);
        sum[k] += read;
      }
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetBytesProcessed(state.iterations() * state.range(0));
}

}  // namespace thalweg::peak
