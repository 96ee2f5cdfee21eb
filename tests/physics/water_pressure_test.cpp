#include <gtest/gtest.h>

#include <cmath>

#include "physics/sediment/compression_under_water.hpp"
#include "physics/water/equation_of_state.hpp"
#include "physics/water/viscosity_switch.hpp"

namespace thalweg {
namespace {

// A sound wave d = A exp(s t) cos(k x) obeys d'' = -c^2 k^2 (d + (h/c) d'): s^2 + c h k^2 s + c^2 k^2 = 0. Stepped with
// the damper's pressure, its amplitude has to fall as exp(-c h k^2 t/2), and its frequency to be c k sqrt(1 - (h k/2)^2).
TEST(AcousticDamper, DampsSoundAsABulkViscosity) {
  const double c = 20, h = 0.01, k = 2 * M_PI / 0.2, rho = 1000;
  double d = 1e-3, u = 0, rate = 0;  // density excess and velocity of a mode
  const double dt = 1e-6;
  const double omega = c * k * std::sqrt(1 - std::pow(h * k / 2, 2));
  const double time = 2 * M_PI / omega;
  for (double t = 0; t < time - dt / 2; t += dt) {
    const double p = rho * c * c * d + damper_pressure(rho, c * h, rate);
    u += dt * k * p / rho;
    rate = -k * u;
    d += dt * rate;
  }
  EXPECT_NEAR(d / 1e-3, std::exp(-c * h * k * k * time / 2), 2e-3);
}

TEST(CompressionByWater, RelievesTheBedButDoesNotPressIt) {
  EXPECT_EQ(compression_by_water(0.0F, 3.0F), 0);    // arriving water over a bed at rest
  EXPECT_EQ(compression_by_water(2.0F, 3.0F), 0);    // both compress
  EXPECT_EQ(compression_by_water(-2.0F, -3.0F), 0);  // both relieve
  EXPECT_EQ(compression_by_water(2.0F, -1.0F), -1);  // water relieves a part
  EXPECT_EQ(compression_by_water(2.0F, -5.0F), -2);  // never more than there is
  EXPECT_EQ(compression_by_water(-2.0F, 5.0F), 2);
}

TEST(ExchangeRate, LeadsToThePressureOfTheWaterBeyondASpacingsWeight) {
  const float impedance = 1500 * 20 * 0.0075F;  // rho_s c h
  EXPECT_EQ(exchange_rate(20.0F, 24.5F, 0.5F, impedance), 0);
  EXPECT_FLOAT_EQ(exchange_rate(124.5F, 24.5F, 0.5F, impedance), 0.1F * 100 / impedance);
  EXPECT_FLOAT_EQ(exchange_rate(-124.5F, 24.5F, 0.5F, impedance), -0.1F * 100 / impedance);
  EXPECT_FLOAT_EQ(exchange_rate(124.5F, 24.5F, 0.1F, impedance), 0.04F * 100 / impedance);  // little water in reach
  // A pressure that is off by m falls by the e-th part in 10 h/c where water is all around: d' = -0.1 m/(rho c h), and
  // dm = -rho c^2 dd.
  double m = 1000;
  const double c = 20, h = 0.0075, dt = 1e-6;
  for (double t = 0; t < 10 * h / c; t += dt) m -= 1500 * c * c * dt * exchange_rate(m, 0.0, 1.0, 1500 * c * h);
  EXPECT_NEAR(m / 1000, std::exp(-1), 2e-3);
}

TEST(ShareOutOfBalance, LeavesABedInBalanceToThePlainSum) {
  EXPECT_EQ(share_out_of_balance(-14.0F, 14.5F), 0);
  EXPECT_FLOAT_EQ(share_out_of_balance(21.75F, 14.5F), 0.5F);
  EXPECT_EQ(share_out_of_balance(-100.0F, 14.5F), 1);
  EXPECT_EQ(share_out_of_balance(0.0F, 0.0F), 0);  // phases of one density
}

TEST(HeldShare, LetsFlyingGrainsBe) {
  EXPECT_EQ(held_share(0.0F), 0);
  EXPECT_FLOAT_EQ(held_share(0.25F), 0.5F);
  EXPECT_EQ(held_share(0.45F), 1);
}

// Gradients by their divergence and the rest, in the plane.
TEST(ViscositySwitch, TellsCompressionFromShear) {
  const float least = 0.1F;
  const auto of = [&](float ux, float uy, float vx, float vy) {
    const float divergence2 = (ux + vy) * (ux + vy);
    return viscosity_switch(divergence2, ux * ux + uy * uy + vx * vx + vy * vy - divergence2 / 2, least);
  };
  EXPECT_EQ(of(0, 0, 0, 0), 0);
  EXPECT_EQ(of(0, 50, 0, 0), 0);                 // shear
  EXPECT_EQ(of(0, 50, -50, 0), 0);               // rotation
  EXPECT_EQ(of(50, 0, 0, -50), 0);               // strain of a wave
  EXPECT_EQ(of(-50, 0, 0, 0), 1);                // a plane shock
  EXPECT_EQ(of(-50, 0, 0, -50), 1);              // collapse
  EXPECT_NEAR(of(50, 0, 0, -49), 0.028, 0.002);  // what a lattice leaves of a divergence
}

}  // namespace
}  // namespace thalweg
