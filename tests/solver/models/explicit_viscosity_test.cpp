#include "solver/models/implicit/explicit_viscosity.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "viscosity_scenes.hpp"

namespace thalweg {
namespace {

template <class On>
class ExplicitViscosity : public testing::Test {};
TYPED_TEST_SUITE(ExplicitViscosity, test::Backends, test::BackendNames);

/// Largest force on a particle within the kernel's reach of a wall, in a flow that grows linearly from the wall's
/// surface, over shear stress times spacing [-].
template <class On>
double force_in_linear_flow(bool sticks) {
  test::LatticeSetup<2> setup;
  setup.length = 0.12;
  Scene<2> scene = test::make_scene_of(setup);
  scene.has_sediment = true;
  if (!sticks) scene.no_slip = {};
  const double surface = 0.02;
  const double rate = 10;  // [1/s]
  ParticleSet p = test::fill_lattice(
      scene, [&](const Vec3& x) { return x.z() < surface ? ParticleType::wall : ParticleType::sediment; });
  p.viscosity.assign(p.size(), 1.0F);  // [Pa s]
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.type[i] == ParticleType::sediment)
      p.velocity[i].x() = static_cast<float>(rate * (p.position[i].z() - surface));
  }
  auto l = test::load<On>(scene, p);
  apply_equation_of_state(l.on, l.p, scene);
  const test::Seen before = test::look(l);
  const double dt = 1e-4;
  test::TestStep step(l, dt);
  apply_explicit_viscosity(l.on, l.p, scene, step.state(), ViscousCoupling<2>{scene});
  const test::Seen after = test::look(l);
  double largest = 0;
  for (Index i = 0; i < after.fluid_count; ++i) {
    if (after.position[i].x[2] - surface > 2 * scene.smoothing_length) continue;
    const double gained = double(after.record[i].velocity[0]) - double(before.record[i].velocity[0]);
    largest = std::max(largest, std::abs(double(after.mass[i]) * gained / dt));
  }
  return largest / (rate * scene.spacing);
}

TYPED_TEST(ExplicitViscosity, LeavesFlowThatGrowsLinearlyFromAWallsSurfaceSteady) {
  // At rest in their own places the wall's particles hold the lowest row back by less than half of the shear stress
  // that the fluid above it pulls it along with.
  EXPECT_GT(force_in_linear_flow<TypeParam>(false), 0.4);
  // The distance is told from rows that count by their integrals, those of the lattice are sums: 6 %.
  EXPECT_LT(force_in_linear_flow<TypeParam>(true), 0.07);
}

/// Gives all fluid one viscosity [Pa s].
template <class On>
void set_viscosity(test::Loaded<2, On>& l, float viscosity) {
  test::change(l, [&](test::Seen& seen) {
    for (Index i = 0; i < seen.fluid_count; ++i) seen.record[i].viscosity = viscosity;
  });
}

/// Velocities by particle, after so many steps of the viscous part alone.
template <class On>
std::vector<float> velocities_after(test::Loaded<2, On>& l, double dt, int steps) {
  test::TestStep s(l, dt);
  for (int n = 0; n < steps; ++n) {
    s.begin(dt);
    EXPECT_TRUE(test::apply_viscosity(s).converged);
  }
  const test::Seen seen = test::look(l);
  std::vector<float> u;
  for (Index i = 0; i < seen.fluid_count; ++i) {
    for (const float c : seen.record[i].velocity) u.push_back(c);
  }
  return u;
}

double rms_difference(const std::vector<float>& a, const std::vector<float>& b) {
  double squares = 0;
  for (std::size_t i = 0; i < a.size(); ++i) squares += std::pow(double(a[i]) - double(b[i]), 2);
  return std::sqrt(squares / static_cast<double>(a.size()));
}

TYPED_TEST(ExplicitViscosity, BecomesTheImplicitOneWithShortSteps) {
  // Both are of first order in the step, with opposite errors: their difference halves with it. 1 Pa s for 1 ms: a
  // diffusion length of 2 spacings, so that viscosity decides about the velocities.
  std::vector<double> difference;
  for (const int steps : {20, 40, 80}) {
    std::vector<float> u[2];
    for (const auto treatment : {ViscosityTreatment::implicit, ViscosityTreatment::explicit_steps}) {
      auto l = test::stirred_block<TypeParam>();
      l.scene.viscosity = treatment;
      set_viscosity(l, 100);
      u[treatment == ViscosityTreatment::explicit_steps] = velocities_after(l, 1e-3 / steps, steps);
    }
    difference.push_back(rms_difference(u[0], u[1]));
  }
  EXPECT_LT(difference[0], 2e-3);  // of velocities of 0.1 m/s
  EXPECT_NEAR(difference[0] / difference[1], 2, 0.5);
  EXPECT_NEAR(difference[1] / difference[2], 2, 0.5);
}

TYPED_TEST(ExplicitViscosity, KeepsMomentumWithoutWalls) {
  auto l = test::stirred_block<TypeParam>();
  l.scene.viscosity = ViscosityTreatment::explicit_steps;
  test::remove_walls(l);
  const Totals before = sum_totals(l.on, l.p, l.scene);
  velocities_after(l, 1e-7, 10);
  test::expect_momentum_kept(before, sum_totals(l.on, l.p, l.scene));
}

TYPED_TEST(ExplicitViscosity, ShortensTheStep) {
  auto l = test::stirred_block<TypeParam>();
  set_viscosity(l, 1300);
  test::TestStep s(l, 0);
  const auto step_with = [&](ViscosityTreatment treatment) {
    l.scene.viscosity = treatment;
    s.begin(0);
    find_extremes(l.on, l.p, s.state());
    ViscosityModel::find_limits(s.step);
    stable_time_step(s.step);
    return s.read().step;
  };
  const TimeStep bounded = step_with(ViscosityTreatment::explicit_steps);
  EXPECT_EQ(bounded.limiter, Limiter::viscosity);
  EXPECT_NEAR(bounded.dt, 0.125 * 0.015 * 0.015 / 1, 1e-10);  // nu = 1 m^2/s
  EXPECT_EQ(step_with(ViscosityTreatment::capped).limiter, Limiter::sound);
}

TYPED_TEST(ExplicitViscosity, CappedIsWhatTheStepCanTakeAndIsCounted) {
  auto l = test::stirred_block<TypeParam>();
  l.scene.viscosity = ViscosityTreatment::capped;
  Index sediment = 0;
  test::change(l, [&](test::Seen& seen) {
    for (Index i = 0; i < seen.fluid_count; ++i) {
      if (!is_sediment(seen.record[i])) continue;
      seen.record[i].viscosity = sediment % 3 == 0 ? 1e5F : 0.5F;
      ++sediment;
    }
  });
  const ViscousResult result = test::apply_viscosity(l, 1e-4);
  EXPECT_EQ(result.capped, (sediment + 2) / 3);
  const test::Seen seen = test::look(l);
  for (Index i = 0; i < seen.fluid_count; ++i) {
    if (is_sediment(seen.record[i])) {
      EXPECT_LE(seen.record[i].viscosity, 1300 * 0.125 * 0.015 * 0.015 / 1e-4 + 0.1);
    }
  }
  EXPECT_NEAR(viscosity_cap(1540.0, 4.16e-3, 3.3e-5), 101, 0.5);  // the paper's grains as a bed
  EXPECT_NEAR(viscous_time_step(7.5e-3, 1.0), 7.03e-6, 5e-9);
}

}  // namespace
}  // namespace thalweg
