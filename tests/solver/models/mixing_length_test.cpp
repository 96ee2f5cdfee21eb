#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/solver/models/wall_stress_scenes.hpp"

namespace thalweg {
namespace {

constexpr double density = 1000;  // [kg/m^3]

template <class On>
class MixingLengthOn : public testing::Test {};
TYPED_TEST_SUITE(MixingLengthOn, test::Backends, test::BackendNames);

/// A scene that is not periodic, whose water feels walls and has a mixing length.
template <int Dim>
Scene<Dim> eddy_scene(double spacing, double length, bool periodic = false) {
  test::LatticeSetup<Dim> setup;
  setup.spacing = spacing;
  setup.length = length;
  setup.smoothing_ratio = 2;
  setup.periodic = periodic;
  Scene<Dim> scene = test::make_scene_of(setup);
  scene.needs_near_walls = true;
  scene.wall_stress = {true, 1e-6F, 0.1F, 1};
  scene.mixing_length = true;
  return scene;
}

/// Distance and depth at each particle, after the two searches.
template <int Dim, class On>
HostBuffer<Eddies> searched(test::Loaded<Dim, On>& l) {
  MixingLengthWork<On> work;
  find_wall_distances(l.on, l.p, l.scene, work.wall_distance);
  find_local_depths(l.on, l.p, l.scene, work.local_depth);
  return test::copy_of(l.on, l.p.eddies);
}

/// A floor at 3 cm with a step of 5 cm from x = 12 cm on, under water up to 16 cm.
struct Step {
  static bool is_solid(const Vec3& x) { return x.z() < 0.03 || (x.x() > 0.12 && x.z() < 0.08); }
  static double distance(double x, double z) {
    return std::min(z - 0.03, std::hypot(std::max(0.12 - x, 0.0), std::max(z - 0.08, 0.0)));
  }
};

TYPED_TEST(MixingLengthOn, DistancesAndDepthsFollowAStep) {
  const double dp = 0.005;
  const Scene<2> scene = eddy_scene<2>(dp, 0.2);
  ParticleSet particles = test::fill_lattice(
      scene, [](const Vec3& x) { return Step::is_solid(x) ? ParticleType::wall : ParticleType::water; });
  const ParticleSet all = particles;
  test::keep(particles, [&](std::size_t i) { return all.position[i].z() < 0.16; });
  auto l = test::load_with_elements<TypeParam>(scene, particles);
  const HostBuffer<Eddies> eddies = searched(l);
  const test::Seen seen = test::look(l);
  int plane = 0;
  for (Index i = 0; i < seen.fluid_count; ++i) {
    const double x = seen.position[i].x[0];
    const double z = seen.position[i].x[2];
    const double exact = Step::distance(x, z);
    const double error = double(eddies[i].wall_distance) - exact;
    if (x < 0.03 || x > 0.17) continue;  // the walls end there, and turn their faces outwards
    // Smoothed normals (models/wall_stress) turn the edge into a bevel, whose nearest element is up to 0.86 dp farther
    // away than the tip: an edge is known to a spacing.
    EXPECT_LT(std::abs(error), dp) << x << " " << z;
    const bool over_plane = (x < 0.12 && z - 0.03 < 0.8 * (0.12 - x) && x < 0.105) || (x > 0.14 && z > 0.08);
    if (over_plane) {
      ++plane;
      EXPECT_LT(std::abs(error), 0.02 * dp) << x << " " << z;
    }
    if (x < 0.095) {
      EXPECT_NEAR(eddies[i].depth, 0.13, 1e-4) << x;
    } else if (x > 0.145) {
      EXPECT_NEAR(eddies[i].depth, 0.08, 1e-4) << x;
    } else {
      EXPECT_GE(eddies[i].depth, 0.08 - 1e-4);
      EXPECT_LE(eddies[i].depth, 0.13 + 1e-4);
    }
  }
  EXPECT_GT(plane, 200);
}

TYPED_TEST(MixingLengthOn, ASideWallCountsAsAFloorDoesInSpace) {
  const double dp = 0.01;
  const Scene<3> scene = eddy_scene<3>(dp, 0.12);
  const ParticleSet particles = test::fill_lattice(
      scene, [](const Vec3& x) { return x.z() < 0.03 || x.y() < 0.03 ? ParticleType::wall : ParticleType::water; });
  auto l = test::load_with_elements<TypeParam>(scene, particles);
  const HostBuffer<Eddies> eddies = searched(l);
  const test::Seen seen = test::look(l);
  for (Index i = 0; i < seen.fluid_count; ++i) {
    const double* x = seen.position[i].x;
    EXPECT_NEAR(eddies[i].depth, 0.09, 1e-4);
    // The walls end at the edge of the domain, and turn their faces outwards there.
    if (x[0] < 0.03 || x[0] > 0.09 || x[1] > 0.09 || x[2] > 0.09) continue;
    const double error = double(eddies[i].wall_distance) - std::min(x[1] - 0.03, x[2] - 0.03);
    EXPECT_LT(std::abs(error), 0.5 * dp);  // beside the edge of both
    if (std::abs(x[1] - x[2]) > 0.025) {
      // Three spacings from the edge the smoothed normals are still turned a little: 0.035 dp.
      EXPECT_LT(std::abs(error), 0.05 * dp) << x[1] << " " << x[2];
    }
  }
}

TYPED_TEST(MixingLengthOn, ABedIsAFloor) {
  const double dp = 0.005;
  Scene<2> scene = eddy_scene<2>(dp, 0.2);
  scene.has_sediment = true;
  const ParticleSet particles = test::fill_lattice(scene, [](const Vec3& x) {
    return x.z() < 0.02 ? ParticleType::wall : x.z() < 0.07 ? ParticleType::sediment : ParticleType::water;
  });
  auto l = test::load_with_elements<TypeParam>(scene, particles);
  const HostBuffer<Eddies> eddies = searched(l);
  const test::Seen seen = test::look(l);
  int checked = 0;
  for (Index i = 0; i < seen.fluid_count; ++i) {
    if (!is_water(seen.record[i])) continue;
    const double x = seen.position[i].x[0];
    if (x < 0.025 || x > 0.175) continue;  // half of the support is missing beside the ends
    ++checked;
    EXPECT_NEAR(eddies[i].wall_distance, seen.position[i].x[2] - 0.07, 0.02 * dp);
    EXPECT_NEAR(eddies[i].depth, 0.13, 1e-4);
  }
  EXPECT_GT(checked, 700);
}

TYPED_TEST(MixingLengthOn, WaterWithoutAWallHasNoEddies) {
  const Scene<2> scene = eddy_scene<2>(0.01, 0.2, true);
  auto l = test::load_with_elements<TypeParam>(scene, test::fill_lattice(scene, test::all_water));
  const HostBuffer<Eddies> eddies = searched(l);
  for (Index i = 0; i < l.p.fluid_count; ++i) EXPECT_EQ(eddies[i].wall_distance, 0);
}

TYPED_TEST(MixingLengthOn, TheViscosityOfALinearShearIsExact) {
  // Corrected gradients are exact in a linear flow, at free faces too: l^2 |S| with d = 25 mm, H = 100 mm, |S| = 10 1/s.
  const Scene<2> scene = eddy_scene<2>(0.005, 0.1);
  ParticleSet particles = test::fill_lattice(scene, test::all_water, 0.2);
  for (std::size_t i = 0; i < particles.size(); ++i)
    particles.velocity[i].x() = 1 + 10 * static_cast<float>(particles.position[i].z());
  auto l = test::load_with_elements<TypeParam>(scene, particles);
  l.on.upload(HostBuffer<Eddies>(l.p.count, Eddies{0.025F, 0.1F, 0}), l.p.eddies);
  test::TestStep<2, TypeParam> step(l, 1e-4);
  find_eddy_viscosity(l.on, l.p, l.scene, step.state(), false);  // step 0 is one of those that find it
  const HostBuffer<Eddies> eddies = test::copy_of(l.on, l.p.eddies);
  const test::Seen seen = test::look(l);
  const double exact = 8.8768e-3 * 8.8768e-3 * 10;
  for (Index i = 0; i < seen.fluid_count; ++i) {
    EXPECT_NEAR(eddies[i].viscosity, exact, 1e-3 * exact);
    EXPECT_NEAR(seen.record[i].viscosity, density * exact, 1e-3 * density * exact);
  }
}

TYPED_TEST(MixingLengthOn, OtherStepsKeepTheViscosity) {
  const Scene<2> scene = eddy_scene<2>(0.01, 0.2, true);
  auto l = test::load_with_elements<TypeParam>(scene, test::fill_lattice(scene, test::all_water));
  l.on.upload(HostBuffer<Eddies>(l.p.count, Eddies{0.025F, 0.1F, 1e-3F}), l.p.eddies);
  test::TestStep<2, TypeParam> step(l, 1e-4);
  StepState now = step.read();
  now.number = 1;
  l.on.write(now, step.state());
  find_eddy_viscosity(l.on, l.p, l.scene, step.state(), false);
  EXPECT_EQ(test::copy_of(l.on, l.p.eddies)[0].viscosity, 1e-3F);
  find_eddy_viscosity(l.on, l.p, l.scene, step.state(), true);
  EXPECT_EQ(test::copy_of(l.on, l.p.eddies)[0].viscosity, 0);  // water at rest has no eddies
}

TYPED_TEST(MixingLengthOn, EddiesTakeEnergyAndNoMomentum) {
  // u = U sin(2 pi z/L) with one viscosity: a = -nu k^2 u, which the pair sum gives to 2 % at 20 particles a wave,
  // jittered. A viscosity that varies by a factor of three keeps the momentum all the same.
  const double L = 0.2;
  const double k = 2 * M_PI / L;
  for (const bool varied : {false, true}) {
    const Scene<2> scene = eddy_scene<2>(0.01, L, true);
    ParticleSet particles = test::fill_lattice(scene, test::all_water, 0.05);
    for (std::size_t i = 0; i < particles.size(); ++i)
      particles.velocity[i].x() = static_cast<float>(std::sin(k * particles.position[i].z()));
    auto l = test::load_with_elements<TypeParam>(scene, particles);
    test::change(l, [&](test::Seen& seen) {
      for (Index i = 0; i < seen.fluid_count; ++i) seen.record[i].viscosity = varied && i % 3 == 0 ? 3.0F : 1.0F;
    });
    compute_accelerations(l.on, l.p, l.scene);
    const test::Seen without = test::look(l);
    compute_accelerations_with_eddies(l.on, l.p, l.scene);
    const test::Seen with = test::look(l);
    double momentum = 0;
    double sizes = 0;
    double power = 0;
    double due = 0;
    for (Index i = 0; i < with.fluid_count; ++i) {
      const double force =
          double(with.mass[i]) * double(with.rates[i].acceleration[0] - without.rates[i].acceleration[0]);
      const double u = double(with.record[i].velocity[0]);
      momentum += force;
      sizes += std::abs(force);
      power += force * u;
      due -= double(with.mass[i]) * 1e-3 * k * k * u * u;
    }
    EXPECT_LT(std::abs(momentum), 1e-5 * sizes);
    EXPECT_LT(power, 0);
    if (!varied) {
      EXPECT_NEAR(power, due, 0.03 * std::abs(due));
    }
  }
}

TYPED_TEST(MixingLengthOn, ASceneWithoutItHasNoArrays) {
  const Scene<2> scene = test::make_scene_of(test::LatticeSetup<2>{});
  auto l = test::load<TypeParam>(scene, test::fill_lattice(scene, test::all_water));
  EXPECT_TRUE(l.p.eddies.empty());
}

TYPED_TEST(MixingLengthOn, ADriveMovesWaterAndNotTheBed) {
  Scene<2> scene = eddy_scene<2>(0.01, 0.2);
  scene.has_sediment = true;
  scene.current.on = true;
  scene.current.start.acceleration = 0.25;
  const ParticleSet particles = test::fill_lattice(scene, [](const Vec3& x) {
    return x.z() < 0.02 ? ParticleType::wall : x.z() < 0.07 ? ParticleType::sediment : ParticleType::water;
  });
  auto l = test::load_with_elements<TypeParam>(scene, particles);
  test::TestStep<2, TypeParam> step(l, 1e-4);
  load_control(l.on, step.work, l.scene, particles);
  test::change(l, [](test::Seen& seen) {
    for (Rates& r : seen.rates) r = {};
  });
  CurrentModel::add_forces(step.step);
  const test::Seen seen = test::look(l);
  for (Index i = 0; i < seen.fluid_count; ++i) {
    EXPECT_EQ(seen.rates[i].acceleration[0], is_water(seen.record[i]) ? 0.25F : 0.0F);
    EXPECT_EQ(seen.rates[i].acceleration[2], 0);
  }
}

TYPED_TEST(MixingLengthOn, AControlReadsTheVelocityOfTheWater) {
  Scene<2> scene = eddy_scene<2>(0.01, 0.2);
  scene.current.on = scene.current.controlled = true;
  scene.current.start = {0.5, 0.2, 0.3, 0.01, 1.01};
  ParticleSet particles = test::fill_lattice(scene, test::all_water);
  for (auto& u : particles.velocity) u.x() = 0.4F;
  auto l = test::load_with_elements<TypeParam>(scene, particles);
  test::TestStep<2, TypeParam> step(l, 0.1);
  load_control(l.on, step.work, l.scene, particles);
  CurrentModel::after_step(step.step);
  const CurrentControl now = l.on.read(step.work.control.data());
  EXPECT_NEAR(now.velocity, 0.4, 1e-7);
  // D += [0.1 (1.01 - 0.01) - (0.4 - 0.3)]/0.2 = 0;  g = D + (0.5 - 0.4)/0.2
  EXPECT_NEAR(now.drag, 0.01, 1e-6);
  EXPECT_NEAR(now.acceleration, 0.51, 1e-6);
  ParticleSet checkpoint;
  add_control(now, checkpoint);
  const CurrentControl again = control_of(checkpoint, scene.current);
  EXPECT_EQ(again.drag, now.drag);
  EXPECT_EQ(again.acceleration, now.acceleration);
  EXPECT_EQ(again.target, 0.5);
}

}  // namespace
}  // namespace thalweg
