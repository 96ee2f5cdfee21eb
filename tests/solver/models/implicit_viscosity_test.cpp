#include "solver/models/implicit/model.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "viscosity_scenes.hpp"

namespace thalweg {
namespace {

template <class On>
class ImplicitViscosity : public testing::Test {};
TYPED_TEST_SUITE(ImplicitViscosity, test::Backends, test::BackendNames);

/// The matrix of the same system, written down pair by pair in double [kg].
Eigen::MatrixXd system_matrix(const test::Seen& seen, const Scene<2>& scene, double dt) {
  const Index n = seen.fluid_count;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  const WendlandC2<2, double> kernel(scene.smoothing_length);
  for (Index i = 0; i < n; ++i) {
    const Record& a = seen.record[i];
    A(i, i) += seen.mass[i];
    WallDrag<2, float> walls{};
    for (Index j = 0; j < seen.count; ++j) {
      if (i == j) continue;
      const Record& o = seen.record[j];
      const double dx = seen.position[i].x[0] - seen.position[j].x[0];
      const double dz = seen.position[i].x[2] - seen.position[j].x[2];
      const double r2 = dx * dx + dz * dz;
      const double F = kernel.gradient(kernel.closeness(std::sqrt(r2)));
      const double speed =
          std::hypot(double(a.velocity[0]) - double(o.velocity[0]), double(a.velocity[2]) - double(o.velocity[2]));
      const double interface = 2 * (1e-3 + 0.4 * 1000 * 0.205 * 0.205 * speed * scene.spacing);
      double eta = 0;
      if (is_sediment(a) && is_sediment(o)) eta = double(a.viscosity) + double(o.viscosity);
      if (is_sediment(a) && is_wall(o)) eta = 2 * double(a.viscosity);
      if ((is_sediment(a) && is_water(o)) || (is_water(a) && is_sediment(o))) eta = interface;
      const double k = dt * -double(a.volume) * double(o.volume) * eta * F;
      A(i, i) += k;
      if (j < n) A(i, j) -= k;
      if (is_wall(o)) {
        walls.coefficients += static_cast<float>(k);
        walls.lever[0] += static_cast<float>(k * dx);
        walls.lever[1] += static_cast<float>(k * dz);
      }
    }
    A(i, i) += double(scene.no_slip.excess(walls)) * double(walls.coefficients);
  }
  return A;
}

/// The fluid's velocities, a column a component [m/s].
Eigen::MatrixXd velocities(const test::Seen& seen) {
  Eigen::MatrixXd u(seen.fluid_count, 2);
  for (Index i = 0; i < seen.fluid_count; ++i) u.row(i) << seen.record[i].velocity[0], seen.record[i].velocity[2];
  return u;
}

/// The system written down and solved directly, beside what the iteration makes of the same scene.
struct Solutions {
  Eigen::MatrixXd matrix;
  Eigen::MatrixXd start;  // velocities u* [m/s]
  Eigen::MatrixXd direct;
  Eigen::MatrixXd iterated;
  ViscousResult result;
};

template <class On>
Solutions solutions_of_stirred_block(double dt) {
  auto l = test::stirred_block<On>();
  const test::Seen start = test::look(l);
  Solutions s{system_matrix(start, l.scene, dt), velocities(start), {}, {}, {}};
  Eigen::VectorXd mass(start.fluid_count);
  for (Index i = 0; i < start.fluid_count; ++i) mass(i) = start.mass[i];
  s.direct = s.matrix.ldlt().solve(mass.asDiagonal() * s.start);
  s.result = test::apply_viscosity(l, dt);
  s.iterated = velocities(test::look(l));
  return s;
}

TEST(ImplicitViscosityInDouble, SolvesTheSystemItStates) {
  const Solutions s = solutions_of_stirred_block<OpenMp<4, double>>(1e-4);
  EXPECT_TRUE(s.result.converged);
  EXPECT_GT(s.result.iterations, 3);
  // Tolerance 1e-6 of g dt = 1e-9 m/s per particle, times the condition of the system (about 1e3): below 1e-5 m/s.
  EXPECT_LT((s.iterated - s.direct).norm() / std::sqrt(s.direct.rows()), 1e-5);
}

TYPED_TEST(ImplicitViscosity, CoefficientsInHalfAFloatAddNoMoreThanTheirRounding) {
  // The solve is for the change x - u*. With every coefficient off by a share of 2^-9 at most, A' - A is within that
  // share of A, and so the change within 2^-9 of itself in the norm that A gives (to first order).
  const Solutions s = solutions_of_stirred_block<TypeParam>(1e-4);
  const auto norm = [&](const Eigen::MatrixXd& u) { return std::sqrt((u.transpose() * s.matrix * u).trace()); };
  EXPECT_TRUE(s.result.converged);
  EXPECT_LT(norm(s.iterated - s.direct), norm(s.direct - s.start) / 511);
}

TYPED_TEST(ImplicitViscosity, GivesTheWallsAllTheMomentumItTakes) {
  auto l = test::stirred_block<TypeParam>();
  test::remove_walls(l);
  const Totals before = sum_totals(l.on, l.p, l.scene);
  test::apply_viscosity(l, 1e-4);
  test::expect_momentum_kept(before, sum_totals(l.on, l.p, l.scene));
}

TYPED_TEST(ImplicitViscosity, LeavesPureWaterAlone) {
  test::LatticeSetup<2> setup;
  const Scene<2> scene = test::make_scene_of(setup);
  auto l = test::load<TypeParam>(scene, test::fill_lattice(scene, test::all_water));
  test::TestStep s(l, 1e-4);
  const ViscousResult result = test::apply_viscosity(s);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_TRUE(s.work.viscous.row.empty());  // nothing was even allocated
}

TYPED_TEST(ImplicitViscosity, TriesAgainWithLessBeforeItGivesUp) {
  const double dt = 1e-3;
  TimeStep step;
  const auto solve = [&](int iterations) {
    auto l = test::stirred_block<TypeParam>();
    l.scene.viscous_iterations = iterations;
    l.scene.viscous_tolerance = 1e-3;
    const test::Seen before = test::look(l);
    test::TestStep s(l, dt);
    const ViscousResult result = test::apply_viscosity(s);
    step = s.step.now.step;
    const test::Seen after = test::look(l);
    for (Index i = 0; i < after.fluid_count && !result.converged; ++i) {
      EXPECT_NEAR(after.record[i].velocity[0], before.record[i].velocity[0], 1e-6);  // nothing was left half done
    }
    return result;
  };
  const ViscousResult usual = solve(1000);
  ASSERT_TRUE(usual.converged);
  EXPECT_EQ(usual.retries, 0);
  EXPECT_EQ(step.dt, dt);

  // Too few iterations for the step, enough for a shorter one.
  const ViscousResult shorter = solve(usual.iterations * 3 / 4);
  EXPECT_TRUE(shorter.converged);
  EXPECT_GT(shorter.retries, 1);
  EXPECT_LT(step.dt, dt);
  EXPECT_EQ(step.limiter, Limiter::viscosity);

  // Far too few: says so.
  const ViscousResult hopeless = solve(1);
  EXPECT_FALSE(hopeless.converged);
  EXPECT_EQ(hopeless.retries, 1 + viscosity::most_halvings);
  EXPECT_EQ(step.dt, dt / 16);
}

TYPED_TEST(ImplicitViscosity, ForgetsAGuessThatLeadsAstray) {
  // At rest the solution is rest: nothing to do without a guess, too much for two iterations with a bad one.
  auto l = test::stirred_block<TypeParam>();
  l.scene.viscous_iterations = 2;
  test::change(l, [](test::Seen& seen) {
    for (Index i = 0; i < seen.fluid_count; ++i) {
      for (float& u : seen.record[i].velocity) u = 0;
      seen.sediment[i].viscous_acceleration[0] = i % 2 == 0 ? 5.0F : -5.0F;
    }
  });
  test::TestStep s(l, 1e-3);
  const ViscousResult result = test::apply_viscosity(s);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.retries, 1);
  EXPECT_EQ(s.step.now.step.dt, 1e-3);
  const test::Seen end = test::look(l);
  for (Index i = 0; i < end.fluid_count; ++i) EXPECT_NEAR(end.record[i].velocity[0], 0, 1e-6);
}

}  // namespace
}  // namespace thalweg
