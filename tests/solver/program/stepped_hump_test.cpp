#include <gtest/gtest.h>

#include "physics/transport/bed_load.hpp"
#include "tests/solver/case_run.hpp"

// Bed load over a hump that the lattice makes a flight of steps. Grains of 2 mm do not know of the steps: what goes over
// the back is what the law says of the shear stress there.
namespace thalweg {
namespace {

constexpr double diameter = 2e-3;
constexpr double porosity = 0.4;
constexpr double critical = 0.047;  // theta_cr

/// Over the back of the hump, per width [m^2/s].
struct Flux {
  double found = 0;
  double of_law = 0;  // of the stresses that the run shows
};

Flux flux_over_back(const ParticleSet& p) {
  constexpr double from = 0.32;
  constexpr double to = 0.48;
  const double rho = 2650 * (1 - porosity) + 1000 * porosity;
  const auto& shields = p.scalars.at("ShieldsNumber");
  Flux flux;
  int surface = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double x = p.position[i].x();
    if (p.type[i] != ParticleType::sediment || x < from || x > to) continue;
    flux.found += (1 - porosity) * double(p.mass[i]) / rho * double(p.velocity[i].x()) / (to - from);
    if (!(shields[i] > 0)) continue;
    flux.of_law += meyer_peter_mueller(double(shields[i]), critical);
    ++surface;
  }
  if (surface > 0) flux.of_law *= bed_load_scale(diameter, 2650.0, 1000.0, 9.81) / surface;
  return flux;
}

class SteppedHump : public testing::TestWithParam<double> {};

TEST_P(SteppedHump, CarriesWhatTheLawSays) {
  test::CaseRun run("stepped_hump");
  run.fill_from(THALWEG_SOURCE_DIR "/tests/solver/program/stepped_hump/hump.toml",
                {"numerics.spacing=\"" + std::to_string(GetParam()) + " m\""});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  Flux sum;
  for (const SeriesEntry& e : read_series(run.folder().snapshot_series())) {
    if (e.time < 0.09) continue;
    const Flux now = flux_over_back(read_particles(run.folder().root / e.file));
    sum.found += now.found;
    sum.of_law += now.of_law;
  }
  RecordProperty("flux_over_law", std::to_string(sum.found / sum.of_law));
  EXPECT_GT(sum.found / sum.of_law, 1 / 1.5);
  EXPECT_LT(sum.found / sum.of_law, 1.5);
}

INSTANTIATE_TEST_SUITE_P(Spacings, SteppedHump, testing::Values(0.01, 0.005));

}  // namespace
}  // namespace thalweg
