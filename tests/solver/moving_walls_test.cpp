#include "solver/models/moving_walls/moving_walls.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "case/reader/case_file.hpp"
#include "scenes.hpp"
#include "solver/models/moving_walls/make_motions.hpp"

namespace thalweg {
namespace {

using test::Device;
using test::LatticeSetup;
constexpr double pi = std::numbers::pi;
constexpr double rounding = 1e-15;

RigidAxis hinge() {
  const double third = 1 / std::sqrt(3.0);
  return {{third, -third, third}, {0.3, -0.2, 0.1}, true};
}

TEST(RigidMotion, TurnsCounterClockwiseInThePlane) {
  const RigidAxis axis{{0, -1, 0}, {1, 0, 2}, true};
  const double from[3] = {1.5, 0, 2};
  double to[3];
  moved_point(axis, pi / 2, from, to);
  EXPECT_NEAR(to[0], 1, rounding);
  EXPECT_NEAR(to[2], 2.5, rounding);
}

TEST(RigidMotion, IsBackAfterATurnToRounding) {
  const double from[3] = {1.5, 0.4, -2};
  double to[3];
  for (const int turns : {1, 2, 1000}) {
    moved_point(hinge(), 2 * pi * turns, from, to);
    // 2 pi is rounded itself: an arm of 3 m errs by that much times the turns.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(to[c], from[c], 3 * rounding * turns) << turns << " turns";
  }
}

TEST(RigidMotion, VelocityAndAccelerationAreItsDerivatives) {
  const auto place = [](double t) { return 0.3 + 0.7 * t - 1.1 * t * t; };
  const RigidState now{place(0.5), 0.7 - 1.1, -2.2};
  const double from[3] = {1.5, 0.4, -2};
  for (const bool turns : {false, true}) {
    RigidAxis axis = hinge();
    axis.turns = turns;
    const double dt = 1e-4;
    double before[3], at[3], after[3], u[3], a[3];
    moved_point(axis, place(0.5 - dt), from, before);
    moved_point(axis, place(0.5), from, at);
    moved_point(axis, place(0.5 + dt), from, after);
    rigid_velocity(axis, now.rate, at, u);
    rigid_acceleration(axis, now, at, a);
    for (int c = 0; c < 3; ++c) {
      // Central differences err by dt^2 times the third and fourth derivatives (some 10), and by rounding.
      EXPECT_NEAR(u[c], (after[c] - before[c]) / (2 * dt), 1e-6);
      EXPECT_NEAR(a[c], (after[c] - 2 * at[c] + before[c]) / (dt * dt), 1e-6);
    }
  }
}

class MotionOf : public testing::Test {
 protected:
  MotionOf() : motions_(make_motions(read_case(THALWEG_SOURCE_DIR "/tests/case/good_case_moving.toml"))) {}
  void expect(std::size_t motion, double t, double place, double rate, double change) const {
    const RigidState s = motions_.at(motion).at(t);
    EXPECT_NEAR(s.place, place, 1e-12) << t;
    EXPECT_NEAR(s.rate, rate, 1e-12) << t;
    EXPECT_NEAR(s.change, change, 1e-12) << t;
  }
  std::vector<WallMotion> motions_;
};

TEST_F(MotionOf, ATableIsLinearBetweenItsRowsAndRestsOutside) {
  expect(0, 0.25, 0.025, 0.1, 0);
  expect(0, 5, 0.1, 0, 0);
  expect(2, 0.75, 0, -20 * pi / 180 / 0.5, 0);
}

TEST_F(MotionOf, AGateWaitsSpeedsUpAndStops) {
  // 9 m/s^2 from 0.1 s on: 1 m/s after 1/9 s and 1/18 m; the other 0.4 - 1/18 m at that speed.
  expect(1, 0.05, 0, 0, 0);
  expect(1, 0.2, 0.5 * 9 * 0.01, 0.9, 9);
  const double run_up = 1.0 / 9;
  expect(1, 0.1 + run_up + 0.1, 1.0 / 18 + 0.1, 1, 0);
  const double stop = 0.1 + run_up + (0.4 - 1.0 / 18);
  expect(1, stop + 0.01, 0.4, 0, 0);
  EXPECT_DOUBLE_EQ(motions_[1].axis.direction[2], 1) << "directions may have any length";
}

TEST_F(MotionOf, ARotationGoesOn) {
  expect(3, 10, 20, 2, 0);
  EXPECT_EQ(motions_[3].axis.direction[1], -1);
}

TEST(Motions, CountFromWhereTheyAreAtTheStart) {
  Case c = read_case(THALWEG_SOURCE_DIR "/tests/case/good_case_moving.toml");
  c.motions[0].displacements = {3, 4};
  EXPECT_NEAR(make_motions(c)[0].at(0).place, 0, 1e-15);
  EXPECT_NEAR(make_motions(c)[0].at(1).place, 1, 1e-15);
}

TEST(Motions, TellTheirLargestSpeed) {
  const std::vector<WallMotion> motions{
      {{{1, 0, 0}, {0, 0, 0}, false}, {{0, 0, 0, 3}, {0.5, 0.375, 0.1}}},   // 1.5 m/s at 0.5 s
      {{{0, -1, 0}, {1, 0, 0}, true}, {{0, 0, 2}}},                         // 2 rad/s at arms up to 0.4 m
      {{{1, 0, 0}, {0, 0, 0}, false}, {{0, 0, 0, 0, 0.02, 2 * pi / 0.1}}},  // 0.02 m in 0.1 s
      {{{1, 0, 0}, {0, 0, 0}, false}, {{7, 0, 100}}}};                      // after the end
  ParticleSet walls;
  const auto with = [&](float motion) {
    walls.scalars[motion_array] = {0, motion, motion};
    return largest_wall_speed(motions, walls, 1);
  };
  walls.id = {0, 1, 2};
  walls.position = {Vec3(9, 0, 9), Vec3(1.3, 0, 0), Vec3(1, 0, -0.4)};
  EXPECT_EQ(with(0), 0);
  EXPECT_NEAR(with(1), 1.5, 1e-12);
  EXPECT_NEAR(with(2), 0.8, 1e-12);
  EXPECT_NEAR(with(3), 0.4 * pi, 1e-12);
  EXPECT_EQ(with(4), 0);
}

TEST(Motions, OscillateFromOneEndOfTheStroke) {
  Case c = read_case(THALWEG_SOURCE_DIR "/tests/case/good_case_moving.toml");
  c.motions[0].kind = MotionKind::oscillation;
  c.motions[0].amplitude = 0.02;
  c.motions[0].period = 0.8;
  const WallMotion motion = make_motions(c)[0];
  EXPECT_NEAR(motion.at(0).rate, 0, 1e-15);
  EXPECT_NEAR(motion.at(0.4).place, 0.04, 1e-15);
  EXPECT_NEAR(motion.at(0.2).rate, 0.02 * 2 * pi / 0.8, 1e-12);
}

/// A column of water on a floor that moves, in a domain without gravity.
struct MovingFloor {
  Scene<2> scene;
  ParticleSet particles;

