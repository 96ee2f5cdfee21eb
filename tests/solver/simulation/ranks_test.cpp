#include <gtest/gtest.h>

#include <memory>

#include "solver/simulation/start.hpp"
#include "tests/solver/case_run.hpp"
#include "tests/solver/thread_ranks.hpp"

// A scene on several ranks gives the same particles and totals as on one, bit for bit.
namespace thalweg::test {
namespace {

struct Scenario {
  const char* name;
  const char* scene;
  std::vector<std::string> overrides;
  int steps;
};
void PrintTo(const Scenario& s, std::ostream* to) { *to << s.name; }

struct Outcome {
  ParticleSet first;  // before any step
  ParticleSet last;
  Totals totals;
  SimulationFacts facts;
};

Outcome outcome_of(Simulation& simulation, const ParticleFileInfo& start, int steps) {
  Outcome outcome;
  outcome.first = simulation.snapshot();
  double time = start.time;
  for (int n = 0; n < steps; ++n) {
    simulation.set_time(time);
    time += simulation.advance(1).dt;
  }
  outcome.last = simulation.full_state();
  outcome.last.info = start;
  outcome.last.info.time = time;
  outcome.last.info.step += steps;
  outcome.totals = simulation.totals();
  outcome.facts = simulation.facts();
  return outcome;
}

Outcome run_on(int ranks, const Case& of, const ParticleSet& start, int steps) {
  StartOptions options{"openmp", "auto", 1};
  if (ranks == 1) return outcome_of(*start_simulation(of, start, options), start.info, steps);
  Outcome outcome;
  ThreadRanks(ranks).run([&](Ranks& mine) {
    StartOptions shared = options;
    shared.ranks = &mine;
    std::unique_ptr<Simulation> share = start_simulation(of, start, shared);
    if (mine.rank() == 0) {
      outcome = outcome_of(*lead(std::move(share), mine), start.info, steps);
    } else {
      follow(*share, mine);
    }
  });
  return outcome;
}

/// Number of unequal entries.
template <class T>
std::size_t unequal(const std::vector<T>& a, const std::vector<T>& b) {
  if (a.size() != b.size()) return std::max(a.size(), b.size());
  std::size_t n = 0;
  for (std::size_t i = 0; i < a.size(); ++i) n += a[i] == b[i] ? 0 : 1;
  return n;
}

void expect_same(const ParticleSet& a, const ParticleSet& b) {
  EXPECT_EQ(unequal(a.id, b.id), 0U);
  EXPECT_EQ(unequal(a.position, b.position), 0U);
  EXPECT_EQ(unequal(a.velocity, b.velocity), 0U);
  EXPECT_EQ(unequal(a.pressure, b.pressure), 0U);
  EXPECT_EQ(unequal(a.density, b.density), 0U);
  ASSERT_EQ(a.scalars.size(), b.scalars.size());
  for (const auto& [name, array] : a.scalars) EXPECT_EQ(unequal(array, b.scalars.at(name)), 0U) << name;
  ASSERT_EQ(a.doubles.size(), b.doubles.size());
  for (const auto& [name, array] : a.doubles) EXPECT_EQ(unequal(array, b.doubles.at(name)), 0U) << name;
  EXPECT_EQ(a.facts, b.facts);
}

void expect_same(const Outcome& one, const Outcome& several) {
  expect_same(one.first, several.first);
  expect_same(one.last, several.last);
  EXPECT_EQ(one.totals.kinetic_energy, several.totals.kinetic_energy);
  EXPECT_EQ(one.totals.potential_energy, several.totals.potential_energy);
  EXPECT_EQ(one.totals.momentum[0], several.totals.momentum[0]);
  EXPECT_EQ(one.totals.grain_mass, several.totals.grain_mass);
  EXPECT_EQ(one.facts.particles, several.facts.particles);
}

class SceneOnRanks : public testing::TestWithParam<Scenario> {};

TEST_P(SceneOnRanks, IsTheSameBitForBit) {
  CaseRun run("ranks");
  run.fill(GetParam().scene, GetParam().overrides);
  const Outcome one = run_on(1, run.scene(), run.start(), GetParam().steps);
  EXPECT_GT(unequal(one.first.position, one.last.position), 0U) << "nothing has moved";
  for (const int ranks : {2, 3, 4, 8}) {
    SCOPED_TRACE(std::to_string(ranks) + " ranks");
    expect_same(one, run_on(ranks, run.scene(), run.start(), GetParam().steps));
    if (testing::Test::HasFailure()) return;
  }
}

TEST_P(SceneOnRanks, GoesOnFromACheckpointOfOtherRanks) {
  CaseRun run("restart_ranks");
  run.fill(GetParam().scene, GetParam().overrides);
  const int steps = GetParam().steps;
  const Outcome whole = run_on(1, run.scene(), run.start(), steps);
  const ParticleSet half = run_on(3, run.scene(), run.start(), steps / 2).last;
  for (const int ranks : {1, 2, 4}) {
    SCOPED_TRACE(std::to_string(ranks) + " ranks");
    Outcome rest = run_on(ranks, run.scene(), half, steps - steps / 2);
    expect_same(whole.last, rest.last);
    if (testing::Test::HasFailure()) return;
  }
}

// A short run of every model: with walls that move, periodic sides, a drive, openings, all kinds of beds.
INSTANTIATE_TEST_SUITE_P(
    , SceneOnRanks,
    testing::Values(Scenario{"DamBreak", "dam_break", {}, 60},
                    Scenario{"Spheric", "spheric02", {"numerics.spacing=60 mm"}, 30}, Scenario{"Gate", "gate", {}, 40},
                    Scenario{"Channel", "channel", {}, 30}, Scenario{"Weir", "weir", {}, 30},
                    Scenario{"LargeEddies", "channel", {"model.turbulence=sps"}, 20},
                    Scenario{"Louvain", "louvain", {"numerics.spacing=10 mm"}, 60},
                    Scenario{"Louvain3d", "louvain3d", {"numerics.spacing=20 mm"}, 20},
                    Scenario{"Laplace", "louvain", {"numerics.spacing=10 mm", "model.effective_pressure=laplace"}, 20},
                    Scenario{"Explicit", "louvain", {"numerics.spacing=10 mm", "numerics.viscosity=explicit"}, 10},
                    Scenario{"Columns", "submerged_columns", {}, 16}, Scenario{"Pier", "pier", {}, 10},
                    Scenario{"Mixture",
                             "louvain",
                             {"numerics.spacing=10 mm", "model.sediment=viscoplastic", "model.seepage=mixture"},
                             20},
                    Scenario{
                        "SurfaceBed", "pipeline_hours", {"surface_bed.spin_up=2 ms", "surface_bed.window=5 ms"}, 60}),
    [](const auto& scenario) { return std::string(scenario.param.name); });

}  // namespace
}  // namespace thalweg::test
