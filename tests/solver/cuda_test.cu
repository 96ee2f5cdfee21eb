#include "device_test.hpp"
#include "solver/backend/cuda.cuh"
#include "solver/core_cuda.cuh"

namespace thalweg::test {

/// Compiled with the core already.
template <>
struct Maker<Cuda> {
  template <int Dim>
  static std::unique_ptr<Simulation> make(const Scene<Dim>& scene, const ParticleSet& from) {
    return std::unique_ptr<Simulation>(make_on_cuda(scene, from, false));
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(OnAGpu, OnDevice, Cuda);

}  // namespace thalweg::test
