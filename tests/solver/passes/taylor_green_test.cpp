#include <gtest/gtest.h>

#include <cmath>

#include "tests/solver/scenes.hpp"

namespace thalweg {
namespace {

// Decay of a Taylor-Green vortex, u = U sin kx cos kz, w = -U cos kx sin kz, k = 2 pi/L, in a periodic square: kinetic
// energy falls as exp(-4 nu k^2 t). nu gives Re = U L/nu = 10, so that a fifth to a quarter is lost by physics.
constexpr double L = 1;     // [m]
constexpr double U = 1;     // [m/s]
constexpr double nu = 0.1;  // [m^2/s]

struct Vortex {
  test::Loaded<2> l;

  /// Kinetic energy lost after t = 0.1 L/U, as a share of that at the start.
  double lost_energy() {
    const double before = sum_totals(l.on, l.p, l.scene).kinetic_energy;
    Workspace<test::Cpu> work;
    Timing timing;
    const double end = 0.1 * L / U;
    double t = 0;
    while (t < end * (1 - 1e-9)) t += advance(l.on, l.p, l.scene, work, end - t, timing).step.dt;
    return 1 - sum_totals(l.on, l.p, l.scene).kinetic_energy / before;
  }
};

/// n particles along a side.
Vortex make_vortex(int n) {
  test::LatticeSetup<2> setup;
  setup.length = L;
  setup.spacing = L / n;
  setup.periodic = true;
  setup.smoothing_ratio = 2;  // the lattice error of the viscous sum does not fall with the spacing alone
  setup.sound_speed = 20 * U;
  Scene<2> scene = test::make_scene_of(setup);
  scene.water_viscosity = static_cast<float>(1000 * nu);
  scene.artificial_viscosity = 0;
  ParticleSet p = test::fill_lattice(scene, test::all_water);
  const double k = 2 * M_PI / L;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double x = p.position[i].x();
    const double z = p.position[i].z();
    p.velocity[i] =
        Eigen::Vector3f(float(U * std::sin(k * x) * std::cos(k * z)), 0, float(-U * std::cos(k * x) * std::sin(k * z)));
    // The vortex's own pressure, so that no sound wave starts with it.
    const double pressure = 0.25 * 1000 * U * U * (std::cos(2 * k * x) + std::cos(2 * k * z));
    p.density[i] = static_cast<float>(1000 * (1 + pressure / (1000 * setup.sound_speed * setup.sound_speed)));
  }
  return {test::load<test::Cpu>(scene, p)};
}

/// Relative error of the lost energy.
double energy_error(int n) {
  const double k = 2 * M_PI / L;
  const double exact = 1 - std::exp(-4 * nu * k * k * 0.1 * L / U);
  return std::abs(make_vortex(n).lost_energy() / exact - 1);
}

TEST(TaylorGreen, ConvergesToTheExactDecay) {
  const double coarse = energy_error(16);
  const double middle = energy_error(32);
  const double fine = energy_error(64);
  const double order = std::log2(coarse / middle);
  std::cout << "errors of the lost energy " << coarse << " " << middle << " " << fine << ", order " << order << ", "
            << std::log2(middle / fine) << "\n";
  // Smoothing is second order in h, so at fixed h/dp errors fall by four with each halving, until the lattice sum's own
  // error (0.1 %) shows.
  EXPECT_GT(order, 1.8);
  EXPECT_GT(std::log2(middle / fine), 1.6);
  EXPECT_LT(fine, 0.004);
}

}  // namespace
}  // namespace thalweg
