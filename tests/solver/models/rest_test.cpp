#include "solver/models/rest/rest.hpp"

#include <gtest/gtest.h>

#include "solver/step.hpp"
#include "tests/solver/scenes.hpp"

namespace thalweg {
namespace {

using test::LatticeSetup;

template <class On>
class Rest : public testing::Test {};
TYPED_TEST_SUITE(Rest, test::Backends, test::BackendNames);

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
  scene.acoustic_damping = 0.5F * scene.sound_speed * static_cast<float>(scene.smoothing_length);
  scene.rest = {0.04F, 0.06F, 3e-3F, 0.01F};
  return scene;
}

ParticleType bed_on_floor(const Vec3& x) {
  return x.z() < floor_height ? ParticleType::wall : (x.z() < 0.12 ? ParticleType::sediment : ParticleType::water);
}

Index resting_of(const test::Seen& seen) {
  Index n = 0;
  for (Index i = 0; i < seen.fluid_count; ++i) n += is_resting(seen.record[i]) ? 1 : 0;
  return n;
}

/// Lets all fluid have been calm for long.
void calm(test::Seen& seen) {
  for (Index i = 0; i < seen.fluid_count; ++i) seen.sediment[i].time_below_yield = 1;
}

/// The rest of the bed after so many steps of 1e-4 s in which particles may stop and wake, with the lists if they change.
/// Shows what came of it.
template <class On>
test::Seen update_rest_and_lists(test::Loaded<2, On>& l, const Scene<2>& scene, int steps = 1) {
  for (int n = 0; n < steps; ++n) {
    test::TestStep step(l, 1e-4);
    find_calm(l.on, l.p, scene, step.state());
    const bool waits = step.read().waiting > 0;
    const Index changed = wake_and_stop(l.on, l.p, scene);
    EXPECT_TRUE(waits || changed == 0) << "nobody waited";
    if (changed > 0) list_active_clusters(l.on, l.p);
  }
  return test::look(l);
}

TYPED_TEST(Rest, GrowsFromWhatHoldsIt) {
  const Scene<2> scene = resting_scene();
  auto l = test::load<TypeParam>(scene, test::fill_lattice(scene, bed_on_floor));
  test::change(l, calm);
  const test::Seen start = test::look(l);
  Index sediment = 0;
  for (Index i = 0; i < start.fluid_count; ++i) sediment += is_sediment(start.record[i]) ? 1 : 0;
  const Index first = resting_of(update_rest_and_lists(l, scene));
  EXPECT_GT(first, 0U);
  EXPECT_LT(first, sediment) << "the top is not held by the floor itself";
  EXPECT_EQ(resting_of(update_rest_and_lists(l, scene, 10)), sediment);
  EXPECT_TRUE(l.p.any_resting);
}

TYPED_TEST(Rest, IsNotForAClumpThatHoversInWater) {
  const Scene<2> scene = resting_scene();
  auto l = test::load<TypeParam>(
      scene, test::fill_lattice(scene, [](const Vec3& x) {
        return x.z() < floor_height ? ParticleType::wall : x.z() > 0.12 ? ParticleType::sediment : ParticleType::water;
      }));
  test::change(l, calm);
  EXPECT_EQ(resting_of(update_rest_and_lists(l, scene, 10)), 0U);
}

TYPED_TEST(Rest, WaitsForTheNeighboursAndEndsWhereTheyShear) {
  const Scene<2> scene = resting_scene();
  auto l = test::load<TypeParam>(scene, test::fill_lattice(scene, bed_on_floor));
  Index restless = 0;
  test::change(l, [&](test::Seen& seen) {
    while (!is_sediment(seen.record[restless]) || seen.position[restless].x[2] > 0.05) ++restless;
    calm(seen);
    seen.sediment[restless].strain_rate = 1;
  });
  test::Seen seen = update_rest_and_lists(l, scene, 20);
  EXPECT_FALSE(is_resting(seen.record[restless]));
  EXPECT_GT(resting_of(seen), 0U);
  for (Index i = 0; i < seen.fluid_count; ++i) {
    const double dx = seen.position[i].x[0] - seen.position[restless].x[0];
    const double dz = seen.position[i].x[2] - seen.position[restless].x[2];
    if (dx * dx + dz * dz < double(scene.support()) * double(scene.support())) {
      EXPECT_FALSE(is_resting(seen.record[i])) << "a moving particle is in reach";
    }
  }

  // One that rests is sheared: it wakes, and with it its way to rest begins anew.
  Index woken = 0;
  while (!is_resting(seen.record[woken])) ++woken;
  test::change(l, [&](test::Seen& s) { s.sediment[woken].strain_rate = 0.07F; });
  seen = update_rest_and_lists(l, scene);
  EXPECT_FALSE(is_resting(seen.record[woken]));
  EXPECT_EQ(seen.sediment[woken].time_below_yield, 0);
  // ... or its bed has become too steep.
  while (!is_resting(seen.record[woken])) ++woken;
  test::change(l, [&](test::Seen& s) { s.sediment[woken].bed_slope = 0.61F; });
  EXPECT_FALSE(is_resting(update_rest_and_lists(l, scene).record[woken]));
}

TYPED_TEST(Rest, WakesWithThePressureItHadBeforeAndNoVelocity) {
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
  auto l = test::load<TypeParam>(scene, p);
  apply_equation_of_state(l.on, l.p, scene);
  const test::Seen before = test::look(l);
  const auto rests = [&](Index i) { return is_sediment(before.record[i]) && before.position[i].x[2] < 0.08; };
  test::change(l, [&](test::Seen& seen) {
    for (Index i = 0; i < seen.fluid_count; ++i) {
      if (rests(i)) seen.record[i].kind = kind::resting;
    }
  });
  list_active_clusters(l.on, l.p);
  extrapolate_to_resting(l.on, l.p, scene);
  const test::Seen resting = test::look(l);
  test::change(l, [&](test::Seen& seen) {
    for (Index i = 0; i < seen.fluid_count; ++i) {
      if (rests(i)) seen.record[i].kind = kind::deposit;
    }
  });
  apply_equation_of_state(l.on, l.p, scene);
  const test::Seen woken = test::look(l);
  int front = 0;
  for (Index i = 0; i < before.fluid_count; ++i) {
    if (!rests(i) || before.position[i].x[2] < 0.06) continue;  // further down than a support: left alone
    ++front;
    const float felt = resting.record[i].pressure;
    EXPECT_NEAR(felt, before.record[i].pressure, 0.01 * before.record[i].pressure);
    EXPECT_NEAR(woken.record[i].pressure, felt, 1e-4 * felt) << "single precision of the density excess";
  }
  EXPECT_GT(front, 10);
}

TYPED_TEST(Rest, LeavesAStillBedOutOfEverySweep) {
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
  auto l = test::load<TypeParam>(scene, p);
  const test::Seen start = test::look(l);
  Workspace<TypeParam> work;
  Timing timing;
  double time = 0;
  Index resting = 0;
  std::int64_t changed = 0;  // the step
  while (time < 1.5 && resting < l.p.fluid_count) {
    const std::int64_t rebuilds = work.list_rebuilds;
    time += advance(l.on, l.p, scene, work, 1, timing).step.dt;
    const Index now = resting_of(test::look(l));
    if (now != resting || work.list_rebuilds > rebuilds) {
      const bool due = work.list_rebuilds > rebuilds || work.number - changed >= rest::most_steps;
      EXPECT_TRUE(due) << "step " << work.number << ", changed in step " << changed;
      changed = work.number;
    }
    resting = now;
  }
  // All steps but those with new lists, and those after a change, have launches that a GPU knows before.
  EXPECT_GE(work.launches.fixed, (work.number - work.list_rebuilds) * (rest::most_steps - 1) / rest::most_steps);

  const test::Seen end = test::look(l);
  EXPECT_EQ(resting_of(end), end.fluid_count);
  EXPECT_EQ(l.p.near_sediment().count, 0U) << "nothing is left to compute";
  EXPECT_EQ(l.p.rest_front().count, 0U);
  for (Index i = 0; i < end.count; ++i) {
    const auto at = std::find(start.id.begin(), start.id.end(), end.id[i]) - start.id.begin();
    EXPECT_NEAR(end.position[i].x[2], start.position[static_cast<std::size_t>(at)].x[2], 0.05 * scene.spacing);
  }
}

}  // namespace
}  // namespace thalweg
