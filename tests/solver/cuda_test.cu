#include "device_test.hpp"
#include "solver/core_cuda.cuh"

namespace thalweg::test {

INSTANTIATE_TYPED_TEST_SUITE_P(OnAGpu, OnDevice, Cuda);

}  // namespace thalweg::test
