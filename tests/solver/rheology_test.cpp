#include <gtest/gtest.h>

#include <cmath>

#include "solver/physics/drucker_prager.hpp"
#include "solver/physics/herschel_bulkley.hpp"

namespace thalweg {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;

TEST(HerschelBulkley, HasTheHandWorkedValues) {
  // tau_y = 50 Pa, m = 100 s, k = 1.54, n = 1.8: at gdot = 1, 50 (1 - e^-50)/1 + 1.54 = 51.540, and likewise.
  const auto eta = [](double gdot) { return herschel_bulkley_viscosity(gdot, 50.0, 100.0, 1.54, 1.8); };
  EXPECT_NEAR(eta(0.1), 496.88, 5e-3);
  EXPECT_NEAR(eta(1), 51.540, 5e-4);
  EXPECT_NEAR(eta(10), 14.717, 5e-4);
  EXPECT_NEAR(eta(100), 61.809, 5e-4);
}

TEST(HerschelBulkley, HasItsLimits) {
  EXPECT_DOUBLE_EQ(herschel_bulkley_viscosity(0.0, 50.0, 100.0, 1.54, 1.8), 2500);     // tau_y m/2
  EXPECT_DOUBLE_EQ(herschel_bulkley_viscosity(0.0, 50.0, 100.0, 2.0, 1.0), 2502);      // and k for n = 1
  EXPECT_DOUBLE_EQ(herschel_bulkley_viscosity(3.0, 0.0, 100.0, 0.001, 1.0), 0.001);    // Newton
  EXPECT_TRUE(std::isfinite(herschel_bulkley_viscosity(0.0, 50.0, 100.0, 1.0, 0.5)));  // shear thinning at rest
  // Bingham far above yield: eta gdot - k gdot = tau_y.
  EXPECT_NEAR(herschel_bulkley_viscosity(1e4, 50.0, 100.0, 0.01, 1.0) * 1e4 - 0.01 * 1e4, 50, 1e-9);
}

TEST(HerschelBulkley, IsSmoothWhereTheSeriesTakesOver) {
  const auto eta = [](float gdot) { return herschel_bulkley_viscosity(gdot, 50.0F, 100.0F, 0.0F, 1.0F); };
  const float at = 2e-6F;  // m gdot/2 = 1e-4
  EXPECT_NEAR(eta(at * 0.999F) / eta(at * 1.001F), 1, 1e-6);
}

TEST(DruckerPrager, HasTheHandWorkedCoefficients) {
  const double phi = 38 * degree;
  EXPECT_NEAR(yield_pressure_coefficient(phi, YieldFit::outer), 0.894, 5e-4);
  EXPECT_NEAR(yield_pressure_coefficient(phi, YieldFit::inner), 0.590, 5e-4);
  EXPECT_NEAR(yield_pressure_coefficient(phi, YieldFit::plane_strain), 0.580, 5e-4);
  EXPECT_NEAR(yield_pressure_coefficient(phi, YieldFit::sine), 0.616, 5e-4);
  EXPECT_NEAR(yield_pressure_coefficient(phi, YieldFit::paper), 0.298, 5e-4);
}

TEST(DruckerPrager, AgreesWithMohrCoulombOnItsOwnEdges) {
  // On the compression meridian (Lode angle of triaxial compression) Mohr-Coulomb reads q = M p + ..., M = 6 sin/(3 -
  // sin), sqrt(J2) = q/sqrt3; on the extension meridian M = 6 sin/(3 + sin). Same for the cohesion term, 6 c cos/(3 -+
  // sin).
  for (const double phi : {5 * degree, 20 * degree, 35 * degree}) {
    const double s = std::sin(phi);
    const double c = 7;
    EXPECT_NEAR(yield_pressure_coefficient(phi, YieldFit::outer), 6 * s / (3 - s) / std::sqrt(3), 1e-12);
    EXPECT_NEAR(yield_pressure_coefficient(phi, YieldFit::inner), 6 * s / (3 + s) / std::sqrt(3), 1e-12);
    EXPECT_NEAR(yield_cohesion_term(c, phi, YieldFit::outer), 6 * c * std::cos(phi) / (3 - s) / std::sqrt(3), 1e-12);
    EXPECT_NEAR(yield_cohesion_term(c, phi, YieldFit::sine), c * std::cos(phi), 1e-12);
  }
  EXPECT_EQ(yield_pressure_coefficient(0.0, YieldFit::outer), 0);
}

TEST(DruckerPrager, WithoutFrictionEveryFitIsTrescaOrMises) {
  // phi = 0: sin fit gives Tresca's k = c; the cones give von Mises through the corners, 2c/sqrt3; plane strain c.
  EXPECT_DOUBLE_EQ(yield_cohesion_term(3.0, 0.0, YieldFit::sine), 3);
  EXPECT_DOUBLE_EQ(yield_cohesion_term(3.0, 0.0, YieldFit::plane_strain), 3);
  EXPECT_NEAR(yield_cohesion_term(3.0, 0.0, YieldFit::outer), 6 / std::sqrt(3), 1e-12);
}

}  // namespace
}  // namespace thalweg
