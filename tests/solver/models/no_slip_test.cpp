#include "solver/models/no_slip/model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/solver/scenes.hpp"

// Fluid that sticks to walls, held against flows with a closed form.
namespace thalweg {
namespace {

template <class On>
class NoSlipWalls : public testing::Test {};
TYPED_TEST_SUITE(NoSlipWalls, test::Backends, test::BackendNames);

struct StrainRates {
  double least = 1e9;
  double largest = 0;
  double compression = 0;  // largest, of either sign
};

/// Rates of strain within the kernel's reach of a wall, over the true one, of a flow that grows linearly from the
/// surface of a wall that slides with `slide` [m/s] and rises with `rise` [m/s].
template <class On, int Dim>
StrainRates strain_beside_wall(double smoothing_ratio, double slide, double rise) {
  test::LatticeSetup<Dim> setup;
  setup.smoothing_ratio = smoothing_ratio;
  setup.length = Dim == 2 ? 0.16 : 0.11;
  Scene<Dim> scene = test::make_scene_of(setup);
  const bool periodic[3] = {true, Dim == 3, false};
  bool of_scene[Dim];
  for (int k = 0; k < Dim; ++k) of_scene[k] = k < Dim - 1 && periodic[k];
  scene.lattice = Lattice<Dim>(scene.domain_from, scene.domain_to, of_scene, scene.list_reach);
  scene.has_sediment = true;
  const double surface = 0.04;
  const double rate = 10;  // [1/s]
  ParticleSet p = test::fill_lattice(
      scene, [&](const Vec3& x) { return x.z() < surface ? ParticleType::wall : ParticleType::sediment; });
  for (std::size_t i = 0; i < p.size(); ++i) {
    const bool wall = p.type[i] == ParticleType::wall;
    p.velocity[i].x() = static_cast<float>(slide + (wall ? 0 : rate * (p.position[i].z() - surface)));
    p.velocity[i].z() = static_cast<float>(rise);
  }
  auto l = test::load<On>(scene, p);
  test::change(l, [&](test::Seen& seen) {
    for (Index i = seen.fluid_count; i < seen.count; ++i) {
      seen.record[i].velocity[0] = static_cast<float>(slide);
      seen.record[i].velocity[2] = static_cast<float>(rise);
    }
  });
  apply_equation_of_state(l.on, l.p, scene);
  compute_density_rates(l.on, l.p, scene);
  const test::Seen seen = test::look(l);
  StrainRates found;
  for (Index i = 0; i < seen.fluid_count; ++i) {
    if (seen.position[i].x[2] - surface > 2 * scene.smoothing_length) continue;
    const double strain = double(seen.sediment[i].strain_rate) / rate;
    found.least = std::min(found.least, strain);
    found.largest = std::max(found.largest, strain);
    found.compression = std::max(found.compression, std::abs(double(seen.rates[i].excess_rate)) / rate);
  }
  return found;
}

TYPED_TEST(NoSlipWalls, AreSeenByTheRateOfStrainAsIfTheFlowWentOnThroughTheirSurface) {
  // The true rate but for the table's rows, which count by their integrals: those of the lattice are sums (at h = 1.5
  // dp). Walls that count as they stand give 0.71 in the row beside them.
  for (const double slide : {0.0, 3.0}) {
    const StrainRates near = strain_beside_wall<TypeParam, 2>(1.5, slide, 0);
    EXPECT_NEAR(near.least, 1, 0.02) << slide;
    EXPECT_NEAR(near.largest, 1, 0.02) << slide;
    const StrainRates wide = strain_beside_wall<TypeParam, 2>(2, slide, 0);
    EXPECT_NEAR(wide.least, 1, 0.01) << slide;
    EXPECT_NEAR(wide.largest, 1, 0.01) << slide;
    EXPECT_LT(wide.compression, 1e-4) << "shear does not compress";
  }
  const StrainRates space = strain_beside_wall<TypeParam, 3>(1.5, 0, 0);
  EXPECT_NEAR(space.least, 1, 0.02);
  EXPECT_NEAR(space.largest, 1, 0.02);
}

TYPED_TEST(NoSlipWalls, CompressWithTheVelocityTheyHave) {
  // Wall and fluid rise together: neither strain nor compression comes of it.
  const StrainRates rising = strain_beside_wall<TypeParam, 2>(2, 0, 1);
  EXPECT_NEAR(rising.largest, 1, 0.01);
  EXPECT_LT(rising.compression, 1e-4);
}

/// Water between two plates, periodic along them: x along, z across.
struct Channel {
  double width = 0.1;      // H [m]
  double viscosity = 100;  // [Pa s]
  double force = 0;        // acceleration along the channel [m/s^2]
  double speed = 0;        // of the upper plate [m/s]
  double length = 0.1;     // [m]

