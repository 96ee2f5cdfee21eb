#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>

#include "solver/simulation/input.hpp"
#include "solver/simulation/make_scene.hpp"
#include "tests/solver/case_run.hpp"

// Whole cases on two devices, step by step. Which one is held against the baseline of the OpenMP backend is told by
// THALWEG_TEST_BACKEND (tools/gpu-check: cuda); without it that is the widest instruction set of this processor.
namespace thalweg {
namespace {

struct Scenario {
  const char* name;
  std::vector<std::string> overrides;
  int steps;
};
void PrintTo(const Scenario& s, std::ostream* to) { *to << s.name; }

class CaseAgreement : public testing::TestWithParam<Scenario> {};

std::unique_ptr<Simulation> tested_device(const SimulationInput& input) {
  const char* backend = std::getenv("THALWEG_TEST_BACKEND");
  return make_simulation(input, backend == nullptr ? "openmp" : backend, "auto");
}

/// Root mean square of the distances between equal particles [m].
double distance(const ParticleSet& a, const ParticleSet& b) {
  std::map<std::int64_t, Vec3> in_b;
  for (std::size_t i = 0; i < b.size(); ++i) in_b[b.id[i]] = b.position[i];
  double squares = 0;
  for (std::size_t i = 0; i < a.size(); ++i) squares += (a.position[i] - in_b.at(a.id[i])).squaredNorm();
  return std::sqrt(squares / static_cast<double>(a.size()));
}

TEST_P(CaseAgreement, OfTwoDevices) {
  test::CaseRun run("agreement");
  run.fill(GetParam().name, GetParam().overrides);
  const ParticleSet& start = run.start();
  const AnyScene scene = make_scene(run.scene(), start);
  const auto reference = make_simulation({scene, &start, 1}, "openmp", "baseline");
  const auto tested = tested_device({scene, &start, 1});
  // The same steps on both, well within what is stable: what is compared is one step's work, many times over.
  const double dt = 0.4 * make_simulation({scene, &start, 1}, "openmp", "baseline")->advance(1).dt;
  for (int n = 0; n < GetParam().steps; ++n) {
    ASSERT_EQ(reference->advance(dt).dt, dt) << "step " << n;
    ASSERT_EQ(tested->advance(dt).dt, dt) << "step " << n;
  }
  const ParticleSet a = reference->snapshot();
  const ParticleSet b = tested->snapshot();
  const double moved = distance(a, start);
  // Sums in another order differ by single rounding, 1e-7 of each; colliding particles multiply a difference, and the
  // viscous solve stops at a residual of 1e-3. Across cores of one processor it is 1e-5 to 1e-3 of the way gone.
  EXPECT_GT(moved, 0);
  EXPECT_LT(distance(a, b), 0.01 * moved);
  const Totals ta = reference->totals();
  const Totals tb = tested->totals();
  EXPECT_EQ(ta.sediment, tb.sediment);
  EXPECT_NEAR(tb.water_mass, ta.water_mass, 1e-12 * ta.water_mass);
  EXPECT_NEAR(tb.sediment_mass, ta.sediment_mass, 1e-12 * ta.sediment_mass);
  EXPECT_NEAR(tb.kinetic_energy, ta.kinetic_energy, 0.01 * ta.kinetic_energy);
  EXPECT_NEAR(tb.potential_energy, ta.potential_energy, 1e-5 * std::abs(ta.potential_energy));
}

INSTANTIATE_TEST_SUITE_P(Of, CaseAgreement,
                         testing::Values(Scenario{"still_water", {"numerics.spacing=\"10 mm\""}, 200},
                                         Scenario{"dam_break", {}, 200},
                                         Scenario{"louvain", {"numerics.spacing=\"10 mm\""}, 200},
                                         Scenario{"louvain3d", {"numerics.spacing=\"20 mm\""}, 30}),
                         [](const auto& scenario) { return std::string(scenario.param.name); });

}  // namespace
}  // namespace thalweg
