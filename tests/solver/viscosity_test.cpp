#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <vector>

#include "scenes.hpp"

namespace thalweg {
namespace {

using test::LatticeSetup;

/// A block of sediment and water between two walls, stirred, with viscosities from 0.01 to 1e4 Pa s.
test::Loaded<2> stirred_block() {
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
  auto l = test::load(scene, p);
  apply_equation_of_state(l.on, l.p, scene);
  return l;
}

/// The same system, written down pair by pair in double and solved directly.
Eigen::VectorXd direct_solution(const test::Loaded<2>& l, double dt, int component) {
  const Index n = l.p.fluid_count;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd b(n);
  const WendlandC2<2, double> kernel(l.scene.smoothing_length);
  for (Index i = 0; i < n; ++i) {
    const Record& a = l.p.record[i];
    A(i, i) += l.p.mass[i];
    b(i) = double(l.p.mass[i]) * double(a.velocity[component]);
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
      if (a.phase == phase_sediment && o.phase == phase_sediment) eta = double(a.viscosity) + double(o.viscosity);
      if (a.phase == phase_sediment && o.phase == phase_wall) eta = 2 * double(a.viscosity);
      if (a.phase + o.phase == phase_sediment + phase_water) eta = interface;
      const double k = dt * -double(a.volume) * double(o.volume) * eta * F;
      A(i, i) += k;
      if (j < n) A(i, j) -= k;
    }
  }
  return A.ldlt().solve(b);
}

TEST(ImplicitViscosity, SolvesTheSystemItStates) {
  auto l = stirred_block();
  const double dt = 1e-4;
  const Eigen::VectorXd x = direct_solution(l, dt, 0);
  const Eigen::VectorXd z = direct_solution(l, dt, 2);
  ViscousSystem<test::Device> system;
  const ViscousResult result = solve_viscosity(l.on, l.p, l.scene, system, static_cast<float>(dt));
  EXPECT_TRUE(result.converged);
  EXPECT_GT(result.iterations, 3);
  double error2 = 0;
  for (Index i = 0; i < l.p.fluid_count; ++i) {
    const Record& r = l.p.record[i];
    error2 += std::pow(double(r.velocity[0]) - x(i), 2) + std::pow(double(r.velocity[2]) - z(i), 2);
  }
  // Tolerance 1e-6 of g dt = 1e-9 m/s per particle, times the condition of the system (about 1e3): below 1e-5 m/s.
  EXPECT_LT(std::sqrt(error2 / l.p.fluid_count), 1e-5);
}

TEST(ImplicitViscosity, GivesTheWallsAllTheMomentumItTakes) {
  // Without walls in reach momentum stays; energy falls.
  auto l = stirred_block();
  for (Index i = l.p.fluid_count; i < l.p.count; ++i) l.p.record[i].volume = 0;
  const Totals before = sum_totals(l.on, l.p, l.scene);
  ViscousSystem<test::Device> system;
  solve_viscosity(l.on, l.p, l.scene, system, 1e-4F);
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
  const ViscousResult result = solve_viscosity(l.on, l.p, scene, system, 1e-4F);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_TRUE(system.row.empty());  // nothing was even allocated
}

}  // namespace
}  // namespace thalweg
