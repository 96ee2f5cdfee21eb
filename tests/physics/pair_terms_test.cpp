#include "physics/pair_terms.hpp"

#include <gtest/gtest.h>

#include <random>

namespace thalweg {
namespace {

TEST(DensityDiffusion, VanishesInAHydrostaticColumn) {
  // b lies dz below a: g.r = -g dz, the hydrostatic excess difference is g dz/c^2.
  const double c2 = 400;
  const double dz = 0.005;
  const double g = 9.81;
  const double d_a = 1e-3;
  const double d_b = d_a + g * dz / c2;
  EXPECT_NEAR(density_diffusion(d_a, d_b, -g * dz / c2, -1.0), 0, 1e-18);
}

TEST(DensityDiffusion, EvensOutAndIsAntisymmetric) {
  const double psi = density_diffusion(0.0, 1e-3, 0.0, -5.0);
  EXPECT_GT(psi, 0);  // the thinner particle gains
  EXPECT_DOUBLE_EQ(psi, -density_diffusion(1e-3, 0.0, 0.0, -5.0));
}

TEST(ArtificialViscosity, OnlyResistsApproach) {
  EXPECT_GT(artificial_viscous_pressure(-0.2, 10.0, 3.0), 0);
  EXPECT_EQ(artificial_viscous_pressure(0.2, 10.0, 3.0), 0);
}

TEST(ViscousCoefficient, IsSymmetricAndPositive) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> positive(0.1, 2);
  for (int i = 0; i < 100; ++i) {
    const double va = positive(random), vb = positive(random), eta = positive(random), F = -positive(random);
    const double k = viscous_coefficient(va, vb, eta, F);
    EXPECT_GT(k, 0);
    EXPECT_NEAR(k, viscous_coefficient(vb, va, eta, F), 1e-15 * k);
  }
}

TEST(InterfaceViscosity, StressIsQuadraticInTheSpeed) {
  // mu_w + 0.4 rho (0.41/2)^2 |u| dp: at 1 m/s, dp = 5 mm, 0.001 + 0.4 1000 0.042025 0.005 = 0.08505 Pa s.
  EXPECT_NEAR(interface_viscosity(0.001, 1000.0, 1.0, 0.005), 0.08505, 1e-8);
  EXPECT_DOUBLE_EQ(interface_viscosity(0.001, 1000.0, 0.0, 0.005), 0.001);
}

}  // namespace
}  // namespace thalweg
