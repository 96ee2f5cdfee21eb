#include <future>

#include "device_steps_test.hpp"
#include "device_verbs_test.hpp"
#include "tests/solver/scenes.hpp"

namespace thalweg::test {

INSTANTIATE_TYPED_TEST_SUITE_P(OnTheHost, OnDevice, Backends, BackendNames);
INSTANTIATE_TYPED_TEST_SUITE_P(OnTheHost, StepsOnDevice, Backends, BackendNames);

/// The scenes whose steps a GPU makes without asking the host on the way.
std::vector<DeviceScene> resident_scenes() {
  std::vector<DeviceScene> scenes = device_scenes();
  std::erase_if(scenes, [](const DeviceScene& s) {
    return std::visit(
        [](const auto& scene) {
          return scene.walls_move || scene.sediment.effective_pressure == EffectivePressure::laplace;
        },
        s.scene);
  });
  return scenes;
}

TEST(DeviceResident, StepsWaitOnceForTheDevice) {
  int steps = 0;
  for (const DeviceScene& s : resident_scenes()) {
    SCOPED_TRACE(s.name);
    const auto simulation = simulation_on<Guarded>(s, s.particles);
    for (int n = 0; n < s.steps; ++n) {
      const Totals totals = simulation->totals();
      const std::int64_t rebuilds = simulation->facts().list_rebuilds;
      const int waits = GuardedRuntime::waits();
      const StepReport report = simulation->advance(1e-4);
      const int waited = GuardedRuntime::waits() - waits;
      // New lists, their changes, and a solve that takes longer than expected, are what the host has to know of.
      if (simulation->facts().list_rebuilds > rebuilds || simulation->totals().resting != totals.resting) continue;
      const int expected = 1 + (report.viscous.iterations > 4 ? report.viscous.iterations : 0);
      EXPECT_LE(waited, expected);
      steps += waited == 1 ? 1 : 0;
    }
  }
  EXPECT_GT(steps, 10);
}

TEST(DeviceResident, StepsAreTheSameWhenTheyAreRepeatedAsOne) {
  int replays = 0;
  for (const DeviceScene& s : resident_scenes()) {
    SCOPED_TRACE(s.name);
    const auto repeating = simulation_on<Guarded>(s, s.particles);
    const auto plain =
        std::visit([&](const auto& scene) { return Maker<Guarded>::make(scene, s.particles, s, true); }, s.scene);
    const int before = GuardedRuntime::Recording::replays();
    for (int n = 0; n < s.steps; ++n) {
      const StepReport a = repeating->advance(1e-4);
      const StepReport b = plain->advance(1e-4);
      EXPECT_EQ(a.dt, b.dt);
      EXPECT_EQ(a.viscous.iterations, b.viscous.iterations);
    }
    replays += GuardedRuntime::Recording::replays() - before;
    const ParticleSet a = repeating->full_state();
    const ParticleSet b = plain->full_state();
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.velocity, b.velocity);
  }
  EXPECT_GT(replays, 10);
}

TEST(DeviceResident, StoresPairCoefficientsOrComputesThemAgain) {
  // Stored ones are rounded to half a float, which the solve's quadratic form feels by 2^-9 at most.
  for (const DeviceScene& s : device_scenes()) {
    SCOPED_TRACE(s.name);
    const auto computed = simulation_on<Guarded>(s, s.particles);
    const auto stored = std::visit(
        [&]<int Dim>(const Scene<Dim>& scene) -> std::unique_ptr<Simulation> {
          return std::make_unique<SimulationOn<Dim, Guarded>>(Guarded(true), "under test", scene, s.particles, false,
                                                              s.motions, s.openings(), s.surface_bed(s.particles));
        },
        s.scene);
    double more = 0;
    for (int n = 0; n < s.steps; ++n) {
      ASSERT_FALSE(computed->advance(1e-4).diverged);
      ASSERT_FALSE(stored->advance(1e-4).diverged);
      more = stored->facts().bytes_per_particle - computed->facts().bytes_per_particle;
      if (more == 0) break;  // no sediment, or a coupling that stores them anyway: the same passes
    }
    if (more == 0) continue;
    const Difference d = difference(s.particles, computed->snapshot(), stored->snapshot());
    EXPECT_LT(d.apart, 1e-3 * d.moved);
    const double entries = stored->facts().list_entries_per_particle;
    EXPECT_NEAR(more, entries * double(cluster_size * sizeof(ShortFloat)) + double(sizeof(Vectors)), 1);
  }
}

TEST(DeviceResident, SnapshotsAreOfTheirTimeWhileStepsGoOn) {
  const DeviceScene s = device_scenes().back();
  const auto simulation = simulation_on<Guarded>(s, s.particles);
  simulation->advance(1e-4);
  const ParticleSet then = simulation->snapshot();
  const auto take = simulation->begin_snapshot();
  auto taken = std::async(std::launch::async, take);
  for (int n = 0; n < 5; ++n) simulation->advance(1e-4);
  EXPECT_EQ(taken.get().position, then.position);
  EXPECT_NE(simulation->snapshot().position, then.position);
}

}  // namespace thalweg::test
