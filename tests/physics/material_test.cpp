#include "physics/sediment/material.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/degree.hpp"

namespace thalweg {
namespace {

SedimentParameters sand() {
  SedimentParameters s;
  s.grain_density = 2500;
  s.porosity = 0.4;
  s.grain_diameter = 1e-3;
  s.friction_angle = 30 * degree;
  s.dynamic_friction_angle = 45 * degree;
  s.cohesion = 10;
  return s;
}

TEST(Material, HasTheConstantsOfItsParameters) {
  const auto of = make_material<double>(sand(), {YieldCriterion::drucker_prager, YieldFit::sine, Rheology::mu_of_i});
  EXPECT_NEAR(of.yield_coefficient, 0.5, 1e-15);                // sin(30 deg)
  EXPECT_NEAR(of.yield_cohesion, 10 * std::sqrt(0.75), 1e-14);  // 10 cos(30 deg)
  EXPECT_NEAR(of.friction_tangent, 1 / std::sqrt(3), 1e-15);    // tan(30 deg)
  EXPECT_NEAR(of.dynamic_coefficient, std::sqrt(0.5), 1e-15);   // sin(45 deg)
  EXPECT_EQ(of.regularisation, 100);
  EXPECT_EQ(of.consistency, 1.5e-3);
  EXPECT_EQ(of.flow_index, 1);
  EXPECT_EQ(of.inertia.inertial_number, 0.279);
  EXPECT_EQ(of.inertia.diameter, 1e-3);
  EXPECT_EQ(of.inertia.grain_density, 2500);
  EXPECT_EQ(of.rheology, Rheology::mu_of_i);
}

TEST(Material, OfParticlesIsThatOfTheMeshRoundedOnce) {
  const MaterialChoices choices{YieldCriterion::drucker_prager, YieldFit::outer, Rheology::herschel_bulkley};
  const auto exact = make_material<double>(sand(), choices);
  const auto rounded = make_material<float>(sand(), choices);
  EXPECT_EQ(rounded.yield_coefficient, static_cast<float>(exact.yield_coefficient));
  EXPECT_EQ(rounded.yield_cohesion, static_cast<float>(exact.yield_cohesion));
  EXPECT_EQ(rounded.friction_tangent, static_cast<float>(exact.friction_tangent));
  EXPECT_EQ(rounded.dynamic_coefficient, static_cast<float>(exact.dynamic_coefficient));
}

TEST(Material, AsPrintedHasTwiceTheViscosity) {
  MaterialChoices choices;
  const auto meant = make_material<double>(sand(), choices);
  choices.as_printed = true;
  const auto printed = make_material<double>(sand(), choices);
  EXPECT_EQ(apparent_viscosity_of(printed, 2.0, 50.0, 100.0, 0.0),
            2 * apparent_viscosity_of(meant, 2.0, 50.0, 100.0, 0.0));
}

TEST(Material, OfMohrCoulombHasOneStrengthInPlaneStrain) {
  for (const YieldFit fit :
       {YieldFit::sine, YieldFit::coulomb, YieldFit::outer, YieldFit::inner, YieldFit::plane_strain, YieldFit::paper}) {
    const auto of = make_material<double>(sand(), {YieldCriterion::mohr_coulomb, fit, Rheology::herschel_bulkley});
    EXPECT_NEAR(yield_stress_of(of, 100.0, 0.0), 100 * std::sin(30 * degree) + 10 * std::cos(30 * degree), 1e-12);
    EXPECT_EQ(plane_strain_fit(YieldCriterion::drucker_prager, fit), fit);
  }
}

TEST(Material, OfMohrCoulombMeetsTheConesAtTheEndsOfTheLodeAngle) {
  const auto yield_stress = [](YieldCriterion yield, YieldFit fit, double lode_sine) {
    return yield_stress_of(make_material<double>(sand(), {yield, fit, Rheology::herschel_bulkley}), 100.0, lode_sine);
  };
  const auto mohr_coulomb = [&](double sine) {
    return yield_stress(YieldCriterion::mohr_coulomb, YieldFit::sine, sine);
  };
  const auto cone = [&](YieldFit fit) { return yield_stress(YieldCriterion::drucker_prager, fit, 0.3); };
  EXPECT_NEAR(mohr_coulomb(1), cone(YieldFit::outer), 1e-12);
  EXPECT_NEAR(mohr_coulomb(-1), cone(YieldFit::inner), 1e-12);
}

TEST(Material, FlowsByTheChosenRheology) {
  for (const YieldCriterion yield : {YieldCriterion::drucker_prager, YieldCriterion::mohr_coulomb}) {
    for (const double lode_sine : {-1.0, 0.0, 0.5}) {
      const auto plastic = make_material<double>(sand(), {yield, YieldFit::sine, Rheology::herschel_bulkley});
      const double strength = yield_stress_of(plastic, 100.0, lode_sine);
      EXPECT_DOUBLE_EQ(apparent_viscosity_of(plastic, 2.0, strength, 100.0, lode_sine),
                       herschel_bulkley_viscosity(2.0, strength, 100.0, 1.5e-3, 1.0));

      // Far above yield the stress under mu(I) is that of the dynamic friction angle, and the cohesion's.
      auto granular = make_material<double>(sand(), {yield, YieldFit::sine, Rheology::mu_of_i});
      granular.consistency = 0;
      const double fast = 1e9;
      SedimentParameters faster = sand();
      faster.friction_angle = faster.dynamic_friction_angle;
      faster.cohesion = 0;
      const auto dynamic = make_material<double>(faster, {yield, YieldFit::sine, Rheology::mu_of_i});
      const double cohesion = yield_stress_of(granular, 0.0, lode_sine);
      EXPECT_NEAR(apparent_viscosity_of(granular, fast, strength, 100.0, lode_sine) * fast,
                  yield_stress_of(dynamic, 100.0, lode_sine) + cohesion, 1e-4);
    }
  }
}

}  // namespace
}  // namespace thalweg
