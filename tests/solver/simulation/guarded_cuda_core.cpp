// A core module whose GPU is the host's stand-in (guarded_runtime.hpp), for whole scenes on the GPUs of several ranks.
#include "solver/simulation/input.hpp"
#include "tests/solver/scenes.hpp"

#define THALWEG_EXPORT extern "C" __attribute__((visibility("default")))

namespace {

template <int Dim>
thalweg::Simulation* make(const thalweg::Scene<Dim>& scene, const thalweg::SimulationInput& input) {
  using thalweg::test::Guarded;
  return new thalweg::SimulationOn<Dim, Guarded>(Guarded(input.stores_coefficients), "guarded", scene, *input.particles,
                                                 input.profile, input.motions, input.openings, input.surface_bed,
                                                 input.ranks, input.first_block, input.messages);
}

}  // namespace

THALWEG_EXPORT thalweg::Simulation* thalweg_make_simulation(const thalweg::SimulationInput* input) {
  return std::visit([&](const auto& scene) { return make(scene, *input); }, input->scene);
}

THALWEG_EXPORT void thalweg_choose_device(int /*place*/) {}

THALWEG_EXPORT void thalweg_name_device(std::uint8_t* name) { std::fill_n(name, 16, std::uint8_t{0}); }

THALWEG_EXPORT const char* thalweg_device_problem() { return ""; }

THALWEG_EXPORT double thalweg_device_memory() { return 1e12; }
