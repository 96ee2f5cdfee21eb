#include "physics/kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace thalweg {
namespace {

/// Sum of W V over a lattice of spacing dp around a point offset from a node.
template <int Dim>
double lattice_sum(double h_over_dp, double offset) {
  const double dp = 0.01;
  const WendlandC2<Dim, double> kernel(h_over_dp * dp);
  double sum = 0;
  const int n = 8;
  for (int i = -n; i <= n; ++i) {
    for (int j = -n; j <= n; ++j) {
      for (int k = (Dim == 3 ? -n : 0); k <= (Dim == 3 ? n : 0); ++k) {
        const double x = (i - offset) * dp;
        const double y = (j - 0.5 * offset) * dp;
        const double z = k * dp;
        sum += kernel.value(kernel.closeness(std::sqrt(x * x + y * y + z * z))) * std::pow(dp, Dim);
      }
    }
  }
  return sum;
}

TEST(Wendland, IntegratesToOneOnALattice) {
  // The midpoint rule on a smooth kernel: errors of half a percent at h = 1.5 dp, falling fast with h/dp.
  EXPECT_NEAR((lattice_sum<2>(1.5, 0.0)), 1, 6e-3);
  EXPECT_NEAR((lattice_sum<2>(1.5, 0.3)), 1, 6e-3);
  EXPECT_NEAR((lattice_sum<2>(3.0, 0.3)), 1, 2e-4);
  EXPECT_NEAR((lattice_sum<3>(1.5, 0.0)), 1, 8e-3);
  EXPECT_NEAR((lattice_sum<3>(3.0, 0.3)), 1, 4e-4);
}

TEST(Wendland, IntegratesToOneExactly) {
  // 2-D: integral of W 2 pi r dr over the support, by Simpson's rule with 2000 intervals of a polynomial: to rounding.
  const double h = 0.37;
  const WendlandC2<2, double> plane(h);
  const WendlandC2<3, double> space(h);
  const int n = 2000;
  double in_plane = 0;
  double in_space = 0;
  for (int i = 0; i <= n; ++i) {
    const double r = 2 * h * i / n;
    const double weight = (i == 0 || i == n) ? 1 : (i % 2 == 1 ? 4 : 2);
    in_plane += weight * plane.value(plane.closeness(r)) * 2 * M_PI * r;
    in_space += weight * space.value(space.closeness(r)) * 4 * M_PI * r * r;
  }
  EXPECT_NEAR(in_plane * 2 * h / n / 3, 1, 1e-10);
  EXPECT_NEAR(in_space * 2 * h / n / 3, 1, 1e-10);
}

TEST(Wendland, HasThePrintedConstants) {
  // physics notes: W(0) = 0.41778/h^3 in space, 0.55704/h^2 in the plane; F(0) = -2.08891/h^5, -2.7852/h^4.
  const WendlandC2<3, double> space(1.0);
  const WendlandC2<2, double> plane(1.0);
  EXPECT_NEAR(space.value(1.0), 0.41778, 5e-6);
  EXPECT_NEAR(plane.value(1.0), 0.55704, 5e-6);
  EXPECT_NEAR(space.gradient(1.0), -2.08891, 1e-5);
  EXPECT_NEAR(plane.gradient(1.0), -2.7852, 5e-5);
}

TEST(Wendland, GradientIsTheDerivativeOfTheValue) {
  const WendlandC2<3, double> kernel(0.5);
  for (double r = 0.05; r < 1.2; r += 0.05) {
    const double d = 1e-6;
    const double slope = (kernel.value(kernel.closeness(r + d)) - kernel.value(kernel.closeness(r - d))) / (2 * d);
    EXPECT_NEAR(kernel.gradient(kernel.closeness(r)) * r, slope, 1e-7 * std::abs(kernel.gradient(1.0))) << "r = " << r;
  }
}

TEST(Wendland, VanishesOutsideItsSupport) {
  const WendlandC2<2, float> kernel(0.5F);
  EXPECT_EQ(kernel.value(kernel.closeness(1.0F)), 0);
  EXPECT_EQ(kernel.value(kernel.closeness(7.0F)), 0);
  EXPECT_EQ(kernel.gradient(kernel.closeness(1.001F)), 0);
}

}  // namespace
}  // namespace thalweg
