#include "common/error.hpp"
#include "tests/solver/simulation/scenes_on_ranks.hpp"

// A scene on several ranks gives the same particles and totals as on one, bit for bit.
namespace thalweg::test {
namespace {

class SceneOnRanks : public testing::TestWithParam<Scenario> {};

TEST_P(SceneOnRanks, IsTheSameBitForBit) {
  CaseRun run("ranks");
  run.fill(GetParam().scene, GetParam().overrides);
  const Outcome one = run_alone("openmp", run.scene(), run.start(), GetParam().steps);
  EXPECT_GT(unequal(one.first.position, one.last.position), 0U) << "nothing has moved";
  for (const int ranks : {2, 3, 4, 8}) {
    SCOPED_TRACE(std::to_string(ranks) + " ranks");
    expect_same(one, run_on(ranks, "openmp", run.scene(), run.start(), GetParam().steps));
    if (testing::Test::HasFailure()) return;
  }
}

TEST_P(SceneOnRanks, GoesOnFromACheckpointOfOtherRanks) {
  CaseRun run("restart_ranks");
  run.fill(GetParam().scene, GetParam().overrides);
  const int steps = GetParam().steps;
  const Outcome whole = run_alone("openmp", run.scene(), run.start(), steps);
  const ParticleSet half = run_on(3, "openmp", run.scene(), run.start(), steps / 2).last;
  expect_same(whole.last, run_alone("openmp", run.scene(), half, steps - steps / 2).last);
  for (const int ranks : {2, 4}) {
    SCOPED_TRACE(std::to_string(ranks) + " ranks");
    expect_same(whole.last, run_on(ranks, "openmp", run.scene(), half, steps - steps / 2).last);
    if (testing::Test::HasFailure()) return;
  }
}

// A short run of every model: with walls that move, periodic sides, a drive, openings, all kinds of beds.
INSTANTIATE_TEST_SUITE_P(
    , SceneOnRanks,
    testing::Values(
        Scenario{"DamBreak", "dam_break", {}, 60}, Scenario{"Spheric", "spheric02", {"numerics.spacing=60 mm"}, 30},
        Scenario{"Gate", "gate", {}, 40}, Scenario{"Channel", "channel", {}, 30}, Scenario{"Weir", "weir", {}, 30},
        Scenario{"Guided", "channel", {"flow.guide_from=0.15 m", "flow.guide_length=0.1 m"}, 30},
        Scenario{"FedBed",
                 "../tests/solver/program/openings/feed.toml",
                 {"inlet.west.bed_load=fixed", "inlet.west.bed_load_rate=2e-3 m^2/s"},
                 60},
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
        // Coarse grains settle within 250 steps so that the lowest water becomes bed, and within 500 so that it
        // has grains for more, which go to the water over it.
        Scenario{"LoadedBed",
                 "batch_sedimentation",
                 {"numerics.spacing=2.5 mm", "numerics.maximum_speed=0.4 m/s", "shape.suspension.concentration=0.25",
                  "materials.sand.grain_diameter=2 mm"},
                 540},
        Scenario{"SurfaceBed", "pipeline_hours", {"surface_bed.spin_up=2 ms", "surface_bed.window=5 ms"}, 60}),
    [](const auto& scenario) { return std::string(scenario.param.name); });

// The first rank gives the reason. The others end with a word of their own.
TEST(StartOnRanks, OfASceneThatCannotRunIsRefusedOnAllRanks) {
  CaseRun run("refused_ranks");
  run.fill("dam_break", {"numerics.spacing=20 mm"});
  Case scene = run.scene();
  scene.numerics.maximum_speed = 0;
  ThreadRanks(3).run([&](Ranks& mine) {
    StartOptions options{"openmp", "auto", 1};
    options.ranks = &mine;
    const ParticleSet nothing;
    try {
      start_simulation(scene, mine.rank() == 0 ? run.start() : nothing, options);
      ADD_FAILURE() << "rank " << mine.rank() << " has begun";
    } catch (const InputError& error) {
      const bool gives_the_reason = std::string(error.what()).find("maximum_speed") != std::string::npos;
      EXPECT_EQ(gives_the_reason, mine.rank() == 0) << error.what();
    }
  });
}

// Within 1600 steps grains of the bed go to water over it that another rank has. At step 800, where the restart begins,
// particles are due to become bed.
TEST(LoadedBedOnRanks, GrainsGoFromRankToRank) {
  CaseRun run("loaded_ranks");
  run.fill("batch_sedimentation", {"numerics.spacing=2.5 mm", "numerics.maximum_speed=0.4 m/s",
                                   "shape.suspension.concentration=0.3", "materials.sand.grain_diameter=4 mm"});
  const Outcome one = run_alone("openmp", run.scene(), run.start(), 1600);
  expect_same(one, run_on(3, "openmp", run.scene(), run.start(), 1600));
  const ParticleSet half = run_on(2, "openmp", run.scene(), run.start(), 800).last;
  expect_same(one.last, run_alone("openmp", run.scene(), half, 800).last);
  expect_same(one.last, run_on(3, "openmp", run.scene(), half, 800).last);
}

}  // namespace
}  // namespace thalweg::test
