#include "device_test.hpp"
#include "guarded_runtime.hpp"
#include "solver/backend/openmp.hpp"

namespace thalweg::test {

using Devices = testing::Types<OpenMp<4>, Gpu<GuardedRuntime>>;
INSTANTIATE_TYPED_TEST_SUITE_P(OnTheHost, OnDevice, Devices);

}  // namespace thalweg::test
