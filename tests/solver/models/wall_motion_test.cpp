#include "solver/models/moving_walls/wall_motion.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "case/reader/case_file.hpp"
#include "solver/models/moving_walls/make_motions.hpp"

namespace thalweg {
namespace {

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

TEST(SlidingSurface, RunsAsAGateIsLiftedAndStaysInPlace) {
  Case c;
  c.motions.resize(1);
  Motion& m = c.motions[0];
  m.kind = MotionKind::sliding_surface;
  m.direction = Vec3(2, 0, 0);
  m.start = 0.5;
  m.speed = 3;
  m.acceleration = 6;
  const WallMotion motion = make_motions(c).at(0);
  EXPECT_TRUE(motion.stays);
  EXPECT_EQ(motion.at(0.4).rate, 0);
  EXPECT_NEAR(motion.at(0.75).rate, 1.5, 1e-12);
  EXPECT_NEAR(motion.at(9).rate, 3, 1e-12) << "for ever";
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

}  // namespace
}  // namespace thalweg
