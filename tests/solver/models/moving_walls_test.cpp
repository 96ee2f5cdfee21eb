#include "solver/models/moving_walls/moving_walls.hpp"

#include <gtest/gtest.h>

#include "tests/solver/scenes.hpp"

namespace thalweg {
namespace {

using test::LatticeSetup;

template <class On>
class MovingWalls : public testing::Test {};
TYPED_TEST_SUITE(MovingWalls, test::Backends, test::BackendNames);

/// A column of water on a floor that moves, in a domain without gravity.
struct MovingFloor {
  Scene<2> scene;
  ParticleSet particles;

  explicit MovingFloor(const LatticeSetup<2>& setup = {}) : scene(test::make_scene_of(setup)) {
    particles = test::fill_lattice(
        scene, [](const Vec3& x) { return x.z() < 0.05 ? ParticleType::moving_wall : ParticleType::water; });
    auto& number = particles.scalars[motion_array];
    for (const ParticleType type : particles.type) number.push_back(type == ParticleType::moving_wall ? 1 : 0);
    scene.has_moving_walls = scene.walls_move = true;
  }
  template <class On>
  SimulationOn<2, On> simulation(const WallMotion& motion) const {
    return {On{}, "test", scene, particles, false, {motion}};
  }
};

/// Particles on the device whose walls move as `motion` says, lists built.
template <class On>
test::Loaded<2, On> load_with_motion(const Scene<2>& scene, const ParticleSet& particles, const WallMotion& motion) {
  test::Loaded<2, On> l{On{}, {}, scene};
  load_particles(l.on, l.p, scene, particles);
  load_motions(l.on, l.p, {motion}, particles);
  rebuild_lists(l.on, l.p, scene);
  return l;
}

ParticleSet by_id(const ParticleSet& p) {
  ParticleSet sorted = p;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto id = static_cast<std::size_t>(p.id[i]);
    sorted.position[id] = p.position[i];
    sorted.velocity[id] = p.velocity[i];
    sorted.type[id] = p.type[i];
    sorted.pressure[id] = p.pressure[i];
  }
  return sorted;
}

TYPED_TEST(MovingWalls, GoAsFarAsTheirVelocitySaysAcrossAKink) {
  const MovingFloor start;
  // From rest to 0.5 m/s at a time that no step meets.
  auto simulation = start.simulation<TypeParam>({{{1, 0, 0}, {0, 0, 0}, false}, {{1.23e-3, 0, 0.5}}});
  double way = 0;
  double time = 0;
  for (int n = 0; n < 10; ++n) {
    const double dt = simulation.advance(1).dt;
    time += dt;
    way += dt * double(by_id(simulation.snapshot()).velocity[0].x());
  }
  const ParticleSet end = by_id(simulation.snapshot());
  ASSERT_GT(time, 1.3e-3);
  EXPECT_NEAR(end.position[0].x() - start.particles.position[0].x(), 0.5 * (time - 1.23e-3), 1e-15);
  EXPECT_NEAR(way, 0.5 * (time - 1.23e-3), 1e-9) << "velocities are single precision";
}

TYPED_TEST(MovingWalls, AreParkedWhereTheDomainEndsAndComeBack) {
  const MovingFloor start;
  // Down by 0.03 m and back: three of five layers leave the domain; nobody is excluded.
  const double there = 2e-3, back = 4e-3;
  auto simulation = start.simulation<TypeParam>(
      {{{0, 0, -1}, {0, 0, 0}, false}, {{0, 0, 0.03 / there}, {there, 0.03, -0.03 / there}, {back, 0, 0}}});
  double time = 0;
  double lowest = 1;
  while (time < 1.1 * back) {
    const StepReport step = simulation.advance(1e-4);
    ASSERT_FALSE(step.diverged);
    ASSERT_TRUE(step.excluded.empty());
    time += step.dt;
    lowest = std::min(lowest, by_id(simulation.snapshot()).position[0].z());
  }
  EXPECT_LT(lowest, -0.02) << "its place is told truly";
  const ParticleSet end = by_id(simulation.snapshot());
  for (std::size_t i = 0; i < end.size(); ++i) {
    if (end.type[i] != ParticleType::moving_wall) continue;
    EXPECT_NEAR(end.position[i].z(), start.particles.position[i].z(), 1e-15);
  }
}

TYPED_TEST(MovingWalls, ContinueThePressureOfAFluidThatGoesWithThem) {
  // Fluid and floor accelerate together: p = p0 + rho (g - a) . x is linear, and the extrapolation exact.
  LatticeSetup<2> setup;
  setup.gravity = {0, -9.81F};
  setup.periodic = true;
  const MovingFloor start(setup);
  const double a[2] = {3, 2};
  const auto pressure = [&](const Vec3& x) { return 4000 - 1000 * (a[0] * x.x() + (9.81 + a[1]) * (x.z() - 0.05)); };
  const double norm = std::hypot(a[0], a[1]);
  const WallMotion motion{{{a[0] / norm, 0, a[1] / norm}, {0, 0, 0}, false}, {{0, 0, 0, norm}}};
  auto l = load_with_motion<TypeParam>(start.scene, start.particles, motion);
  hold_walls(l.on, l.p, start.scene, {motion}, 0);
  const auto at = [](const test::Seen& seen, Index i) { return Vec3(seen.position[i].x[0], 0, seen.position[i].x[2]); };
  test::change(l, [&](test::Seen& seen) {
    for (Index i = 0; i < seen.fluid_count; ++i) seen.record[i].pressure = static_cast<float>(pressure(at(seen, i)));
  });
  extrapolate_to_moving_walls(l.on, l.p, start.scene);
  const test::Seen seen = test::look(l);
  int checked = 0;
  for (Index i = seen.fluid_count; i < seen.count; ++i) {
    const Vec3 x = at(seen, i);
    // Around the periodic edge in x the pressure is not linear; walls a support below the fluid see none of it.
    if (x.x() < 0.04 || x.x() > 0.16 || x.z() < 0.03) continue;
    EXPECT_NEAR(seen.record[i].pressure, pressure(x), 2e-6 * 4000) << x.transpose();
    ++checked;
  }
  EXPECT_GT(checked, 20);
}

TYPED_TEST(MovingWalls, WakeTheSedimentInTheirReachAndNoOther) {
  LatticeSetup<2> setup;
  setup.gravity = {0, -9.81F};
  Scene<2> scene = test::make_scene_of(setup);
  scene.has_sediment = scene.may_rest = scene.has_moving_walls = scene.walls_move = true;
  scene.rest = {0.04F, 0.06F, 3e-3F, 0.01F};
  scene.sediment.yield_coefficient = 0.6F;
  ParticleSet set = test::fill_lattice(scene, [](const Vec3& x) {
    return x.x() < 0.04 ? ParticleType::moving_wall : x.z() < 0.04 ? ParticleType::wall : ParticleType::sediment;
  });
  auto& number = set.scalars[motion_array];
  for (const ParticleType type : set.type) number.push_back(type == ParticleType::moving_wall ? 1 : 0);
  const WallMotion motion{{{0, 0, 1}, {0, 0, 0}, false}, {{1, 0, 1e-3}}};
  auto l = load_with_motion<TypeParam>(scene, set, motion);
  test::change(l, [](test::Seen& seen) {
    for (Index i = 0; i < seen.fluid_count; ++i) seen.record[i].kind = kind::resting;
  });

  hold_walls(l.on, l.p, scene, {motion}, 0.5);
  list_active_clusters(l.on, l.p);
  test::TestStep step(l, 1e-4);
  wake_beside_moving_walls(l.on, l.p, scene, step.state());
  EXPECT_EQ(step.read().woken, 0U) << "it does not move yet";
  EXPECT_TRUE(hold_walls(l.on, l.p, scene, {motion}, 1));
  list_active_clusters(l.on, l.p);
  wake_beside_moving_walls(l.on, l.p, scene, step.state());
  EXPECT_GT(step.read().woken, 0U);
  const double support = double(scene.support());
  const auto to_wall = [](const test::Seen& seen, Index i) {
    return seen.position[i].x[0] - 0.035;  // nearest column of wall particles
  };
  test::change(l, [&](test::Seen& seen) {
    for (Index i = 0; i < seen.fluid_count; ++i) {
      EXPECT_EQ(is_resting(seen.record[i]), to_wall(seen, i) >= support) << to_wall(seen, i);
      seen.sediment[i].time_below_yield = 1;
    }
  });
  find_calm(l.on, l.p, scene, step.state());
  wake_and_stop(l.on, l.p, scene);
  const test::Seen seen = test::look(l);
  for (Index i = 0; i < seen.fluid_count; ++i) {
    if (to_wall(seen, i) >= support) continue;
    EXPECT_FALSE(is_resting(seen.record[i])) << "calm, but the wall beside it moves";
  }
}

}  // namespace
}  // namespace thalweg
