#include "physics/water/sub_particle_stress.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace thalweg {
namespace {

constexpr float spacing = 5e-3F;  // [m]

TEST(SubParticleStress, OfASimpleShearIsItsEddyViscosity) {
  // u = 10 z: |S| = sqrt(2 (5^2 + 5^2)) = 10 1/s; nu_t = (0.12 x 5 mm)^2 x 10 = 3.6e-6 m^2/s; off the diagonal nu_t x 10;
  // on it -2/3 x 0.0066 x (5 mm)^2 x 100 = -1.1e-5 m^2/s^2.
  const float plane[2][2] = {{0, 10}, {0, 0}};
  const auto flat = sub_particle_stress<2>(plane, spacing);
  EXPECT_NEAR(flat.eddy_viscosity, 3.6e-6, 1e-12);
  EXPECT_NEAR(flat.off_diagonal[0], 3.6e-5, 1e-11);
  for (const float d : flat.diagonal) EXPECT_NEAR(d, -1.1e-5, 1e-11);
  EXPECT_NEAR(dissipation(flat, plane), 3.6e-6 * 100, 1e-9);

  const float space[3][3] = {{0, 0, 10}, {0, 0, 0}, {0, 0, 0}};
  const auto full = sub_particle_stress<3>(space, spacing);
  EXPECT_NEAR(full.eddy_viscosity, 3.6e-6, 1e-12);
  EXPECT_EQ(full.off_diagonal[0], 0);
  EXPECT_NEAR(full.off_diagonal[1], 3.6e-5, 1e-11);
  EXPECT_EQ(full.off_diagonal[2], 0);
  for (const float d : full.diagonal) EXPECT_NEAR(d, -1.1e-5, 1e-11);
}

TEST(SubParticleStress, OfAPureStrainLiesOnTheDiagonal) {
  // S = diag(20, -10, -10): |S| = sqrt(2 x 600) = 34.641 1/s, nu_t = 3.6e-7 x 34.641 = 1.247077e-5 m^2/s,
  // eddy pressure 1.1e-7 x 1200 = 1.32e-4.
  const float gradient[3][3] = {{20, 0, 0}, {0, -10, 0}, {0, 0, -10}};
  const auto stress = sub_particle_stress<3>(gradient, spacing);
  EXPECT_NEAR(stress.eddy_viscosity, 1.247077e-5, 1e-10);
  EXPECT_NEAR(stress.diagonal[0], 40 * 1.247077e-5 - 1.32e-4, 1e-9);
  EXPECT_NEAR(stress.diagonal[1], -20 * 1.247077e-5 - 1.32e-4, 1e-9);
  EXPECT_NEAR(stress.diagonal[2], stress.diagonal[1], 1e-12);
  for (const float o : stress.off_diagonal) EXPECT_EQ(o, 0);
  // In a flow that keeps its volume the power is nu_t |S|^2.
  EXPECT_NEAR(dissipation(stress, gradient), 1.247077e-5 * 1200, 1e-6);
}

TEST(SubParticleStress, VanishesInARotationAndHasNoDeviatorInAnExpansion) {
  const float turning[3][3] = {{0, 3, -2}, {-3, 0, 1}, {2, -1, 0}};
  const auto none = sub_particle_stress<3>(turning, spacing);
  EXPECT_EQ(none.eddy_viscosity, 0);
  for (const float d : none.diagonal) EXPECT_EQ(d, 0);
  // S = 4 I: 2 S - 2/3 tr S I = 0; the eddy pressure 1.1e-7 |S|^2 = 1.1e-7 x 96 is left, and an expansion gains from it.
  const float wider[3][3] = {{4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
  const auto expanding = sub_particle_stress<3>(wider, spacing);
  for (const float d : expanding.diagonal) EXPECT_NEAR(d, -1.056e-5, 1e-10);
  EXPECT_LT(dissipation(expanding, wider), 0);
}

}  // namespace
}  // namespace thalweg
