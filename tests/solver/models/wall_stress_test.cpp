#include "solver/models/wall_stress/wall_stress.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "tests/solver/models/wall_stress_scenes.hpp"

namespace thalweg {
namespace {

using test::area_of;
using test::drag_on_water;
using test::friction_scene;
using test::load_with_elements;
using test::log_profile;

template <class On>
class WallStressOf : public testing::Test {};
TYPED_TEST_SUITE(WallStressOf, test::Backends, test::BackendNames);

/// A slot of water between two walls whose normal is along (nx, nz), whole numbers; periodic in both directions.
struct Slot {
  int nx = 0;
  int nz = 1;
  Scene<2> scene;
  double period;  // between a wall and its next image, along the normal [m]
  double share;   // of the period that is wall, whole layers of the lattice

  Slot(int across_x, int across_z, double spacing)
      : nx(across_x),
        nz(across_z),
        scene(friction_scene<2>(spacing, 0.24)),
        period(0.24 / std::hypot(across_x, across_z)),
        share(std::round(0.4 * 0.24 / spacing) * spacing / 0.24) {}

  /// Phase in the period: below `share` is wall. The walls' faces lie midway between layers of the lattice.
  [[nodiscard]] double phase(const Vec3& x) const {
    const double along = (nx * (x.x() - 0.5 * scene.spacing) + nz * (x.z() - 0.5 * scene.spacing)) / 0.24;
    const double phase = along + 0.5 * scene.spacing / 0.24;
    return phase - std::floor(phase);
  }
  /// Height above the nearer wall [m]; negative inside.
  [[nodiscard]] double height(const Vec3& x) const {
    const double f = phase(x);
    return period * (f < share ? -std::min(f, share - f) : std::min(f - share, 1 - f));
  }
  [[nodiscard]] ParticleSet fill(double jitter = 0.2) const {
    return test::fill_lattice(
        scene, [&](const Vec3& x) { return height(x) < 0 ? ParticleType::wall : ParticleType::water; }, jitter);
  }
  [[nodiscard]] Vec3 along() const { return Vec3(nz, 0, -nx).normalized(); }
  /// Of both walls [m].
  [[nodiscard]] double area() const { return 2 * 0.24 * std::hypot(nx, nz); }
};

/// The stress delivered to a logarithmic profile with noise, over rho u*^2.
template <class On>
double delivered(const Slot& slot, double ks, double friction_velocity, double jitter = 0.2) {
  ParticleSet particles = slot.fill(jitter);
  log_profile(
      particles, [&](const Vec3&) { return slot.along(); }, friction_velocity, ks,
      [&](const Vec3& x) { return slot.height(x); });
  auto l = load_with_elements<On>(slot.scene, particles);
  const double force = -drag_on_water(l).dot(slot.along());
  return force / (1000 * friction_velocity * friction_velocity * slot.area());
}

TYPED_TEST(WallStressOf, AFloorIsTheLawsAtEverySpacing) {
  // The water of a log profile feels rho u*^2; the expansion of the mean logarithm leaves about a percent.
  for (const double spacing : {0.01, 0.006, 0.004}) {
    for (const double ks : {0.0, 1e-3}) {
      EXPECT_NEAR(delivered<TypeParam>(Slot(0, 1, spacing), ks, 0.05), 1, 0.02) << spacing << " m, ks " << ks;
    }
  }
}

TYPED_TEST(WallStressOf, ASlopeIsTheLawsAtEveryAngleOnTheLattice) {
  // The areas are exact to half a percent. The stress is low: 0.99 at 1:1, 0.95 to 0.97 at the other slopes, where
  // displaced particles lie closer to the surface than on a floor; the cause is not separated.
  for (const auto& [nx, nz] : {std::pair(1, 1), std::pair(1, 2), std::pair(-1, 3), std::pair(2, 3)}) {
    for (const double spacing : {0.004, 0.003}) {
      const Slot slot(nx, nz, spacing);
      const auto l = load_with_elements<TypeParam>(slot.scene, slot.fill());
      EXPECT_NEAR(area_of(l) / slot.area(), 1, 0.005) << nx << ':' << nz;
      EXPECT_NEAR(delivered<TypeParam>(slot, 0, 0.05), 1, 0.06) << nx << ':' << nz << ", " << spacing << " m";
    }
  }
}

TYPED_TEST(WallStressOf, ACylinderIsTheLawsInsideAndOutside) {
  // 20 spacings of radius: areas of 1.014 inside and 0.992 outside, stress 0.97 and 0.94.
  const double R = 0.1;
  for (const bool inside : {true, false}) {
    const auto scene = friction_scene<2>(0.005, 0.32);
    const auto radial = [](const Vec3& x) { return Vec3(x.x() - 0.1612, 0, x.z() - 0.1594); };
    const auto height = [&](const Vec3& x) { return (inside ? 1 : -1) * (R - radial(x).norm()); };
    ParticleSet particles = test::fill_lattice(
        scene, [&](const Vec3& x) { return height(x) < 0 ? ParticleType::wall : ParticleType::water; }, 0.1);
    const auto around = [&](const Vec3& x) { return Vec3(-radial(x).z(), 0, radial(x).x()).normalized(); };
    log_profile(particles, around, 0.05, 0, height);
    auto l = load_with_elements<TypeParam>(scene, particles);
    EXPECT_NEAR(area_of(l) / (2 * std::numbers::pi * R), 1, 0.02) << inside;
    const double force = -drag_on_water(l, around);
    EXPECT_NEAR(force / (1000 * 0.05 * 0.05 * 2 * std::numbers::pi * R), 1, 0.06) << inside;
  }
}

TYPED_TEST(WallStressOf, APlaneInSpaceHasItsArea) {
  // A wall across (1, 1, 2) through a periodic cube; its area is L^2 |n| for each of its two sides.
  const auto scene = friction_scene<3>(0.01, 0.16);
  const ParticleSet particles = test::fill_lattice(scene, [&](const Vec3& x) {
    const double phase = (x.x() + x.y() + 2 * x.z()) / 0.16 - 0.5 * 0.01 / 0.16;
    return phase - std::floor(phase) < 0.5 ? ParticleType::wall : ParticleType::water;
  });
  const auto l = load_with_elements<TypeParam>(scene, particles);
  EXPECT_NEAR(area_of(l) / (2 * 0.16 * 0.16 * std::sqrt(6)), 1, 0.02);
}

TYPED_TEST(WallStressOf, TheWaterTakesWhatTheElementsGiveToRounding) {
  // A stress bound to rho U b does not depend on heights: the water has to take rho U b on the whole area.
  Slot slot(0, 1, 0.006);
  slot.scene.wall_stress.most_drag = 1e-6F;
  ParticleSet particles = slot.fill();
  test::uniform_current(particles, 0.8);
  auto l = load_with_elements<TypeParam>(slot.scene, particles);
  EXPECT_NEAR(drag_on_water(l).x() / (-1000 * 0.8 * 1e-6 * slot.area()), 1, 1e-5);
}

TYPED_TEST(WallStressOf, AWallOneParticleThickIsRefused) {
  const auto scene = friction_scene<2>(0.01, 0.2);
  const ParticleSet particles = test::fill_lattice(
      scene, [](const Vec3& x) { return std::abs(x.z() - 0.095) < 0.004 ? ParticleType::wall : ParticleType::water; });
  EXPECT_THROW((void)WallElementFinder<2>(scene, particles).find(), InputError);
}

TYPED_TEST(WallStressOf, AThinFilmOnARoughWallStopsAndNeverTurns) {
  // One layer, u* = kappa U: du/dt = -(kappa U)^2/dp, so that U = U0/(1 + kappa^2 U0 t/dp).
  const double dp = 0.005;
  auto scene = friction_scene<2>(dp, 0.1);
  scene.artificial_viscosity = 0;
  ParticleSet particles =
      test::fill_lattice(scene, [](const Vec3& x) { return x.z() < 0.03 ? ParticleType::wall : ParticleType::water; });
  test::keep(particles, [&](std::size_t i) { return particles.position[i].z() < 0.03 + dp; });
  auto& roughness = particles.scalars[roughness_array];
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const bool water = particles.type[i] == ParticleType::water;
    particles.velocity[i] = Eigen::Vector3f(water ? 2 : 0, 0, 0);
    roughness.push_back(water ? 0 : 0.05F);
  }
  SimulationOn<2, TypeParam> simulation{TypeParam{}, "test", scene, particles};
  double time = 0;
  double last = 2;
  for (int n = 0; n < 100; ++n) {
    time += simulation.advance(1).dt;
    const double U = test::mean_velocity(simulation.snapshot()).x();
    EXPECT_GE(U, 0);
    EXPECT_LT(U, last);
    last = U;
  }
  EXPECT_NEAR(last, 2 / (1 + 0.41 * 0.41 * 2 * time / dp), 0.02 * last);
}

TYPED_TEST(WallStressOf, ALidDragsStillWaterAsAFloorBrakesACurrent) {
  Slot slot(0, 1, 0.006);
  ParticleSet particles = slot.fill();
  test::uniform_current(particles, 0.8);
  auto current = load_with_elements<TypeParam>(slot.scene, particles);
  const double braked = drag_on_water(current).x();
  slot.scene.has_moving_walls = slot.scene.walls_move = true;
  auto& number = particles.scalars[motion_array];
  for (std::size_t i = 0; i < particles.size(); ++i) {
    particles.velocity[i].setZero();
    const bool moves = particles.type[i] == ParticleType::wall;
    if (moves) particles.type[i] = ParticleType::moving_wall;
    number.push_back(moves ? 1 : 0);
  }
  const WallMotion motion{{{1, 0, 0}, {0, 0, 0}, false}, {{0, 0, 0.8}}};
  auto lid = load_with_elements<TypeParam>(slot.scene, particles, {motion});
  hold_walls(lid.on, lid.p, slot.scene, {motion}, 0);
  EXPECT_LT(braked, 0);
  EXPECT_NEAR(drag_on_water(lid).x(), -braked, 1e-4 * -braked);
}

TYPED_TEST(WallStressOf, ATurningWallTakesItsNormalsAlong) {
  Slot slot(1, 2, 0.004);
  ParticleSet particles = slot.fill();
  slot.scene.has_moving_walls = slot.scene.walls_move = true;
  auto& number = particles.scalars[motion_array];
  for (ParticleType& type : particles.type) {
    if (type == ParticleType::wall) type = ParticleType::moving_wall;
    number.push_back(type == ParticleType::moving_wall ? 1 : 0);
  }
  const WallMotion motion{{{0, 1, 0}, {0.1, 0, 0.1}, true}, {{0, 0, 0.5}}};
  auto l = load_with_elements<TypeParam>(slot.scene, particles, {motion});
  turn_normals(l.on, l.p, {motion}, 2);  // by one radian
  const auto elements = test::copy_of(l.on, l.p.wall_element);
  const auto normals = test::copy_of(l.on, l.p.wall_normal);
  int checked = 0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements[i].area == 0) continue;
    // A point goes where the wall takes it; the normal is the difference of two.
    const double centre[3] = {0.1, 0, 0.1};
    const double tip[3] = {0.1 + elements[i].normal[0], 0, 0.1 + elements[i].normal[2]};
    double foot_now[3];
    double tip_now[3];
    moved_point(motion.axis, 1, centre, foot_now);
    moved_point(motion.axis, 1, tip, tip_now);
    for (const int c : {0, 2}) EXPECT_NEAR(normals[i].of[c], tip_now[c] - foot_now[c], 1e-6);
    ++checked;
  }
  EXPECT_GT(checked, 100);
}

TYPED_TEST(WallStressOf, ADecayingCurrentLosesTheImpulseOfTheWalls) {
  // Over 100 steps from a disordered start the momentum lost is 0.961 and 0.955 of the elements' impulse. The cause of the
  // 4 % is not separated; 1 % is due once it is.
  for (const double spacing : {0.01, 0.005}) {
    Slot slot(0, 1, spacing);
    ParticleSet particles = slot.fill();
    log_profile(
        particles, [&](const Vec3&) { return slot.along(); }, 0.1, 1e-3, [&](const Vec3& x) { return slot.height(x); });
    auto l = load_with_elements<TypeParam>(slot.scene, particles);
    Workspace<TypeParam> work;
    Timing timing;
    const double before = test::momentum(l).x();
    double impulse = 0;
    for (int n = 0; n < 100; ++n) {
      // The step that follows starts from the same places and velocities.
      const double force = drag_on_water(l).x();
      impulse += force * advance(l.on, l.p, l.scene, work, 1, timing).step.dt;
    }
    EXPECT_NEAR((test::momentum(l).x() - before) / impulse, 1, 0.06) << spacing;
    EXPECT_LT(impulse, -0.001 * before);
  }
}

}  // namespace
}  // namespace thalweg
