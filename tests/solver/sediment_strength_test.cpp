#include "solver/passes/sediment_strength.hpp"

#include <gtest/gtest.h>

#include "scenes.hpp"

namespace thalweg {
namespace {

using test::LatticeSetup;

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

TEST(SedimentStrength, OfAFlatBedIsItsSubmergedWeight) {
  const Scene<2> scene = bed_scene();
  auto l = test::load(scene, test::fill_lattice(scene, [](const Vec3& x) {
                        return x.z() < 0.1 ? ParticleType::sediment : ParticleType::water;
                      }));
  apply_equation_of_state(l.on, l.p, scene);
  ColumnWeight<test::Device> weight;
  weigh_sediment(l.on, l.p, scene, weight);
  apply_rheology(l.on, l.p, scene);
  for (Index i = 0; i < l.p.count; ++i) {
    if (l.p.record[i].phase != phase_sediment) continue;
    const double expected = 300 * 9.81 * (0.1 - l.p.position[i].x[2]);
    EXPECT_NEAR(l.p.sediment[i].effective_pressure, expected, 1e-3 * 300 * 9.81 * 0.1);
    EXPECT_NEAR(l.p.sediment[i].yield_stress, 0.6 * expected + 2, 0.2);
    EXPECT_NEAR(l.p.record[i].viscosity, l.p.sediment[i].yield_stress * 50 + 1e-3, 1e-2 * 50);  // at rest: tau_y m/2
  }
}

TEST(SedimentStrength, FollowsASlope) {
  // Surface z = 0.06 + 0.2 x: the height above a particle is the surface's minus its own, away from the ends.
  const Scene<2> scene = bed_scene();
  const auto surface = [](double x) { return 0.06 + 0.2 * x; };
  auto l = test::load(scene, test::fill_lattice(scene, [&](const Vec3& x) {
                        return x.z() < surface(x.x()) ? ParticleType::sediment : ParticleType::water;
                      }));
  apply_equation_of_state(l.on, l.p, scene);
  ColumnWeight<test::Device> weight;
  weigh_sediment(l.on, l.p, scene, weight);
  apply_rheology(l.on, l.p, scene);
  for (Index i = 0; i < l.p.count; ++i) {
    const double x = l.p.position[i].x[0];
    if (l.p.record[i].phase != phase_sediment || x < 0.05 || x > 0.15 || l.p.position[i].x[2] > 0.05) continue;
    const double expected = 300 * 9.81 * (surface(x) - l.p.position[i].x[2]);
    EXPECT_NEAR(l.p.sediment[i].effective_pressure, expected, 0.35 * scene.spacing * 300 * 9.81);
  }
}

TEST(SedimentStrength, DoesNotFeelTheWaterAbove) {
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
    auto l = test::load(scene, test::fill_lattice(scene, bed(top)));
    apply_equation_of_state(l.on, l.p, scene);
    ColumnWeight<test::Device> weight;
    weigh_sediment(l.on, l.p, scene, weight);
    apply_rheology(l.on, l.p, scene);
    pressures[run].resize(l.p.count);
    for (Index i = 0; i < l.p.fluid_count; ++i) {
      if (l.p.record[i].phase == phase_sediment)
        pressures[run][static_cast<std::size_t>(l.p.id[i])] = l.p.sediment[i].effective_pressure;
    }
    ++run;
  }
  EXPECT_EQ(pressures[0], pressures[1]);
}

}  // namespace
}  // namespace thalweg
