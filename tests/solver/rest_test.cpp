#include "solver/models/rest/rest.hpp"

#include <gtest/gtest.h>

#include "scenes.hpp"
#include "solver/step.hpp"

namespace thalweg {
namespace {

using test::LatticeSetup;

constexpr double floor_height = 0.04;  // [m]

/// A bed on a floor, nothing above it.
Scene<2> resting_scene() {
  LatticeSetup<2> setup;
  setup.gravity = {0, -9.81F};
  Scene<2> scene = test::make_scene_of(setup);
  scene.has_sediment = scene.may_rest = true;
  scene.sediment.yield_coefficient = 0.6F;
  scene.sediment.friction_tangent = 0.78F;
  scene.sediment.regularisation = 100;
  scene.sediment.consistency = 1e-3F;
  scene.sediment.submerged_weight = 1300 * 9.81F;
  scene.rest = {0.04F, 0.06F, 3e-3F, 0.01F};
  return scene;
}

ParticleType bed_on_floor(const Vec3& x) {
  return x.z() < floor_height ? ParticleType::wall : (x.z() < 0.12 ? ParticleType::sediment : ParticleType::water);
}

Index resting_of(const test::Loaded<2>& l) {
  Index n = 0;
  for (Index i = 0; i < l.p.fluid_count; ++i) n += is_resting(l.p.record[i]) ? 1 : 0;
  return n;
}

TEST(Rest, GrowsFromWhatHoldsIt) {
  const Scene<2> scene = resting_scene();
  auto l = test::load(scene, test::fill_lattice(scene, bed_on_floor));
  Index sediment = 0;
  for (Index i = 0; i < l.p.fluid_count; ++i) {
    l.p.sediment[i].time_below_yield = 1;
    sediment += is_sediment(l.p.record[i]) ? 1 : 0;
  }
  test::update_rest_and_lists(l, scene, 1e-4);
  const Index first = resting_of(l);
  EXPECT_GT(first, 0U);
  EXPECT_LT(first, sediment) << "the top is not held by the floor itself";
  for (int k = 0; k < 10; ++k) test::update_rest_and_lists(l, scene, 1e-4);
  EXPECT_EQ(resting_of(l), sediment);
  EXPECT_TRUE(l.p.any_resting);
}

TEST(Rest, IsNotForAClumpThatHoversInWater) {
  const Scene<2> scene = resting_scene();
  auto l = test::load(
      scene, test::fill_lattice(scene, [](const Vec3& x) {
        return x.z() < floor_height ? ParticleType::wall : x.z() > 0.12 ? ParticleType::sediment : ParticleType::water;
      }));
  for (Index i = 0; i < l.p.fluid_count; ++i) l.p.sediment[i].time_below_yield = 1;
  for (int k = 0; k < 10; ++k) test::update_rest_and_lists(l, scene, 1e-4);
  EXPECT_EQ(resting_of(l), 0U);
}

TEST(Rest, WaitsForTheNeighboursAndEndsWhereTheyShear) {
  const Scene<2> scene = resting_scene();
  auto l = test::load(scene, test::fill_lattice(scene, bed_on_floor));
  Index restless = 0;
  while (!is_sediment(l.p.record[restless]) || l.p.position[restless].x[2] > 0.05) ++restless;
  for (Index i = 0; i < l.p.fluid_count; ++i) l.p.sediment[i].time_below_yield = 1;
  l.p.sediment[restless].strain_rate = 1;
  for (int k = 0; k < 20; ++k) test::update_rest_and_lists(l, scene, 1e-4);
  EXPECT_FALSE(is_resting(l.p.record[restless]));
  const Index around = resting_of(l);
  for (Index i = 0; i < l.p.fluid_count; ++i) {
    const double dx = l.p.position[i].x[0] - l.p.position[restless].x[0];
    const double dz = l.p.position[i].x[2] - l.p.position[restless].x[2];
    if (dx * dx + dz * dz < double(scene.support()) * double(scene.support())) {
      EXPECT_FALSE(is_resting(l.p.record[i])) << "a moving particle is in reach";
    }
  }
  EXPECT_GT(around, 0U);

  // One that rests is sheared: it wakes, and with it its way to rest begins anew.
  Index woken = 0;
  while (!is_resting(l.p.record[woken])) ++woken;
  l.p.sediment[woken].strain_rate = 0.07F;
  test::update_rest_and_lists(l, scene, 1e-4);
  EXPECT_FALSE(is_resting(l.p.record[woken]));
  EXPECT_EQ(l.p.sediment[woken].time_below_yield, 0);
  // ... or its bed has become too steep.
  while (!is_resting(l.p.record[woken])) ++woken;
  l.p.sediment[woken].bed_slope = 0.61F;
  test::update_rest_and_lists(l, scene, 1e-4);
  EXPECT_FALSE(is_resting(l.p.record[woken]));
}

TEST(Rest, WakesWithThePressureItHadBeforeAndNoVelocity) {
  // Hydrostatic sediment, the lower half at rest: pressures carry on through it, and waking changes none of them.
  Scene<2> scene = resting_scene();
  ParticleSet p = test::fill_lattice(scene, bed_on_floor);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.type[i] == ParticleType::wall) continue;
    const bool sediment = p.type[i] == ParticleType::sediment;
    const double z = p.position[i].z();
    const double pressure = 9.81 * (sediment ? 1000 * (0.2 - 0.12) + 1300 * (0.12 - z) : 1000 * (0.2 - z));
    const double rho0 = sediment ? 1300 : 1000;
    p.density[i] *= static_cast<float>(1 + tait_excess(pressure, rho0 * 400 / 7));
  }
  auto l = test::load(scene, p);
  apply_equation_of_state(l.on, l.p, scene);
  std::vector<float> before(l.p.fluid_count);
  for (Index i = 0; i < l.p.fluid_count; ++i) {
    before[i] = l.p.record[i].pressure;
    if (is_sediment(l.p.record[i]) && l.p.position[i].x[2] < 0.08) l.p.record[i].kind = kind::resting;
  }
  list_active_clusters(l.on, l.p);
  extrapolate_to_resting(l.on, l.p, scene);
  int front = 0;
  for (Index i = 0; i < l.p.fluid_count; ++i) {
    Record& r = l.p.record[i];
    if (!is_resting(r) || l.p.position[i].x[2] < 0.06) continue;  // further down than a support: left alone
    ++front;
    EXPECT_NEAR(r.pressure, before[i], 0.01 * before[i]);
    const float felt = r.pressure;
    r.kind = kind::deposit;
    apply_equation_of_state(l.on, l.p, scene);
    EXPECT_NEAR(r.pressure, felt, 1e-4 * felt) << "single precision of the density excess";
  }
  EXPECT_GT(front, 10);
}