  [[nodiscard]] double kinematic() const { return viscosity / 1000; }
  /// Steady velocity at the height z above the lower plate [m/s].
  [[nodiscard]] double exact(double z) const { return force * z * (width - z) / (2 * kinematic()) + speed * z / width; }
  [[nodiscard]] double largest() const { return std::max(exact(width / 2), exact(width)); }
};

/// Root mean square error of the steady velocity, over the largest, with n spacings across.
double steady_error(const Channel& of, int n, double smoothing_ratio) {
  const double dp = of.width / n;
  const int layers = 5;  // of wall: the lists' reach at h = 2 dp
  test::LatticeSetup<2> setup;
  setup.spacing = dp;
  setup.smoothing_ratio = smoothing_ratio;
  setup.length = of.width + 2 * layers * dp;
  setup.gravity = {static_cast<float>(of.force), 0};
  Scene<2> scene = test::make_scene_of(setup);
  scene.domain_to[0] = of.length;
  const bool periodic[2] = {true, false};
  scene.lattice = Lattice<2>(scene.domain_from, scene.domain_to, periodic, scene.list_reach);
  scene.water_viscosity = static_cast<float>(of.viscosity);
  scene.artificial_viscosity = 0;
  scene.water_sticks = scene.needs_near_walls = true;
  const double below = layers * dp;
  const ParticleSet p = test::fill_lattice(scene, [&](const Vec3& x) {
    return x.z() < below || x.z() > below + of.width ? ParticleType::wall : ParticleType::water;
  });
  auto l = test::load<test::Cpu>(scene, p);
  test::change(l, [&](test::Seen& seen) {
    for (Index i = seen.fluid_count; i < seen.count; ++i) {
      if (seen.position[i].x[2] > below + of.width) seen.record[i].velocity[0] = static_cast<float>(of.speed);
    }
  });
  Workspace<test::Cpu> work;
  Timing timing;
  const double end = of.width * of.width / of.kinematic();  // the slowest part decays as exp(-pi^2 t/end)
  for (double t = 0; t < end * (1 - 1e-9);) t += advance(l.on, l.p, l.scene, work, end - t, timing).step.dt;
  const test::Seen seen = test::look(l);
  double squares = 0;
  for (Index i = 0; i < seen.fluid_count; ++i) {
    const double wrong = double(seen.record[i].velocity[0]) - of.exact(seen.position[i].x[2] - below);
    squares += wrong * wrong;
  }
  return std::sqrt(squares / seen.fluid_count) / of.largest();
}

Channel poiseuille() {
  Channel channel;
  channel.force = 80;  // 1 m/s in the middle, Re = 1
  return channel;
}

TEST(NoSlipWater, FlowsBetweenPlatesAsPoiseuilleHasIt) {
  const double coarse = steady_error(poiseuille(), 10, 2);
  const double fine = steady_error(poiseuille(), 20, 2);
  std::cout << "errors " << coarse << " " << fine << ", order " << std::log2(coarse / fine) << "\n";
  // Second order inside; at the walls the velocity goes on linearly where the flow is curved, an error of first order
  // in a layer of one spacing.
  EXPECT_LT(fine, 0.01);
  EXPECT_GT(std::log2(coarse / fine), 1.5);
}

TEST(NoSlipWater, IsDraggedByAPlateThatSlides) {
  // Couette's flow is linear, so that the walls' factor is exact but for the lattice.
  Channel couette;
  couette.speed = 1;
  const double error = steady_error(couette, 10, 2);
  std::cout << "error " << error << "\n";
  EXPECT_LT(error, 0.01);
}

TYPED_TEST(NoSlipWalls, LoseEnergyInTheLongestStepThatViscosityAllows) {
  // A block in a corner, every velocity drawn at random: the stiffest modes are all there.
  test::LatticeSetup<2> setup;
  setup.length = 0.12;
  Scene<2> scene = test::make_scene_of(setup);
  scene.water_sticks = scene.needs_near_walls = true;
  scene.water_viscosity = 100;
  scene.artificial_viscosity = 0;
  scene.gravity = {};
  ParticleSet p = test::fill_lattice(
      scene, [](const Vec3& x) { return std::min(x.x(), x.z()) < 0.04 ? ParticleType::wall : ParticleType::water; },
      0.2);
  std::mt19937 random(5);
  std::uniform_real_distribution<float> number(-1, 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.type[i] == ParticleType::water) p.velocity[i] = Eigen::Vector3f(number(random), 0, number(random));
  }
  auto l = test::load<TypeParam>(scene, p);
  const double dt = 0.125 * 1000 * scene.smoothing_length * scene.smoothing_length / 100;
  test::TestStep step(l, dt);
  double before = sum_totals(l.on, l.p, l.scene).kinetic_energy;
  for (int n = 0; n < 50; ++n) {  // places and pressures as they are: viscosity alone
    test::change(l, [](test::Seen& seen) {
      for (Index i = 0; i < seen.fluid_count; ++i) seen.record[i].pressure = 0;
    });
    compute_accelerations(l.on, l.p, l.scene);
    NoSlipModel::add_forces(step.step);
    kick(l.on, l.p, step.state());
    const double after = sum_totals(l.on, l.p, l.scene).kinetic_energy;
    EXPECT_LT(after, before) << n;
    before = after;
  }
}

}  // namespace
}  // namespace thalweg
