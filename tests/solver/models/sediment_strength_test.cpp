#include "solver/models/bed/effective_pressure.hpp"

#include <gtest/gtest.h>

#include "tests/solver/scenes.hpp"

namespace thalweg {
namespace {

using test::LatticeSetup;

template <class On>
class SedimentStrength : public testing::Test {};
TYPED_TEST_SUITE(SedimentStrength, test::Backends, test::BackendNames);

template <class On>
class LaplacePressure : public testing::Test {};
TYPED_TEST_SUITE(LaplacePressure, test::Backends, test::BackendNames);

/// All there is to the sediment's strength; returns the sweeps of Laplace's equation.
template <int Dim, class On>
int strengthen(test::Loaded<Dim, On>& l, const Scene<Dim>& scene, ColumnWeight<On>& weight) {
  weigh_sediment(l.on, l.p, scene, weight);
  const int sweeps = solve_effective_pressure(l.on, l.p, scene);
  apply_rheology(l.on, l.p, scene);
  return sweeps;
}

Scene<2> bed_scene() {
  LatticeSetup<2> setup;
  setup.gravity = {0, -9.81F};
  Scene<2> scene = test::make_scene_of(setup);
  scene.has_sediment = true;
  scene.sediment.yield_coefficient = 0.6F;
  scene.sediment.yield_cohesion = 2;
  scene.sediment.regularisation = 100;
  scene.sediment.consistency = 1e-3F;
  scene.sediment.submerged_weight = 300 * 9.81F;
  return scene;
}

TYPED_TEST(SedimentStrength, OfAFlatBedIsItsSubmergedWeight) {
  const Scene<2> scene = bed_scene();
  auto l = test::load<TypeParam>(scene, test::fill_lattice(scene, [](const Vec3& x) {
                                   return x.z() < 0.1 ? ParticleType::sediment : ParticleType::water;
                                 }));
  apply_equation_of_state(l.on, l.p, scene);
  ColumnWeight<TypeParam> weight;
  strengthen(l, scene, weight);
  const test::Seen seen = test::look(l);
  for (Index i = 0; i < seen.count; ++i) {
    if (!is_sediment(seen.record[i])) continue;
    const double expected = 300 * 9.81 * (0.1 - seen.position[i].x[2]);
    EXPECT_NEAR(seen.sediment[i].effective_pressure, expected, 1e-3 * 300 * 9.81 * 0.1);
    EXPECT_NEAR(seen.sediment[i].yield_stress, 0.6 * expected + 2, 0.2);
    EXPECT_NEAR(seen.record[i].viscosity, seen.sediment[i].yield_stress * 50 + 1e-3, 1e-2 * 50);  // at rest: tau_y m/2
  }
}

TYPED_TEST(SedimentStrength, FollowsASlope) {
  // Surface z = 0.06 + 0.2 x: the height above a particle is the surface's minus its own, away from the ends.
  const Scene<2> scene = bed_scene();
  const auto surface = [](double x) { return 0.06 + 0.2 * x; };
  auto l = test::load<TypeParam>(scene, test::fill_lattice(scene, [&](const Vec3& x) {
                                   return x.z() < surface(x.x()) ? ParticleType::sediment : ParticleType::water;
                                 }));
  apply_equation_of_state(l.on, l.p, scene);
  ColumnWeight<TypeParam> weight;
  strengthen(l, scene, weight);
  const test::Seen seen = test::look(l);
  for (Index i = 0; i < seen.count; ++i) {
    const double x = seen.position[i].x[0];
    if (!is_sediment(seen.record[i]) || x < 0.05 || x > 0.15 || seen.position[i].x[2] > 0.05) continue;
    const double expected = 300 * 9.81 * (surface(x) - seen.position[i].x[2]);
    EXPECT_NEAR(seen.sediment[i].effective_pressure, expected, 0.35 * scene.spacing * 300 * 9.81);
  }
}

TYPED_TEST(SedimentStrength, DoesNotFeelTheWaterAbove) {
  const Scene<2> scene = bed_scene();
  const auto bed = [](double water_top) {
    return [=](const Vec3& x) {
      if (x.z() < 0.05) return ParticleType::sediment;
      return x.z() < water_top ? ParticleType::water : ParticleType::wall;
    };
  };
  std::vector<double> pressures[2];
  int run = 0;
  for (const double top : {0.06, 0.18}) {
    auto l = test::load<TypeParam>(scene, test::fill_lattice(scene, bed(top)));
    apply_equation_of_state(l.on, l.p, scene);
    ColumnWeight<TypeParam> weight;
    strengthen(l, scene, weight);
    const test::Seen seen = test::look(l);
    pressures[run].resize(seen.count);
    for (Index i = 0; i < seen.fluid_count; ++i) {
      if (!is_sediment(seen.record[i])) continue;
      pressures[run][static_cast<std::size_t>(seen.id[i])] = double(seen.sediment[i].effective_pressure);
    }
    ++run;
  }
  EXPECT_EQ(pressures[0], pressures[1]);
}

/// A flat bed of ten layers in a tank, 0.03 m of walls around it, water above.
template <class On>
test::Loaded<2, On> bed_in_a_tank(const Scene<2>& scene) {
  auto l = test::load<On>(scene, test::fill_lattice(scene, [](const Vec3& x) {
                            if (x.z() < 0.03 || x.x() < 0.03 || x.x() > 0.17) return ParticleType::wall;
                            return x.z() < 0.13 ? ParticleType::sediment : ParticleType::water;
                          }));
  apply_equation_of_state(l.on, l.p, scene);
  return l;
}

Scene<2> laplace_scene() {
  Scene<2> scene = bed_scene();
  scene.sediment.effective_pressure = EffectivePressure::laplace;
  scene.sediment.laplace_tolerance = 1e-4F;
  return scene;
}

TYPED_TEST(LaplacePressure, OfAFlatBedIsTheColumnsToALayersWeight) {
  // The weight of one layer is given in the middle of the top one, where the column weighs half of it; the layer below
  // lacks neighbours above, which adds a quarter more. From there on the profile is the column's, also along the walls.
  const Scene<2> scene = laplace_scene();
  auto l = bed_in_a_tank<TypeParam>(scene);
  ColumnWeight<TypeParam> weight;
  EXPECT_GT(strengthen(l, scene, weight), 10);
  const double layer = 300 * 9.81 * scene.spacing;
  const test::Seen seen = test::look(l);
  double at_depth[10] = {};
  for (Index i = 0; i < seen.fluid_count; ++i) {
    if (!is_sediment(seen.record[i])) continue;
    const double depth = 0.13 - seen.position[i].x[2];
    const double offset = double(seen.sediment[i].effective_pressure) - 300 * 9.81 * depth;
    EXPECT_GE(offset, 0.4 * layer) << depth;
    EXPECT_LE(offset, 0.8 * layer) << depth;
    at_depth[static_cast<int>(depth / scene.spacing)] = double(seen.sediment[i].effective_pressure);
    EXPECT_FLOAT_EQ(seen.sediment[i].yield_stress, 0.6F * seen.sediment[i].effective_pressure + 2);
  }
  for (int n = 4; n < 10; ++n) EXPECT_NEAR(at_depth[n] - at_depth[n - 1], layer, 0.02 * layer) << n;
}

TYPED_TEST(LaplacePressure, StartsWhereItEndedAndLeavesNoTrace) {
  const Scene<2> scene = laplace_scene();
  auto l = bed_in_a_tank<TypeParam>(scene);
  ColumnWeight<TypeParam> weight;
  strengthen(l, scene, weight);
  EXPECT_LE(strengthen(l, scene, weight), 5);
  const test::Seen seen = test::look(l);
  for (Index i = 0; i < seen.count; ++i) {
    for (const float w : seen.record[i].work) EXPECT_EQ(w, 0);  // the viscous solve takes walls to be at rest there
  }
}

TEST(LaplacePressureOnThreads, IsTheSameForAnyNumber) {
  const Scene<2> scene = laplace_scene();
  std::vector<float> found[2];
  for (const int threads : {1, 3}) {
    auto l = bed_in_a_tank<test::Cpu>(scene);
    l.on.threads = threads;
    ColumnWeight<test::Cpu> weight;
    strengthen(l, scene, weight);
    for (const Sediment& sediment : test::look(l).sediment) found[threads / 2].push_back(sediment.effective_pressure);
  }
  EXPECT_EQ(found[0], found[1]);
}

TYPED_TEST(LaplacePressure, DoesNotFeelTheWaterAbove) {
  // A grain layer's weight at the surface whatever lies on it: twice the water, the same strength.
  const Scene<2> scene = laplace_scene();
  std::vector<float> found[2];
  int run = 0;
  for (const double top : {0.15, 0.2}) {
    auto l = bed_in_a_tank<TypeParam>(scene);
    test::change(l, [&](test::Seen& seen) {
      for (Index i = 0; i < seen.fluid_count; ++i) {
        if (seen.position[i].x[2] > top) seen.record[i].volume = 0;
      }
    });
    ColumnWeight<TypeParam> weight;
    strengthen(l, scene, weight);
    for (const Sediment& sediment : test::look(l).sediment) found[run].push_back(sediment.effective_pressure);
    ++run;
  }
  EXPECT_EQ(found[0], found[1]);
}

TYPED_TEST(SedimentStrength, FromTheStateIsItsShareOfTheTotalPressure) {
  Scene<2> scene = bed_scene();
  scene.sediment.effective_pressure = EffectivePressure::eos;
  scene.sediment.pore_stiffness = tait_stiffness(1000.0F, scene.sound_speed);
  auto l = bed_in_a_tank<TypeParam>(scene);
  test::change(l, [](test::Seen& seen) {
    for (Index i = 0; i < seen.fluid_count; ++i) seen.record[i].pressure = static_cast<float>(i) - 100;
  });
  ColumnWeight<TypeParam> weight;
  strengthen(l, scene, weight);
  const test::Seen seen = test::look(l);
  for (Index i = 0; i < seen.fluid_count; ++i) {
    if (!is_sediment(seen.record[i])) continue;
    const float share = (1 - 1000.0F / 1300.0F) * seen.record[i].pressure;
    EXPECT_NEAR(seen.sediment[i].effective_pressure, share > 0 ? share : 0, 1e-3);
  }
}

TEST(SedimentLaw, OfMohrCoulombDependsOnTheLodeAngle) {
  SedimentScene law = bed_scene().sediment;
  Sediment s{};
  s.effective_pressure = 100;
  s.strain_rate = 3;
  const float cone = yield_stress_of(law, s);
  law.yield = YieldCriterion::mohr_coulomb;
  EXPECT_EQ(yield_stress_of(law, s), cone);  // plane strain: sin(phi), what the cone of that fit has
  s.lode_sine = 1;
  EXPECT_FLOAT_EQ(yield_stress_of(law, s), cone * 2 * std::sqrt(3.0F) / (3 - 0.6F));
  s.lode_sine = -1;
  EXPECT_FLOAT_EQ(yield_stress_of(law, s), cone * 2 * std::sqrt(3.0F) / (3 + 0.6F));
}

TEST(SedimentLaw, OfMuOfIGrowsFromTheYieldStressToTheDynamicFriction) {
  SedimentScene law = bed_scene().sediment;
  law.yield_cohesion = 0;
  law.rheology = Rheology::mu_of_i;
  law.dynamic_coefficient = 0.8F;
  law.inertia = {0.279F, 1e-3F, 2500};
  for (const auto criterion : {YieldCriterion::drucker_prager, YieldCriterion::mohr_coulomb}) {
    law.yield = criterion;
    Sediment s{};
    s.effective_pressure = 100;
    s.yield_stress = yield_stress_of(law, s);
    s.strain_rate = 1;  // I = 0.005
    EXPECT_NEAR(apparent_viscosity_of(law, s) * 1, 60 + 20 * 0.005 / 0.284 + 1e-3, 1e-3);
    s.strain_rate = 1e6F;
    EXPECT_NEAR(apparent_viscosity_of(law, s) * 1e6F - 1e3F, 80, 0.1);
  }
}

TYPED_TEST(SedimentStrength, SeesCompressionApartFromStretching) {
  // u = e (x, y, -2z): compressed along z, stretched across it; -u the other way round. gdot = sqrt(12) e.
  LatticeSetup<3> setup;
  setup.length = 0.1;
  Scene<3> scene = test::make_scene_of(setup);
  scene.has_sediment = true;
  for (const float sign : {1.0F, -1.0F}) {
    auto l =
        test::load<TypeParam>(scene, test::fill_lattice(scene, [](const Vec3&) { return ParticleType::sediment; }));
    apply_equation_of_state(l.on, l.p, scene);
    test::change(l, [&](test::Seen& moving) {
      const auto at = [&](Index i, int c) { return sign * static_cast<float>(moving.position[i].x[c]); };
      for (Index i = 0; i < moving.count; ++i) {
        Record& r = moving.record[i];
        r.velocity[0] = at(i, 0);
        r.velocity[1] = at(i, 1);
        r.velocity[2] = -2 * at(i, 2);
      }
    });
    compute_density_rates(l.on, l.p, scene);
    const test::Seen seen = test::look(l);
    for (Index i = 0; i < seen.count; ++i) {
      bool inside = true;
      for (const double x : seen.position[i].x) inside = inside && x > 0.03 && x < 0.07;
      if (!inside) continue;
      EXPECT_NEAR(seen.sediment[i].strain_rate, std::sqrt(12), 1e-4);
      EXPECT_NEAR(seen.sediment[i].lode_sine, sign, 1e-4);
    }
  }
}

}  // namespace
}  // namespace thalweg