TEST(Rest, LeavesAStillBedOutOfEverySweep) {
  Scene<2> scene = resting_scene();
  ParticleSet p = test::fill_lattice(scene, [](const Vec3& x) {
    return x.z() < floor_height || x.x() < floor_height || x.x() > 0.2 - floor_height ? ParticleType::wall
                                                                                      : ParticleType::sediment;
  });
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.type[i] == ParticleType::wall) continue;
    const double pressure = 1300 * 9.81 * (0.2 - p.position[i].z());
    p.density[i] *= static_cast<float>(1 + tait_excess(pressure, 1300.0 * 400 / 7));
  }
  auto l = test::load(scene, p);
  std::vector<double> start;
  for (Index i = 0; i < l.p.count; ++i) start.push_back(l.p.position[i].x[2]);
  const std::vector<std::int64_t> id(l.p.id.begin(), l.p.id.end());
  Workspace<test::Device> work;
  Timing timing;
  double time = 0;
  while (time < 1.5 && resting_of(l) < l.p.fluid_count) time += advance(l.on, l.p, scene, work, 1, timing).step.dt;

  EXPECT_EQ(resting_of(l), l.p.fluid_count);
  EXPECT_EQ(l.p.near_sediment().count, 0U) << "nothing is left to compute";
  EXPECT_EQ(l.p.rest_front().count, 0U);
  for (Index i = 0; i < l.p.count; ++i) {
    const auto at = std::find(id.begin(), id.end(), l.p.id[i]) - id.begin();
    EXPECT_NEAR(l.p.position[i].x[2], start[static_cast<std::size_t>(at)], 0.05 * scene.spacing);
  }
}

}  // namespace
}  // namespace thalweg
