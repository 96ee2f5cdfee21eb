#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <vector>

#include "scenes.hpp"
#include "solver/models/implicit/viscous_step.hpp"

namespace thalweg {
namespace {

using test::LatticeSetup;

/// A block of sediment and water between two walls, stirred, with viscosities from 0.01 to 1e4 Pa s.
template <class Device = test::Device>
test::Loaded<2, Device> stirred_block() {
  LatticeSetup<2> setup;
  setup.length = 0.12;
  setup.gravity = {0, -9.81F};
  Scene<2> scene = test::make_scene_of(setup);
  scene.has_sediment = true;
  scene.viscous_tolerance = 1e-6;
  ParticleSet p = test::fill_lattice(
      scene,
      [](const Vec3& x) {
        if (x.z() < 0.02) return ParticleType::wall;
        return x.z() < 0.08 ? ParticleType::sediment : ParticleType::water;
      },
      0.2);
  std::mt19937 random(5);
  std::uniform_real_distribution<float> number(-1, 1);
  p.viscosity.resize(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.type[i] != ParticleType::wall) p.velocity[i] = 0.1F * Eigen::Vector3f(number(random), 0, number(random));
    p.viscosity[i] = std::pow(10.0F, 3 * number(random) + 1);
  }
  auto l = test::load<Device>(scene, p);
  apply_equation_of_state(l.on, l.p, scene);
  return l;
}

/// The matrix of the same system, written down pair by pair in double [kg].
template <class Device>
Eigen::MatrixXd system_matrix(const test::Loaded<2, Device>& l, double dt) {
  const Index n = l.p.fluid_count;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  const WendlandC2<2, double> kernel(l.scene.smoothing_length);
  for (Index i = 0; i < n; ++i) {
    const Record& a = l.p.record[i];
    A(i, i) += l.p.mass[i];
    WallDrag<2, float> walls{};
    for (Index j = 0; j < l.p.count; ++j) {
      if (i == j) continue;
      const Record& o = l.p.record[j];
      const double dx = l.p.position[i].x[0] - l.p.position[j].x[0];
      const double dz = l.p.position[i].x[2] - l.p.position[j].x[2];
      const double r2 = dx * dx + dz * dz;
      const double F = kernel.gradient(kernel.closeness(std::sqrt(r2)));
      const double speed =
          std::hypot(double(a.velocity[0]) - double(o.velocity[0]), double(a.velocity[2]) - double(o.velocity[2]));
      const double interface = 2 * (1e-3 + 0.4 * 1000 * 0.205 * 0.205 * speed * l.scene.spacing);
      double eta = 0;
      if (is_sediment(a) && is_sediment(o)) eta = double(a.viscosity) + double(o.viscosity);
      if (is_sediment(a) && is_wall(o)) eta = 2 * double(a.viscosity);
      if (a.phase + is_sediment(o) + kind::water) eta = interface;
      const double k = dt * -double(a.volume) * double(o.volume) * eta * F;
      A(i, i) += k;
      if (j < n) A(i, j) -= k;
      if (is_wall(o)) {
        walls.coefficients += static_cast<float>(k);
        walls.lever[0] += static_cast<float>(k * dx);
        walls.lever[1] += static_cast<float>(k * dz);
      }
    }
    A(i, i) += double(l.scene.no_slip.excess(walls)) * double(walls.coefficients);
  }
  return A;
}

/// The fluid's velocities, a column a component [m/s].
template <class Device>
Eigen::MatrixXd velocities(const test::Loaded<2, Device>& l) {
  Eigen::MatrixXd u(l.p.fluid_count, 2);
  for (Index i = 0; i < l.p.fluid_count; ++i) u.row(i) << l.p.record[i].velocity[0], l.p.record[i].velocity[2];
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

/// The viscous part of a step of state.step.dt by itself, with all it tries.
template <class Device>
ViscousResult apply_viscosity(test::Loaded<2, Device>& l, ViscousSystem<Device>& system, StepState& state) {
  const Mixture<Device> none;
  ViscousResult result;
  begin_viscosity(l.on, l.p, l.scene, none, system, &state);
  while (true) {
    iterate_viscosity(l.on, l.p, l.scene, system, &state, l.scene.viscous_iterations);
    end_viscosity(l.on, l.p, l.scene, system, &state);
    result.iterations += state.viscous.iterations;
    if (!viscosity::may_retry(state.viscous, result.retries)) break;
    viscosity::prepare_retry(l.on, l.p, &state, result.retries > 0);
    begin_viscosity(l.on, l.p, l.scene, none, system, &state);
    ++result.retries;
  }
  result.residual = state.viscous.residual;
  result.converged = state.viscous.converged != 0;
  result.capped = state.capped;
  EXPECT_EQ(state.moves, state.viscous.converged);
  return result;
}
template <class Device>
ViscousResult apply_viscosity(test::Loaded<2, Device>& l, ViscousSystem<Device>& system, double dt) {
  StepState state = test::step_of(dt);
  return apply_viscosity(l, system, state);
}

template <class Device>
Solutions solutions_of_stirred_block(double dt) {
  auto l = stirred_block<Device>();
  Solutions s{system_matrix(l, dt), velocities(l), {}, {}, {}};
  Eigen::VectorXd mass(l.p.fluid_count);
  for (Index i = 0; i < l.p.fluid_count; ++i) mass(i) = l.p.mass[i];
  s.direct = s.matrix.ldlt().solve(mass.asDiagonal() * s.start);
  ViscousSystem<Device> system;
  s.result = apply_viscosity(l, system, dt);
  s.iterated = velocities(l);
  return s;
}

TEST(ImplicitViscosity, SolvesTheSystemItStates) {
  const Solutions s = solutions_of_stirred_block<OpenMp<4, double>>(1e-4);
  EXPECT_TRUE(s.result.converged);
  EXPECT_GT(s.result.iterations, 3);
  // Tolerance 1e-6 of g dt = 1e-9 m/s per particle, times the condition of the system (about 1e3): below 1e-5 m/s.
  EXPECT_LT((s.iterated - s.direct).norm() / std::sqrt(s.direct.rows()), 1e-5);
}

TEST(ImplicitViscosity, CoefficientsInHalfAFloatAddNoMoreThanTheirRounding) {
  // What is solved for is the change x - u*. With every coefficient off by a share of 2^-9 at most, A' - A is within
  // that share of A, and so the change within 2^-9 of itself in the norm that A gives (to first order).
  const Solutions s = solutions_of_stirred_block<OpenMp<4>>(1e-4);
  const auto norm = [&](const Eigen::MatrixXd& u) { return std::sqrt((u.transpose() * s.matrix * u).trace()); };
  EXPECT_TRUE(s.result.converged);
  EXPECT_LT(norm(s.iterated - s.direct), norm(s.direct - s.start) / 511);
}

/// Largest force on a particle within the kernel's reach of a wall, in a flow that grows linearly from the wall's
/// surface, over shear stress times spacing [-].
double force_in_linear_flow(bool sticks) {
  LatticeSetup<2> setup;
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
  auto l = test::load(scene, p);
  apply_equation_of_state(l.on, l.p, scene);
  const Eigen::MatrixXd before = velocities(l);
  const double dt = 1e-4;
  const StepState state = test::step_of(dt);
  apply_explicit_viscosity(l.on, l.p, scene, &state);
  const Eigen::MatrixXd gained = velocities(l) - before;
  double largest = 0;
  for (Index i = 0; i < l.p.fluid_count; ++i) {
    if (l.p.position[i].x[2] - surface > 2 * scene.smoothing_length) continue;
    largest = std::max(largest, std::abs(double(l.p.mass[i]) * gained(i, 0) / dt));
  }
  return largest / (rate * scene.spacing);
}

TEST(NoSlip, FlowThatGrowsLinearlyFromAWallsSurfaceIsSteady) {
  // At rest in their own places the wall's particles hold the lowest row back by less than half of the shear stress
  // that the fluid above it pulls it along with.
  EXPECT_GT(force_in_linear_flow(false), 0.4);
  // The distance is told from rows that count by their integrals, those of the lattice are sums: 6 %.
  EXPECT_LT(force_in_linear_flow(true), 0.07);
}

TEST(ImplicitViscosity, GivesTheWallsAllTheMomentumItTakes) {
  // Without walls in reach momentum stays; energy falls.
  auto l = stirred_block();
  for (Index i = l.p.fluid_count; i < l.p.count; ++i) l.p.record[i].volume = 0;
  const Totals before = sum_totals(l.on, l.p, l.scene);
  ViscousSystem<test::Device> system;
  apply_viscosity(l, system, 1e-4);
  const Totals after = sum_totals(l.on, l.p, l.scene);
  const double scale = std::sqrt(2 * before.kinetic_energy * (before.water_mass + before.sediment_mass));
  EXPECT_LT(std::abs(after.momentum[0] - before.momentum[0]), 1e-6 * scale);
  EXPECT_LT(std::abs(after.momentum[2] - before.momentum[2]), 1e-6 * scale);
  EXPECT_LT(after.kinetic_energy, before.kinetic_energy);
}

TEST(ImplicitViscosity, LeavesPureWaterAlone) {
  LatticeSetup<2> setup;
  const Scene<2> scene = test::make_scene_of(setup);
  auto l = test::load(scene, test::fill_lattice(scene, test::all_water));
  ViscousSystem<test::Device> system;
  const ViscousResult result = apply_viscosity(l, system, 1e-4);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_TRUE(system.row.empty());  // nothing was even allocated
}

/// Velocities by particle, after so many steps of the viscous part alone.
std::vector<float> velocities_after(test::Loaded<2>& l, double dt, int steps) {
  ViscousSystem<test::Device> system;
  for (int n = 0; n < steps; ++n) {
    EXPECT_TRUE(apply_viscosity(l, system, dt).converged);
  }
  std::vector<float> u;
  for (Index i = 0; i < l.p.fluid_count; ++i) {
    for (const float c : l.p.record[i].velocity) u.push_back(c);
  }
  return u;
}

double rms_difference(const std::vector<float>& a, const std::vector<float>& b) {
  double squares = 0;
  for (std::size_t i = 0; i < a.size(); ++i) squares += std::pow(double(a[i]) - double(b[i]), 2);
  return std::sqrt(squares / static_cast<double>(a.size()));
}

TEST(ExplicitViscosity, BecomesTheImplicitOneWithShortSteps) {
  // Both are of first order in the step, with opposite errors: their difference halves with it. 1 Pa s for 1 ms: a
  // diffusion length of 2 spacings, so that viscosity decides about the velocities.
  std::vector<double> difference;
  for (const int steps : {20, 40, 80}) {
    std::vector<float> u[2];
    for (const auto treatment : {ViscosityTreatment::implicit, ViscosityTreatment::explicit_steps}) {
      auto l = stirred_block();
      l.scene.viscosity = treatment;
      for (Index i = 0; i < l.p.fluid_count; ++i) l.p.record[i].viscosity = 100;
      u[treatment == ViscosityTreatment::explicit_steps] = velocities_after(l, 1e-3 / steps, steps);
    }
    difference.push_back(rms_difference(u[0], u[1]));
  }
  EXPECT_LT(difference[0], 2e-3);  // of velocities of 0.1 m/s
  EXPECT_NEAR(difference[0] / difference[1], 2, 0.5);
  EXPECT_NEAR(difference[1] / difference[2], 2, 0.5);
}

TEST(ExplicitViscosity, KeepsMomentumWithoutWalls) {
  auto l = stirred_block();
  l.scene.viscosity = ViscosityTreatment::explicit_steps;
  for (Index i = l.p.fluid_count; i < l.p.count; ++i) l.p.record[i].volume = 0;
  const Totals before = sum_totals(l.on, l.p, l.scene);
  velocities_after(l, 1e-7, 10);
  const Totals after = sum_totals(l.on, l.p, l.scene);
  const double scale = std::sqrt(2 * before.kinetic_energy * (before.water_mass + before.sediment_mass));
  EXPECT_LT(std::abs(after.momentum[0] - before.momentum[0]), 1e-6 * scale);
  EXPECT_LT(std::abs(after.momentum[2] - before.momentum[2]), 1e-6 * scale);
  EXPECT_LT(after.kinetic_energy, before.kinetic_energy);
}

TEST(ExplicitViscosity, ShortensTheStep) {
  auto l = stirred_block();
  for (Index i = 0; i < l.p.fluid_count; ++i) l.p.record[i].viscosity = 1300;
  l.scene.viscosity = ViscosityTreatment::explicit_steps;
  StepState state;
  stable_time_step(l.on, l.p, l.scene, &state);
  EXPECT_EQ(state.step.limiter, Limiter::viscosity);
  EXPECT_NEAR(state.step.dt, 0.125 * 0.015 * 0.015 / 1, 1e-10);  // nu = 1 m^2/s
  l.scene.viscosity = ViscosityTreatment::capped;
  stable_time_step(l.on, l.p, l.scene, &state);
  EXPECT_EQ(state.step.limiter, Limiter::sound);
}

TEST(CappedViscosity, IsWhatTheStepCanTakeAndIsCounted) {
  auto l = stirred_block();
  l.scene.viscosity = ViscosityTreatment::capped;
  Index sediment = 0;
  for (Index i = 0; i < l.p.fluid_count; ++i) {
    if (!is_sediment(l.p.record[i])) continue;
    l.p.record[i].viscosity = sediment % 3 == 0 ? 1e5F : 0.5F;
    ++sediment;
  }
  ViscousSystem<test::Device> system;
  const ViscousResult result = apply_viscosity(l, system, 1e-4);
  EXPECT_EQ(result.capped, (sediment + 2) / 3);
  for (Index i = 0; i < l.p.fluid_count; ++i) {
    if (is_sediment(l.p.record[i])) {
      EXPECT_LE(l.p.record[i].viscosity, 1300 * 0.125 * 0.015 * 0.015 / 1e-4 + 0.1);
    }
  }
  EXPECT_NEAR(viscosity_cap(1540.0, 4.16e-3, 3.3e-5), 101, 0.5);  // the paper's grains as a bed
  EXPECT_NEAR(viscous_time_step(7.5e-3, 1.0), 7.03e-6, 5e-9);
}

TEST(ImplicitViscosity, TriesAgainWithLessBeforeItGivesUp) {
  const double dt = 1e-3;
  StepState state;
  TimeStep& step = state.step;
  const auto solve = [&](int iterations) {
    auto l = stirred_block();
    l.scene.viscous_iterations = iterations;
    l.scene.viscous_tolerance = 1e-3;
    state = test::step_of(dt);
    ViscousSystem<test::Device> system;
    const std::vector<Record> before(l.p.record.begin(), l.p.record.end());
    const ViscousResult result = apply_viscosity(l, system, state);
    for (Index i = 0; i < l.p.fluid_count && !result.converged; ++i) {
      EXPECT_NEAR(l.p.record[i].velocity[0], before[i].velocity[0], 1e-6);  // nothing was left half done
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

TEST(ImplicitViscosity, ForgetsAGuessThatLeadsAstray) {
  // At rest the solution is rest: nothing to do without a guess, too much for two iterations with a bad one.
  auto l = stirred_block();
  l.scene.viscous_iterations = 2;
  for (Index i = 0; i < l.p.fluid_count; ++i) {
    for (float& u : l.p.record[i].velocity) u = 0;
    l.p.sediment[i].viscous_acceleration[0] = i % 2 == 0 ? 5.0F : -5.0F;
  }
  ViscousSystem<test::Device> system;
  StepState state = test::step_of(1e-3);
  const ViscousResult result = apply_viscosity(l, system, state);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.retries, 1);
  EXPECT_EQ(state.step.dt, 1e-3);
  for (Index i = 0; i < l.p.fluid_count; ++i) EXPECT_NEAR(l.p.record[i].velocity[0], 0, 1e-6);
}

}  // namespace
}  // namespace thalweg
