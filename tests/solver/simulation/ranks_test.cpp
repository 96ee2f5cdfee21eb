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

Outcome outcome_of(Simulation& simulation, int steps) {
  Outcome outcome;
  outcome.first = simulation.snapshot();
  for (int n = 0; n < steps; ++n) simulation.advance(1);
  outcome.last = simulation.full_state();
  outcome.totals = simulation.totals();
  outcome.facts = simulation.facts();
  return outcome;
}

Outcome run_on(int ranks, const Case& of, const ParticleSet& start, int steps) {
  StartOptions options{"openmp", "auto", 1};
  if (ranks == 1) return outcome_of(*start_simulation(of, start, options), steps);
  Outcome outcome;
  ThreadRanks(ranks).run([&](Ranks& mine) {
    StartOptions shared = options;
    shared.ranks = &mine;
    std::unique_ptr<Simulation> share = start_simulation(of, start, shared);
    if (mine.rank() == 0) {
      outcome = outcome_of(*lead(std::move(share), mine), steps);
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

class SceneOnRanks : public testing::TestWithParam<Scenario> {};

TEST_P(SceneOnRanks, IsTheSameBitForBit) {
  CaseRun run("ranks");
  run.fill(GetParam().scene, GetParam().overrides);
  const Outcome one = run_on(1, run.scene(), run.start(), GetParam().steps);
  for (const int ranks : {2, 3, 8}) {
    SCOPED_TRACE(std::to_string(ranks) + " ranks");
    const Outcome several = run_on(ranks, run.scene(), run.start(), GetParam().steps);
    expect_same(one.first, several.first);
    expect_same(one.last, several.last);
    EXPECT_EQ(one.totals.kinetic_energy, several.totals.kinetic_energy);
    EXPECT_EQ(one.totals.momentum[2], several.totals.momentum[2]);
    EXPECT_EQ(one.facts.particles, several.facts.particles);
    if (testing::Test::HasFailure()) return;
  }
}

const auto name_of = [](const auto& scenario) { return std::string(scenario.param.name); };

INSTANTIATE_TEST_SUITE_P(Water, SceneOnRanks,
                         testing::Values(Scenario{"DamBreak", "dam_break", {}, 60},
                                         Scenario{"Gate", "gate", {}, 40},
                                         Scenario{"Spheric", "spheric02", {"numerics.spacing=60 mm"}, 40},
                                         Scenario{"Channel", "channel", {}, 40}),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Sediment, SceneOnRanks,
                         testing::Values(Scenario{"Louvain", "louvain", {"numerics.spacing=10 mm"}, 60},
                                         Scenario{"Louvain3d", "louvain3d", {"numerics.spacing=20 mm"}, 20},
                                         Scenario{"Columns", "submerged_columns", {}, 20},
                                         Scenario{"Pier", "pier", {}, 10},
                                         Scenario{"Batch", "batch_sedimentation", {}, 20},
                                         Scenario{"Laplace", "louvain", {"numerics.spacing=10 mm", "model.effective_pressure=laplace"}, 20},
                                         Scenario{"Fixed", "louvain_fixed_bed", {}, 20},
                                         Scenario{"Weir", "weir", {}, 20},
                                         Scenario{"PipelineHours", "pipeline_hours", {"surface_bed.spin_up=2 ms", "surface_bed.window=5 ms"}, 60}),
                         name_of);

}  // namespace
}  // namespace thalweg::test
