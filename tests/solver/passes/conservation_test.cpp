#include <gtest/gtest.h>

#include "tests/solver/scenes.hpp"

namespace thalweg {
namespace {

using test::LatticeSetup;

/// Fluid of both phases, jittered, with velocities and pressures that have nothing to do with equilibrium.
template <int Dim, class On>
test::Loaded<Dim, On> stirred() {
  LatticeSetup<Dim> setup;
  setup.periodic = true;
  setup.length = Dim == 3 ? 0.1 : 0.2;
  Scene<Dim> scene = test::make_scene_of(setup);
  scene.has_sediment = true;
  scene.water_viscosity = 0.5;
  ParticleSet p = test::fill_lattice(
      scene, [&](const Vec3& x) { return x.z() < 0.05 ? ParticleType::sediment : ParticleType::water; }, 0.3);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> number(-1, 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.velocity[i] = Eigen::Vector3f(number(random), Dim == 3 ? number(random) : 0, number(random));
    p.density[i] *= 1 + 0.01F * number(random);
  }
  auto l = test::load<On>(scene, p);
  apply_equation_of_state(l.on, l.p, scene);
  return l;
}

template <int Dim, class On>
void expect_no_net_force() {
  auto l = stirred<Dim, On>();
  compute_accelerations(l.on, l.p, l.scene);
  const test::Seen seen = test::look(l);
  double net[3] = {0, 0, 0};
  double magnitude = 0;
  for (Index i = 0; i < seen.count; ++i) {
    for (int c = 0; c < 3; ++c) {
      net[c] += double(seen.mass[i]) * double(seen.rates[i].acceleration[c]);
      magnitude += std::abs(double(seen.mass[i]) * double(seen.rates[i].acceleration[c]));
    }
  }
  ASSERT_GT(magnitude, 0);
  // Each pair cancels up to single rounding (6e-8) of terms up to ten times their sum; signs are random.
  for (const double n : net) EXPECT_LT(std::abs(n) / magnitude, 2e-7);
}

template <class On>
class Momentum : public testing::Test {};
TYPED_TEST_SUITE(Momentum, test::Backends, test::BackendNames);

TYPED_TEST(Momentum, IsConservedByThePairForcesInThePlane) { expect_no_net_force<2, TypeParam>(); }
TYPED_TEST(Momentum, IsConservedByThePairForcesInSpace) { expect_no_net_force<3, TypeParam>(); }

template <class On>
class PassesOnLattices : public testing::Test {};
TYPED_TEST_SUITE(PassesOnLattices, test::Backends, test::BackendNames);

TYPED_TEST(PassesOnLattices, GiveTheDensityRateOfAUniformExpansion) {
  // A uniform expansion u = s x has div u = 2 s in the plane: the excess falls at 2 s (1 + excess) inside.
  LatticeSetup<2> setup;
  const Scene<2> scene = test::make_scene_of(setup);
  ParticleSet p = test::fill_lattice(scene, test::all_water);
  const float s = 3;
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.velocity[i] = s * Eigen::Vector3f(float(p.position[i].x()), 0, float(p.position[i].z()));
  }
  auto l = test::load<TypeParam>(scene, p);
  apply_equation_of_state(l.on, l.p, scene);
  compute_density_rates(l.on, l.p, scene);
  const test::Seen seen = test::look(l);
  int inside = 0;
  for (Index i = 0; i < seen.count; ++i) {
    const double x = seen.position[i].x[0];
    const double z = seen.position[i].x[2];
    if (x < 0.05 || x > 0.15 || z < 0.05 || z > 0.15) continue;
    ++inside;
    // h/dp = 1.5: the lattice sum of r.grad W is 1 to about half a percent.
    EXPECT_NEAR(seen.rates[i].excess_rate, -2 * s, 0.006 * 2 * s);
  }
  EXPECT_GT(inside, 50);
}

TYPED_TEST(PassesOnLattices, GiveTheExactStrainRateOfALinearFieldOnAnyArrangement) {
  // Simple shear gdot = 5 1/s plus rotation plus expansion: D's deviator has gdot = sqrt(2 D:D) = 5.
  LatticeSetup<2> setup;
  Scene<2> scene = test::make_scene_of(setup);
  scene.has_sediment = true;
  ParticleSet p = test::fill_lattice(
      scene, [](const Vec3&) { return ParticleType::sediment; }, 0.2);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto x = float(p.position[i].x());
    const auto z = float(p.position[i].z());
    p.velocity[i] = Eigen::Vector3f(5 * z + 2 * z + x, 0, -2 * x + z);
  }
  auto l = test::load<TypeParam>(scene, p);
  apply_equation_of_state(l.on, l.p, scene);
  compute_density_rates(l.on, l.p, scene);
  const test::Seen seen = test::look(l);
  for (Index i = 0; i < seen.count; ++i) EXPECT_NEAR(seen.sediment[i].strain_rate, 5, 5e-4);  // also at the free edges
}

TYPED_TEST(PassesOnLattices, ContinueAHydrostaticColumnIntoWalls) {
  LatticeSetup<2> setup;
  setup.gravity = {0, -9.81F};
  const Scene<2> scene = test::make_scene_of(setup);
  ParticleSet p =
      test::fill_lattice(scene, [](const Vec3& x) { return x.z() < 0.04 ? ParticleType::wall : ParticleType::water; });
  auto l = test::load<TypeParam>(scene, p);
  test::change(l, [](test::Seen& seen) {
    for (Index i = 0; i < seen.fluid_count; ++i) {
      seen.record[i].pressure = static_cast<float>(1000 * 9.81 * (0.2 - seen.position[i].x[2]));
    }
  });
  extrapolate_to_walls(l.on, l.p, scene);
  const test::Seen seen = test::look(l);
  int checked = 0;
  for (Index i = seen.fluid_count; i < seen.count; ++i) {
    const double z = seen.position[i].x[2];
    if (z < 0.02) continue;  // beyond reach of the fluid
    ++checked;
    EXPECT_NEAR(seen.record[i].pressure / (1000 * 9.81 * (0.2 - z)), 1, 1e-5);
  }
  EXPECT_GT(checked, 10);
}

}  // namespace
}  // namespace thalweg
