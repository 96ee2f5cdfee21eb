#include "physics/sediment/surface_fill.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "physics/kernel.hpp"

namespace thalweg {
namespace {

// Sigma V W over the lower half of a square lattice with the given number of layers above the particle.
double lattice_fill(double ratio, int layers_above) {
  const WendlandC2<2, double> kernel(ratio);
  const int reach = static_cast<int>(2 * ratio) + 1;
  double sum = 0;
  for (int x = -reach; x <= reach; ++x) {
    for (int z = -reach; z <= layers_above; ++z) sum += kernel.value(kernel.closeness(std::hypot(x, z)));
  }
  return sum;
}

TEST(SurfaceFill, LiesBetweenTheFirstTwoLayersOfALattice) {
  for (const double widest_narrow : {widest_narrow_kernel_of_states, widest_narrow_kernel_of_laplace}) {
    for (double ratio = 1.2; ratio < 3.01; ratio += 0.05) {
      const auto fill = static_cast<double>(surface_fill(ratio, 1, widest_narrow));
      EXPECT_LT(lattice_fill(ratio, 0), fill) << ratio;
      EXPECT_GT(lattice_fill(ratio, 1), fill) << ratio;
    }
  }
  EXPECT_NEAR(lattice_fill(1.5, 0), 0.75, 0.005);  // the table in the header
  EXPECT_NEAR(lattice_fill(1.5, 1), 0.99, 0.005);
}

TEST(SurfaceFill, ChangesBeyondTheLimitOfEachUse) {
  EXPECT_EQ(surface_fill(1.55, 1, widest_narrow_kernel_of_states), 0.85F);
  EXPECT_EQ(surface_fill(std::nextafter(1.55, 2), 1, widest_narrow_kernel_of_states), 0.81F);
  // The default h = 1.5 dp stays on its side whatever the spacing's rounding.
  for (const double spacing : {0.1, 0.005, 0.0035, 0.007, 1.0 / 3}) {
    EXPECT_EQ(surface_fill(1.5 * spacing, spacing, widest_narrow_kernel_of_laplace), 0.85F);
    EXPECT_EQ(surface_fill(1.51 * spacing, spacing, widest_narrow_kernel_of_laplace), 0.81F);
  }
}

}  // namespace
}  // namespace thalweg
