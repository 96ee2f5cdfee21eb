#include "physics/sediment/effective_pressure.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "physics/water/equation_of_state.hpp"

namespace thalweg {
namespace {

TEST(EffectivePressure, OfAColumnIsItsWeightUnderWater) {
  EXPECT_NEAR(submerged_weight(1540.0, 1000.0, 9.81), 5297.4, 1e-9);
  EXPECT_NEAR(effective_pressure_of_column(540 * 9.81, 0.06), 317.8, 0.05);
  EXPECT_EQ(effective_pressure_of_column(540 * 9.81, 0.0), 0);
  const double slope = 0.3;
  EXPECT_NEAR(effective_pressure_of_column(100.0, 2.0, std::cos(slope) * std::cos(slope)), 182.53, 0.01);
}

TEST(EffectivePressure, OfTheStateHasAnOffsetAtTheSurfaceOfTheBed) {
  const double c = 20;
  const double pore = tait_stiffness(1000.0, c);
  const double bed = tait_stiffness(1540.0, c);
  const double under_water = 1000 * 9.81 * 0.1;
  EXPECT_NEAR(effective_pressure_of_state(under_water, pore, bed), 344, 0.5);
  EXPECT_EQ(effective_pressure_of_state(-10.0, pore, bed), 0);
  // It is the total pressure less Tait's with the stiffness of the pore fluid, at the same excess.
  const double excess = 3e-4;
  EXPECT_NEAR(effective_pressure_of_state(tait_pressure(excess, bed), pore, bed),
              tait_pressure(excess, bed) - tait_pressure(excess, pore), 1e-10);
}

}  // namespace
}  // namespace thalweg
