// A core module that stands for a GPU in what make_simulation asks before it makes anything. The environment says what is
// wrong with it: FAKE_GPU_MEMORY (free bytes), FAKE_GPU_PROBLEM (why it cannot be used), FAKE_GPU_OF (the rank whose GPU that
// is; without it all ranks'), FAKE_GPUS (their number, one a rank where it is not 1).
#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "common/error.hpp"
#include "solver/simulation/input.hpp"

#define THALWEG_EXPORT extern "C" __attribute__((visibility("default")))

THALWEG_EXPORT thalweg::Simulation* thalweg_make_simulation(const thalweg::SimulationInput* /*input*/) {
  throw thalweg::RunError("CUDA, while allocating memory: out of memory");
}

namespace {
thread_local int chosen = 0;  // by this rank, which is a thread
}

THALWEG_EXPORT void thalweg_choose_device(int place) { chosen = place; }

THALWEG_EXPORT void thalweg_name_device(std::uint8_t* name) {
  const char* gpus = getenv("FAKE_GPUS");
  std::fill_n(name, 16, static_cast<std::uint8_t>(gpus == nullptr || atoi(gpus) == 1 ? 0 : chosen));
}

THALWEG_EXPORT const char* thalweg_device_problem() {
  const char* problem = getenv("FAKE_GPU_PROBLEM");
  const char* of = getenv("FAKE_GPU_OF");
  return problem == nullptr || (of != nullptr && atoi(of) != chosen) ? "" : problem;
}

THALWEG_EXPORT double thalweg_device_memory() {
  const char* bytes = getenv("FAKE_GPU_MEMORY");
  return bytes == nullptr ? 1e12 : atof(bytes);
}
