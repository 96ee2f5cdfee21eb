#include <cmath>

#include "tests/solver/simulation/scenes_on_ranks.hpp"

// A scene on the GPUs of several ranks, which the host stands in for (guarded_cuda_core.cpp), gives the same particles and
// totals as on that of one rank, bit for bit.
namespace thalweg::test {
namespace {

class SceneOnGpus : public testing::TestWithParam<Scenario> {};

TEST_P(SceneOnGpus, IsTheSameBitForBit) {
  CaseRun run("gpus");
  run.fill(GetParam().scene, GetParam().overrides);
  const Outcome one = run_on(1, "cuda", run.scene(), run.start(), GetParam().steps);
  EXPECT_EQ(one.facts.device, "1 ranks of guarded");
  EXPECT_GT(unequal(one.first.position, one.last.position), 0U) << "nothing has moved";
  for (const int ranks : {2, 3}) {
    SCOPED_TRACE(std::to_string(ranks) + " ranks");
    const Outcome several = run_on(ranks, "cuda", run.scene(), run.start(), GetParam().steps);
    expect_same(one, several);
    EXPECT_GT(several.facts.copies_per_particle, 0) << "one rank has all of it";
    if (testing::Test::HasFailure()) return;
  }
}

// GPUs that are linked send each other the copies in the order of their work, and no host waits for them.
TEST_P(SceneOnGpus, IsTheSameOverALinkBitForBit) {
  CaseRun run("linked_gpus");
  run.fill(GetParam().scene, GetParam().overrides);
  const Outcome one = run_on(1, "cuda", run.scene(), run.start(), GetParam().steps);
  for (const int ranks : {2, 3}) {
    SCOPED_TRACE(std::to_string(ranks) + " ranks");
    const Outcome several = run_on(ranks, "cuda", run.scene(), run.start(), GetParam().steps, "nccl");
    EXPECT_EQ(several.facts.device, std::to_string(ranks) + " ranks of guarded, messages by NCCL");
    expect_same(one, several);
    if (testing::Test::HasFailure()) return;
  }
}

// A GPU by itself adds up in an order of its own.
TEST_P(SceneOnGpus, DiffersFromOneByItselfByRoundingAlone) {
  CaseRun run("gpus_alone");
  run.fill(GetParam().scene, GetParam().overrides);
  const Outcome one = run_on(1, "cuda", run.scene(), run.start(), GetParam().steps);
  const Outcome alone = run_alone("cuda", run.scene(), run.start(), GetParam().steps);
  ASSERT_EQ(one.last.id, alone.last.id);
  double apart = 0;
  for (std::size_t i = 0; i < one.last.size(); ++i) {
    apart = std::max(apart, (one.last.position[i] - alone.last.position[i]).norm());
  }
  RecordProperty("apart_in_spacings", std::to_string(apart / run.scene().numerics.spacing));
  EXPECT_LT(apart, 1e-4 * run.scene().numerics.spacing);
}

TEST_P(SceneOnGpus, GoesOnFromACheckpointOfOtherRanks) {
  CaseRun run("restart_gpus");
  run.fill(GetParam().scene, GetParam().overrides);
  const int steps = GetParam().steps;
  const Outcome whole = run_on(1, "cuda", run.scene(), run.start(), steps);
  const ParticleSet half = run_on(3, "cuda", run.scene(), run.start(), steps / 2).last;
  for (const int ranks : {1, 2}) {
    SCOPED_TRACE(std::to_string(ranks) + " ranks");
    expect_same(whole.last, run_on(ranks, "cuda", run.scene(), half, steps - steps / 2).last);
    if (testing::Test::HasFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(
    , SceneOnGpus,
    testing::Values(Scenario{"DamBreak", "dam_break", {"numerics.spacing=2.5 mm"}, 20},
                    Scenario{"Gate", "gate", {"numerics.spacing=10 mm"}, 10}, Scenario{"Channel", "channel", {}, 10},
                    Scenario{"Weir", "weir", {}, 10}, Scenario{"Louvain", "louvain", {"numerics.spacing=10 mm"}, 12},
                    Scenario{"Louvain3d", "louvain3d", {"numerics.spacing=20 mm"}, 6},
                    Scenario{"Columns", "submerged_columns", {"numerics.spacing=4 mm"}, 8},
                    Scenario{"Mixture",
                             "louvain",
                             {"numerics.spacing=10 mm", "model.sediment=viscoplastic", "model.seepage=mixture"},
                             8},
                    Scenario{
                        "SurfaceBed", "pipeline_hours", {"surface_bed.spin_up=2 ms", "surface_bed.window=5 ms"}, 10}),
    [](const auto& scenario) { return std::string(scenario.param.name); });

}  // namespace
}  // namespace thalweg::test
