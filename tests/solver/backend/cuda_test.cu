#include "device_steps_test.hpp"
#include "device_verbs_test.hpp"
#include "solver/backend/cuda.cuh"

namespace thalweg::test {

/// The core module, as the solver loads it.
template <>
struct Maker<Cuda> {
  /// Quotients and roots differ by 1 to 2 units in the last place, so that one particle in a scene may cross a threshold a
  /// step earlier or later. A wrong threshold would show in many.
  static constexpr int other_states = 1;

  template <int Dim>
  static std::unique_ptr<Simulation> make(const Scene<Dim>& scene, const ParticleSet& from, const DeviceScene& of) {
    return make_simulation({scene, &from, 0, false, of.motions, false, of.openings(), of.surface_bed(from)}, "cuda",
                           "auto");
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(OnAGpu, OnDevice, Cuda);
INSTANTIATE_TYPED_TEST_SUITE_P(OnAGpu, StepsOnDevice, Cuda);

}  // namespace thalweg::test
