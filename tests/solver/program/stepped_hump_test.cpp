#include <gtest/gtest.h>

#include <random>

#include "physics/transport/bed_load.hpp"
#include "tests/solver/case_run.hpp"

// Bed load over a hump that the lattice makes a flight of steps. Grains of 2 mm do not know of the steps: what goes over
// the back is what the law says of the shear stress there.
namespace thalweg {
namespace {

constexpr double diameter = 2e-3;
constexpr double porosity = 0.4;
constexpr double critical = 0.047;  // theta_cr
constexpr float noise = 0.034F;     // [m/s] of the water's velocity at the start, half of the friction velocity

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

/// Found over the back between 0.1 s and the end, over the law's.
double flux_over_law(double spacing, std::vector<std::string> overrides) {
  overrides.push_back("numerics.spacing=\"" + std::to_string(spacing) + " m\"");
  test::CaseRun run("stepped_hump");
  run.fill_from(THALWEG_SOURCE_DIR "/tests/solver/program/stepped_hump/hump.toml", overrides);
  ParticleSet particles = run.start();
  std::mt19937 random(1);
  std::uniform_real_distribution<float> of_noise(-noise, noise);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.type[i] != ParticleType::water) continue;
    particles.velocity[i] += Eigen::Vector3f(of_noise(random), 0, of_noise(random));
  }
  write_particles(run.folder().particles(), particles, PositionPrecision::double_precision);
  EXPECT_EQ(run_solver(run.options()), Exit::done);
  Flux sum;
  for (const SeriesEntry& e : read_series(run.folder().snapshot_series())) {
    if (e.time < 0.09) continue;
    const Flux now = flux_over_back(read_particles(run.folder().root / e.file));
    sum.found += now.found;
    sum.of_law += now.of_law;
  }
  testing::Test::RecordProperty("flux_over_law", std::to_string(sum.found / sum.of_law));
  return sum.found / sum.of_law;
}

class SteppedHump : public testing::TestWithParam<double> {};

TEST_P(SteppedHump, CarriesWhatTheLawSays) {
  const double ratio = flux_over_law(GetParam(), {"flow.drive=slope", "flow.slope=0.0031"});
  EXPECT_GT(ratio, 1 / 1.5);
  EXPECT_LT(ratio, 1.5);
}

// The same current with nothing that drives it, which decays. Without the hold
// whole particles run over the hump, ten and more times what the law carries.
TEST_P(SteppedHump, CarriesItInACurrentThatDecaysIfItsSurfaceIsHeld) {
  const std::vector<std::string> decaying = {"flow.velocity=1.1 m/s"};
  std::vector<std::string> held = decaying;
  held.push_back("model.bed_surface=held");
  const double ratio = flux_over_law(GetParam(), held);
  EXPECT_GT(ratio, 1 / 1.5);
  EXPECT_LT(ratio, 1.5);
  EXPECT_GT(flux_over_law(GetParam(), decaying), 3);
}

INSTANTIATE_TEST_SUITE_P(Spacings, SteppedHump, testing::Values(0.01, 0.005));

}  // namespace
}  // namespace thalweg
