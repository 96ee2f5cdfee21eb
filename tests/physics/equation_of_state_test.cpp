#include "physics/water/equation_of_state.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace thalweg {
namespace {

TEST(Tait, EqualsItsClosedForm) {
  const double B = tait_stiffness(1000.0, 20.0);
  EXPECT_DOUBLE_EQ(B, 1000.0 * 400 / 7);
  for (const double d : {-0.05, -1e-3, 0.0, 1e-4, 0.01, 0.1}) {
    EXPECT_NEAR(tait_pressure(d, B), B * (std::pow(1 + d, 7) - 1), 1e-9 * B);
  }
}

TEST(Tait, KeepsTheDigitsOfASmallExcessInSinglePrecision) {
  // 10 Pa at c = 20 m/s: d = 2.5e-5. (1 + d)^7 - 1 in float would be good to 1e-7/2e-4 = 5e-4 only.
  const float B = tait_stiffness(1000.0F, 20.0F);
  const float d = 2.5e-5F;
  EXPECT_NEAR(tait_pressure(d, B) / (double(B) * std::expm1(7 * std::log1p(double(d)))), 1, 3e-7);
}

TEST(Tait, PressureSlopeIsTheSoundSpeedSquared) {
  const double rho0 = 1286;
  const double c = 13;
  const double B = tait_stiffness(rho0, c);
  const double slope = (tait_pressure(1e-6, B) - tait_pressure(-1e-6, B)) / (2e-6 * rho0);
  EXPECT_NEAR(slope, c * c, 1e-6 * c * c);
}

TEST(TaitEnergy, IsTheWorkOfCompression) {
  // de/drho = p/rho^2, checked by a central difference on both sides of the switch to the series.
  const double c = 20;
  const double rho0 = 1000;
  const double B = tait_stiffness(rho0, c);
  for (const double d : {-0.02, -5e-4, 5e-4, 9e-4, 1.1e-3, 0.02}) {
    const double step = 1e-5 * std::abs(d);
    const double slope = (tait_energy(d + step, c) - tait_energy(d - step, c)) / (2 * step * rho0);
    const double rho = rho0 * (1 + d);
    const double expected = tait_pressure(d, B) / (rho * rho);
    EXPECT_NEAR(slope, expected, 2e-5 * std::abs(expected)) << "d = " << d;
  }
  EXPECT_EQ(tait_energy(0, c), 0);
  EXPECT_GT(tait_energy(-1e-2, c), 0);
}

}  // namespace
}  // namespace thalweg
