#include <gtest/gtest.h>

#include <map>

#include "common/error.hpp"
#include "solver/simulation/input.hpp"
#include "tests/solver/lattice_scene.hpp"

namespace thalweg {
namespace {

struct Start {
  Scene<2> scene;
  ParticleSet particles;
};

/// A step of sediment under water in a tank, about to slump.
Start slumping_tank() {
  test::LatticeSetup<2> setup;
  setup.gravity = {0, -9.81F};
  Start s{test::make_scene_of(setup), {}};
  s.scene.has_sediment = true;
  s.scene.sediment.yield_coefficient = 0.6F;
  s.scene.sediment.friction_tangent = 0.78F;
  s.scene.sediment.regularisation = 100;
  s.scene.sediment.consistency = 1e-3F;
  s.scene.sediment.submerged_weight = 300 * 9.81F;
  s.particles = test::fill_lattice(s.scene, [](const Vec3& x) {
    if (x.z() < 0.03 || x.x() < 0.03 || x.x() > 0.17) return ParticleType::wall;
    if (x.x() < 0.09 && x.z() < 0.1) return ParticleType::sediment;
    return ParticleType::water;
  });
  return s;
}

/// Positions by particle id after so many steps of fixed length.
std::map<std::int64_t, Vec3> after_steps(const Start& start, const std::string& isa, int threads, int steps,
                                         bool double_pair_sums = false) {
  const auto simulation = make_simulation(
      {.scene = start.scene, .particles = &start.particles, .threads = threads, .double_pair_sums = double_pair_sums},
      "openmp", isa);
  for (int n = 0; n < steps; ++n) {
    const StepReport report = simulation->advance(1e-4);
    EXPECT_FALSE(report.diverged);
  }
  const ParticleSet end = simulation->snapshot();
  std::map<std::int64_t, Vec3> position;
  for (std::size_t i = 0; i < end.size(); ++i) position[end.id[i]] = end.position[i];
  return position;
}

double largest_difference(const std::map<std::int64_t, Vec3>& a, const std::map<std::int64_t, Vec3>& b) {
  double largest = 0;
  for (const auto& [id, x] : a) largest = std::max(largest, (x - b.at(id)).norm());
  return largest;
}

TEST(Cores, OfEveryInstructionSetAgree) {
  // Sums are taken in another order and roots rounded differently: single rounding of accelerations of order 10 m/s^2
  // grows to 1e-7 x 10 x (20 x 1e-4)^2 / 2 = 2e-12 m in 20 steps, times what the stiff viscous solve makes of it.
  const Start start = slumping_tank();
  const auto baseline = after_steps(start, "baseline", 1, 20);
  double moved = 0;
  for (std::size_t i = 0; i < start.particles.size(); ++i) {
    moved = std::max(moved, (baseline.at(start.particles.id[i]) - start.particles.position[i]).norm());
  }
  EXPECT_GT(moved, 1e-6);
  int compared = 0;
  for (const char* isa : {"avx2", "avx512"}) {
    try {
      EXPECT_LT(largest_difference(baseline, after_steps(start, isa, 1, 20)), 1e-3 * moved) << isa;
      ++compared;
    } catch (const InputError& e) {
      std::cout << "not compared: " << e.what() << "\n";
    }
  }
  if (compared == 0) GTEST_SKIP() << "no instruction set beyond the baseline here";
}

TEST(Cores, ResultsDoNotDependOnThreads) {
  const Start start = slumping_tank();
  EXPECT_EQ(largest_difference(after_steps(start, "auto", 1, 30), after_steps(start, "auto", 3, 30)), 0);
  EXPECT_EQ(largest_difference(after_steps(start, "auto", 1, 10, true), after_steps(start, "auto", 3, 10, true)), 0);
}

TEST(Cores, InDoubleMoveAsInSingleButForItsRounding) {
  // The bound is that of OfEveryInstructionSetAgree.
  const Start start = slumping_tank();
  for (const char* isa : {"baseline", "avx2", "avx512"}) {
    try {
      const auto in_single = after_steps(start, isa, 1, 20);
      const auto in_double = after_steps(start, isa, 1, 20, true);
      double moved = 0;
      for (std::size_t i = 0; i < start.particles.size(); ++i) {
        moved = std::max(moved, (in_single.at(start.particles.id[i]) - start.particles.position[i]).norm());
      }
      EXPECT_GT(largest_difference(in_single, in_double), 0) << isa;
      EXPECT_LT(largest_difference(in_single, in_double), 1e-3 * moved) << isa;
    } catch (const InputError& e) {
      std::cout << "not compared: " << e.what() << "\n";
    }
  }
}

TEST(Cores, ContinueInSpaceWithMohrCoulombBitForBit) {
  // The strength depends on the last step's rate of strain, Lode angle included: a checkpoint holds both.
  test::LatticeSetup<3> setup;
  setup.length = 0.1;
  setup.gravity = {0, 0, -9.81F};
  Scene<3> scene = test::make_scene_of(setup);
  scene.has_sediment = true;
  scene.sediment = slumping_tank().scene.sediment;
  scene.sediment.yield = YieldCriterion::mohr_coulomb;
  const ParticleSet start = test::fill_lattice(scene, [](const Vec3& x) {
    if (x.z() < 0.03) return ParticleType::wall;
    return x.x() < 0.05 && x.y() < 0.06 && x.z() < 0.07 ? ParticleType::sediment : ParticleType::water;
  });
  const auto advance = [](Simulation& s, int steps) {
    for (int n = 0; n < steps; ++n) EXPECT_FALSE(s.advance(1e-4).diverged);
  };
  const auto straight = make_simulation({scene, &start, 1}, "openmp", "auto");
  advance(*straight, 3);
  const ParticleSet checkpoint = straight->full_state();
  advance(*straight, 3);
  const auto continued = make_simulation({scene, &checkpoint, 1}, "openmp", "auto");
  advance(*continued, 3);
  const ParticleSet a = straight->full_state();
  const ParticleSet b = continued->full_state();
  const auto& numbers = a.doubles.at(field::sediment.name);
  double largest_sine = 0;
  for (std::size_t n = offsetof(Sediment, lode_sine) / sizeof(float); n < numbers.size();
       n += sizeof(Sediment) / sizeof(float)) {
    largest_sine = std::max(largest_sine, std::abs(numbers[n]));
  }
  EXPECT_GT(largest_sine, 0.5);  // not all is plane strain
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.scalars, b.scalars);
  EXPECT_EQ(a.doubles, b.doubles);
}

TEST(Cores, RefuseWhatIsNotThere) {
  const Start start = slumping_tank();
  EXPECT_THROW(make_simulation({start.scene, &start.particles, 1}, "cuda", "auto"), InputError);
  EXPECT_THROW(make_simulation({start.scene, &start.particles, 1}, "openmp", "mmx"), InputError);
  try {
    make_simulation({.scene = start.scene, .particles = &start.particles, .double_pair_sums = true}, "cuda", "auto");
    FAIL() << "double sums on a GPU";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("numerics.precision"), std::string::npos) << e.what();
  }
}

TEST(Cores, TakeTheCpuForDoubleSumsAndSaySo) {
  const Start start = slumping_tank();
  const auto simulation = make_simulation(
      {.scene = start.scene, .particles = &start.particles, .threads = 1, .double_pair_sums = true}, "auto", "auto");
  const std::string device = simulation->facts().device;
  EXPECT_EQ(device.find("OpenMP"), 0U) << device;
  EXPECT_NE(device.find("pair sums in double"), std::string::npos) << device;
}

}  // namespace
}  // namespace thalweg
