#include <gtest/gtest.h>

#include <cmath>

#include "physics/sediment/drucker_prager.hpp"
#include "physics/sediment/herschel_bulkley.hpp"
#include "physics/sediment/mohr_coulomb.hpp"
#include "physics/sediment/mu_of_i.hpp"
#include "physics/sediment/suspension_viscosity.hpp"
#include "tests/physics/degree.hpp"

namespace thalweg {
namespace {

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
  // Mohr-Coulomb reads q = M p + ..., sqrt(J2) = q/sqrt3, with
  //   M = 6 sin/(3 - sin)   on the compression meridian (Lode angle of triaxial compression)
  //   M = 6 sin/(3 + sin)   on the extension meridian
  // and likewise for the cohesion term, 6 c cos/(3 -+ sin).
  for (const double phi : {5 * degree, 20 * degree, 35 * degree}) {
    const double s = std::sin(phi);
    const double c = 7;
    EXPECT_NEAR(yield_pressure_coefficient(phi, YieldFit::outer), 6 * s / (3 - s) / std::sqrt(3), 1e-12);
    EXPECT_NEAR(yield_pressure_coefficient(phi, YieldFit::inner), 6 * s / (3 + s) / std::sqrt(3), 1e-12);
    EXPECT_NEAR(yield_cohesion_term(c, phi, YieldFit::outer), 6 * c * std::cos(phi) / (3 - s) / std::sqrt(3), 1e-12);
    EXPECT_NEAR(yield_cohesion_term(c, phi, YieldFit::sine), c * std::cos(phi), 1e-12);
    EXPECT_NEAR(yield_cohesion_term(c, phi, YieldFit::printed), 6 * c * s / (3 - s) / std::sqrt(3), 1e-12);
    EXPECT_EQ(yield_pressure_coefficient(phi, YieldFit::printed), yield_pressure_coefficient(phi, YieldFit::paper));
  }
  EXPECT_EQ(yield_pressure_coefficient(0.0, YieldFit::outer), 0);
}

TEST(DruckerPrager, WithoutFrictionEveryFitIsTrescaOrMises) {
  // phi = 0: sin fit gives Tresca's k = c; the cones give von Mises through the corners, 2c/sqrt3; plane strain c.
  EXPECT_DOUBLE_EQ(yield_cohesion_term(3.0, 0.0, YieldFit::sine), 3);
  EXPECT_DOUBLE_EQ(yield_cohesion_term(3.0, 0.0, YieldFit::plane_strain), 3);
  EXPECT_NEAR(yield_cohesion_term(3.0, 0.0, YieldFit::outer), 6 / std::sqrt(3), 1e-12);
}

/// Sine of three Lode angles of a diagonal rate of strain.
double sine_of(double x, double y, double z) {
  return sine_of_three_lode_angles(x * y * z, (x * x + y * y + z * z) / 2);
}

TEST(MohrCoulomb, TakesTheKindOfDeformationFromTheStrainRate) {
  EXPECT_NEAR(sine_of(-2, 1, 1), 1, 1e-15);    // compression along one axis
  EXPECT_NEAR(sine_of(2, -1, -1), -1, 1e-15);  // stretching along one axis
  EXPECT_EQ(sine_of(3, 0, -3), 0);             // plane strain
  EXPECT_EQ(sine_of(0, 0, 0), 0);
  EXPECT_NEAR(sine_of(-2e-9, 1e-9, 1e-9), 1, 1e-12);  // of any size
  // -30 to 30 degrees: -(3 sqrt3/2) x y z/J^(3/2) of (sin(theta + 120), sin(theta), sin(theta - 120)) is sin(3 theta).
  for (double theta = -30; theta <= 30; theta += 7.5) {
    const auto s = [&](double shift) { return std::sin((theta + shift) * degree); };
    EXPECT_NEAR(sine_of(s(120), s(0), s(-120)), std::sin(3 * theta * degree), 1e-14) << theta;
  }
}

TEST(MohrCoulomb, MeetsTheConesOnItsEdges) {
  for (const double phi : {0.0, 5 * degree, 20 * degree, 38 * degree, 60 * degree}) {
    const double c = 7;
    EXPECT_NEAR(mohr_coulomb_pressure_coefficient(1.0, phi), yield_pressure_coefficient(phi, YieldFit::outer), 1e-14);
    EXPECT_NEAR(mohr_coulomb_pressure_coefficient(-1.0, phi), yield_pressure_coefficient(phi, YieldFit::inner), 1e-14);
    EXPECT_DOUBLE_EQ(mohr_coulomb_pressure_coefficient(0.0, phi), std::sin(phi));
    EXPECT_NEAR(mohr_coulomb_cohesion_term(1.0, c, phi), yield_cohesion_term(c, phi, YieldFit::outer), 1e-14);
    EXPECT_NEAR(mohr_coulomb_cohesion_term(-1.0, c, phi), yield_cohesion_term(c, phi, YieldFit::inner), 1e-14);
    EXPECT_DOUBLE_EQ(mohr_coulomb_cohesion_term(0.0, c, phi), c * std::cos(phi));
  }
}

TEST(MohrCoulomb, IsTheCriterionOnTheExtremePrincipalStresses) {
  // At every Lode angle the stress on the yield surface has (s1 - s3)/2 = -(s1 + s3)/2 sin(phi) + c cos(phi).
  const double phi = 38 * degree;
  const double c = 20;
  const double p = 100;
  for (double theta = -30; theta <= 30; theta += 5) {
    const double sine = std::sin(3 * theta * degree);
    const double root_J2 = mohr_coulomb_pressure_coefficient(sine, phi) * p + mohr_coulomb_cohesion_term(sine, c, phi);
    const double s1 = -p + 2 / std::sqrt(3) * root_J2 * std::sin((theta + 120) * degree);
    const double s3 = -p + 2 / std::sqrt(3) * root_J2 * std::sin((theta - 120) * degree);
    EXPECT_NEAR((s1 - s3) / 2, -(s1 + s3) / 2 * std::sin(phi) + c * std::cos(phi), 1e-11) << theta;
  }
}

constexpr InertialScale<double> beads{0.279, 1e-3, 2500};  // glass, mu_s = 0.38, mu_2 = 0.64

TEST(MuOfI, HasTheHandWorkedValue) {
  // I = 50 * 0.001 * sqrt(2500/100) = 0.25; mu = 0.38 + 0.26 * 0.25/0.529 = 0.50287; eta = 0.50287 * 100/50.
  EXPECT_DOUBLE_EQ(inertial_number(50.0, 1e-3, 2500.0, 100.0), 0.25);
  EXPECT_NEAR(friction_of_inertial_number(0.25, 0.38, 0.64, 0.279), 0.50287, 5e-6);
  EXPECT_NEAR(friction_of_inertial_number(0.279, 0.38, 0.64, 0.279), 0.51, 1e-12);
  EXPECT_NEAR(mu_of_i_viscosity(50.0, 38.0, 100.0, 0.26, 100.0, 0.0, beads), 1.00575, 5e-6);
}

TEST(MuOfI, HasItsLimits) {
  const auto eta = [](double gdot, double p, double c = 0, double pore = 0) {
    return mu_of_i_viscosity(gdot, 0.38 * std::fmax(p, 0) + c, p, 0.26, 100.0, pore, beads);
  };
  // At rest: tau_y m/2 + (mu_2 - mu_s) d sqrt(rho_s p)/I0 = 1900 + 0.26 * 0.001 * 500/0.279.
  EXPECT_NEAR(eta(0, 100), 1900 + 0.13 / 0.279, 1e-9);
  EXPECT_NEAR(eta(1e9, 100) * 1e9, 64, 1e-4);  // I -> infinity: mu_2 p
  EXPECT_NEAR(eta(1e4, 100, 5) * 1e4 - eta(1e4, 100) * 1e4, 5, 1e-9);
  // Without pressure nothing but the pores' fluid and the cohesion resists.
  EXPECT_EQ(eta(0, 0), 0);
  EXPECT_EQ(eta(10, 0), 0);
  EXPECT_EQ(eta(10, -50), 0);
  EXPECT_EQ(eta(10, 0, 0, 0.001), 0.001);
  // One friction at every rate: the Bingham material.
  for (const double gdot : {0.0, 0.01, 1.0, 100.0}) {
    EXPECT_DOUBLE_EQ(mu_of_i_viscosity(gdot, 41.0, 100.0, 0.0, 100.0, 0.002, beads),
                     herschel_bulkley_viscosity(gdot, 41.0, 100.0, 0.002, 1.0));
  }
  // In the arithmetic of the solver too.
  const InertialScale<float> beads_f{0.279F, 1e-3F, 2500.0F};
  EXPECT_EQ(mu_of_i_viscosity(0.0F, 0.0F, 0.0F, 0.26F, 100.0F, 0.0F, beads_f), 0);
  EXPECT_NEAR(mu_of_i_viscosity(50.0F, 38.0F, 100.0F, 0.26F, 100.0F, 0.0F, beads_f), 1.00575F, 1e-5F);
}

TEST(Vand, HasThePrintedValuesAndItsRange) {
  EXPECT_NEAR(suspension_viscosity(1.0, 0.1), 1.305, 5e-4);
  EXPECT_NEAR(suspension_viscosity(1.0, 0.2), 1.767, 5e-4);
  EXPECT_NEAR(suspension_viscosity(1.0, 0.3), 2.504, 5e-4);
  EXPECT_EQ(suspension_viscosity(0.001, 0.0), 0.001);
  EXPECT_EQ(suspension_viscosity(0.001, -0.1), 0.001);
  EXPECT_EQ(suspension_viscosity(0.001, 1.0), suspension_viscosity(0.001, 0.6));
  // Einstein 1906 for few grains: 1 + 2.5 C.
  EXPECT_NEAR(suspension_viscosity(1.0, 1e-5), 1 + 2.5e-5, 1e-9);
}

}  // namespace
}  // namespace thalweg
