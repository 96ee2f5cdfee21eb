// One core module per instruction set and precision of the pair sums (THALWEG_PAIR_NUMBER, float or double) is made
// from this file; see make_simulation.cpp for how one is chosen.
#include "solver/backend/openmp.hpp"
#include "solver/simulation/input.hpp"
#include "solver/simulation/simulation_on.hpp"

namespace {

template <int Dim>
thalweg::Simulation* make(const thalweg::Scene<Dim>& scene, const thalweg::SimulationInput& input) {
  using Number = THALWEG_PAIR_NUMBER;
  using Device = thalweg::OpenMp<thalweg::native_width, Number>;
  Device device;
  if (input.threads > 0) device.threads = input.threads;
  const char* isa = thalweg::native_width == 16 ? "AVX-512" : thalweg::native_width == 8 ? "AVX2" : "baseline";
  std::string name = "OpenMP, " + std::string(isa) + ", " + std::to_string(device.threads) +
                     (device.threads == 1 ? " thread" : " threads") +
                     (sizeof(Number) == sizeof(double) ? ", pair sums in double" : "");
  return new thalweg::SimulationOn<Dim, Device>(device, std::move(name), scene, *input.particles, input.profile,
                                                input.motions, input.openings, input.surface_bed, input.ranks,
                                                input.first_block);
}

}  // namespace

/// The one symbol a core module exports; the caller owns the result.
extern "C" __attribute__((visibility("default"))) thalweg::Simulation* thalweg_make_simulation(
    const thalweg::SimulationInput* input) {
  return std::visit([&](const auto& scene) { return make(scene, *input); }, input->scene);
}
