#include "device_steps_test.hpp"
#include "device_verbs_test.hpp"
#include "solver/backend/cuda.cuh"

namespace thalweg::test {

/// The core module, as the solver loads it.
template <>
struct Maker<Cuda> {
  template <int Dim>
  static std::unique_ptr<Simulation> make(const Scene<Dim>& scene, const ParticleSet& from, const DeviceScene& of) {
    return make_simulation({scene, &from, 0, false, of.motions, false, of.openings(), of.surface_bed(from)}, "cuda",
                           "auto");
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(OnAGpu, OnDevice, Cuda);
INSTANTIATE_TYPED_TEST_SUITE_P(OnAGpu, StepsOnDevice, Cuda);

}  // namespace thalweg::test