  explicit MovingFloor(const LatticeSetup<2>& setup = {}) : scene(test::make_scene_of(setup)) {
    particles = test::fill_lattice(
        scene, [](const Vec3& x) { return x.z() < 0.05 ? ParticleType::moving_wall : ParticleType::water; });
    auto& number = particles.scalars[motion_array];
    for (const ParticleType type : particles.type) number.push_back(type == ParticleType::moving_wall ? 1 : 0);
    scene.has_moving_walls = true;
  }
  SimulationOn<2, Device> simulation(const WallMotion& motion) const {
    return {Device{}, "test", scene, particles, false, {motion}};
  }
};

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

TEST(MovingWalls, GoAsFarAsTheirVelocitySaysAcrossAKink) {
  const MovingFloor start;
  // From rest to 0.5 m/s at a time that no step meets.
  auto simulation = start.simulation({{{1, 0, 0}, {0, 0, 0}, false}, {{1.23e-3, 0, 0.5}}});
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

TEST(MovingWalls, AreParkedWhereTheDomainEndsAndComeBack) {
  const MovingFloor start;
  // Down by 0.03 m and back: three of five layers leave the domain; nobody is excluded.
  const double there = 2e-3, back = 4e-3;
  auto simulation = start.simulation(
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

TEST(MovingWalls, ContinueThePressureOfAFluidThatGoesWithThem) {
  // Fluid and floor accelerate together: p = p0 + rho (g - a) . x is linear, and the extrapolation exact.
  LatticeSetup<2> setup;
  setup.gravity = {0, -9.81F};
  setup.periodic = true;
  const MovingFloor start(setup);
  const double a[2] = {3, 2};
  const auto pressure = [&](const Vec3& x) { return 4000 - 1000 * (a[0] * x.x() + (9.81 + a[1]) * (x.z() - 0.05)); };
  Device on;
  Particles<Device> p;
  load_particles(on, p, start.scene, start.particles);
  const double norm = std::hypot(a[0], a[1]);
  const WallMotion motion{{{a[0] / norm, 0, a[1] / norm}, {0, 0, 0}, false}, {{0, 0, 0, norm}}};
  load_motions(on, p, {motion}, start.particles);
  rebuild_lists(on, p, start.scene);
  hold_walls(on, p, start.scene, {motion}, 0);
  const auto at = [&](Index i) { return Vec3(p.position[i].x[0], 0, p.position[i].x[2]); };
  for (Index i = 0; i < p.fluid_count; ++i) p.record[i].pressure = static_cast<float>(pressure(at(i)));
  extrapolate_to_walls(on, p, start.scene);
  int checked = 0;
  for (Index i = p.fluid_count; i < p.count; ++i) {
    const Vec3 x = at(i);
    // Around the periodic edge in x the pressure is not linear; walls a support below the fluid see none of it.
    if (x.x() < 0.04 || x.x() > 0.16 || x.z() < 0.03) continue;
    EXPECT_NEAR(p.record[i].pressure, pressure(x), 2e-6 * 4000) << x.transpose();
    ++checked;
  }
  EXPECT_GT(checked, 20);
}

TEST(MovingWalls, WakeTheSedimentInTheirReachAndNoOther) {
  LatticeSetup<2> setup;
  setup.gravity = {0, -9.81F};
  Scene<2> scene = test::make_scene_of(setup);
  scene.has_sediment = scene.may_rest = scene.has_moving_walls = true;
  scene.rest = {0.04F, 0.06F, 3e-3F, 0.01F};
  scene.sediment.yield_coefficient = 0.6F;
  ParticleSet set = test::fill_lattice(scene, [](const Vec3& x) {
    return x.x() < 0.04 ? ParticleType::moving_wall : x.z() < 0.04 ? ParticleType::wall : ParticleType::sediment;
  });
  auto& number = set.scalars[motion_array];
  for (const ParticleType type : set.type) number.push_back(type == ParticleType::moving_wall ? 1 : 0);
  Device on;
  Particles<Device> p;
  load_particles(on, p, scene, set);
  const WallMotion motion{{{0, 0, 1}, {0, 0, 0}, false}, {{1, 0, 1e-3}}};
  load_motions(on, p, {motion}, set);
  rebuild_lists(on, p, scene);
  for (Index i = 0; i < p.fluid_count; ++i) p.record[i].kind = kind::resting;

  hold_walls(on, p, scene, {motion}, 0.5);
  list_active_clusters(on, p);
  StepState state = test::step_of(1e-4);
  wake_beside_moving_walls(on, p, scene, &state);
  EXPECT_EQ(state.woken, 0U) << "it does not move yet";
  EXPECT_TRUE(hold_walls(on, p, scene, {motion}, 1));
  list_active_clusters(on, p);
  wake_beside_moving_walls(on, p, scene, &state);
  EXPECT_GT(state.woken, 0U);
  const double support = double(scene.support());
  for (Index i = 0; i < p.fluid_count; ++i) {
    const double to_wall = p.position[i].x[0] - 0.035;  // nearest column of wall particles
    EXPECT_EQ(is_resting(p.record[i]), to_wall >= support) << to_wall;
    p.sediment[i].time_below_yield = 1;
  }
  update_rest(on, p, scene, &state);
  for (Index i = 0; i < p.fluid_count; ++i) {
    const double to_wall = p.position[i].x[0] - 0.035;
    if (to_wall >= support) continue;
    EXPECT_FALSE(is_resting(p.record[i])) << "calm, but the wall beside it moves";
  }
}

}  // namespace
}  // namespace thalweg
