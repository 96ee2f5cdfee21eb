#include <gtest/gtest.h>

#include <map>

#include "common/error.hpp"
#include "scenes.hpp"
#include "solver/simulation.hpp"

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
  s.scene.sediment = {.yield_coefficient = 0.6F,
                      .friction_tangent = 0.78F,
                      .regularisation = 100,
                      .consistency = 1e-3F,
                      .submerged_weight = 300 * 9.81F};
  s.particles = test::fill_lattice(s.scene, [](const Vec3& x) {
    if (x.z() < 0.03 || x.x() < 0.03 || x.x() > 0.17) return ParticleType::wall;
    if (x.x() < 0.09 && x.z() < 0.1) return ParticleType::sediment;
    return ParticleType::water;
  });
  return s;
}

/// Positions by particle id after so many steps of fixed length.
std::map<std::int64_t, Vec3> after_steps(const Start& start, const std::string& isa, int threads, int steps) {
  const auto simulation = make_simulation({start.scene, &start.particles, threads}, "openmp", isa);
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
    } catch (const InputError&) {
      std::cout << "this processor has no " << isa << "\n";
    }
  }
  if (compared == 0) GTEST_SKIP() << "no instruction set beyond the baseline here";
}

TEST(Cores, ResultsDoNotDependOnThreads) {
  const Start start = slumping_tank();
  EXPECT_EQ(largest_difference(after_steps(start, "auto", 1, 30), after_steps(start, "auto", 3, 30)), 0);
}

TEST(Cores, RefuseWhatIsNotThere) {
  const Start start = slumping_tank();
  EXPECT_THROW(make_simulation({start.scene, &start.particles, 1}, "cuda", "auto"), InputError);
  EXPECT_THROW(make_simulation({start.scene, &start.particles, 1}, "openmp", "mmx"), InputError);
}

}  // namespace
}  // namespace thalweg
