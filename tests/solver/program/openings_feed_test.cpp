#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

#include "common/error.hpp"
#include "physics/transport/bed_load.hpp"
#include "physics/water/log_profile.hpp"
#include "tests/solver/case_run.hpp"
#include "tests/solver/program/broken_run.hpp"
#include "tests/solver/program/trend.hpp"

// Bed load that comes in through an inlet, over a bed of particles that the current moves.
namespace thalweg {
namespace {

constexpr const char* fed_scene = THALWEG_SOURCE_DIR "/tests/solver/program/openings/feed.toml";
constexpr double bed_density = 0.6 * 2650 + 0.4 * 1000;  // [kg/m^3]

/// Bed load of the scene's current at a depth [m] by the law of Meyer-Peter & Müller [m^2/s].
double bed_load_of_law(double depth) {
  const double friction = friction_velocity_of_current(0.126 / depth, depth, 1e-6, 1e-3);
  const double shields = friction * friction / (1.65 * 9.81 * 1e-3);
  return bed_load_scale(1e-3, 2650.0, 1000.0, 9.81) * bed_load(BedLoad::meyer_peter_mueller, shields, 0.047, 25.0);
}

/// Area of the bed between two places x [m^2].
double bed_between(const ParticleSet& p, double from, double to) {
  double area = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double x = p.position[i].x();
    if (p.type[i] == ParticleType::sediment && x >= from && x < to) area += double(p.mass[i]) / bed_density;
  }
  return area;
}

std::vector<double> column(const test::CaseRun& run, const std::string& name, const std::string& unit) {
  return CsvTable::read(run.folder().history()).numbers(name, unit);
}

// Two minutes of processor time: openings_run_test.long.
TEST(BedLoadOfInlets, DISABLED_KeepsTheBedBehindThem) {
  // In 16 s the current carries away 16 s q/(1 - n), q of the law; a third of it or less may be missing behind the inlet,
  // where three spacings pass before the load is the law's.
  const double carried = 16 * bed_load_of_law(0.15) / 0.6;
  test::CaseRun fed("bed_fed");
  fed.fill_from(fed_scene, {});
  ASSERT_EQ(run_solver(fed.options()), Exit::done);
  const double before = bed_between(fed.start(), 0, 0.3);
  const double lost = before - bed_between(fed.snapshot_at(16), 0, 0.3);
  EXPECT_LT(std::abs(lost), 0.33 * carried);
  // The inlet brings the law's bed load at the depth behind it, 4 to 10 mm more than before the outlet, as the bed
  // is level.
  const auto t = column(fed, "time", "s");
  const auto in = column(fed, "west_sediment", "kg");
  const auto level = column(fed, "west_level", "m");
  std::size_t first = 0;
  while (t[first] < 4) ++first;
  const double depth = std::accumulate(level.begin() + static_cast<std::ptrdiff_t>(first), level.end(), 0.0) /
                           static_cast<double>(level.size() - first) -
                       0.06;
  const double law = bed_density * bed_load_of_law(depth) / 0.6;
  EXPECT_NEAR(test::trend(t, in, first), law, 0.2 * law);
  // The books are those of the particles: nothing gets lost between host and device.
  const auto sediment = column(fed, "sediment_mass", "kg");
  const auto out = column(fed, "east_sediment", "kg");
  const double particle = bed_density * 1e-4;
  EXPECT_NEAR(sediment.back() - sediment.front(), in.back() + out.back(), 1.5 * particle);

  test::CaseRun starved("bed_starved");
  starved.fill_from(fed_scene, {"inlet.west.bed_load=none", "output.end=8 s"});
  ASSERT_EQ(run_solver(starved.options()), Exit::done);
  EXPECT_GT(before - bed_between(starved.snapshot_at(8), 0, 0.3), 0.6 * carried / 2);
}

TEST(BedLoadOfInlets, ComesInAtAFixedRate) {
  // 1e-4 m^2/s of grains fill 1.67e-4 m^2 of the bed a second: a particle of 1e-4 m^2 crosses the plane each 0.6 s, the
  // first after half of that.
  test::CaseRun run("bed_fixed");
  run.fill_from(fed_scene, {"inlet.west.bed_load=fixed", "inlet.west.bed_load_rate=1e-4 m^2/s", "output.end=3 s"});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const double particle = bed_density * 1e-4;
  EXPECT_NEAR(column(run, "west_sediment", "kg").back(), 5 * particle, 1e-6 * particle);
}

TEST(BedLoadOfInlets, ComesBackFromTheOutlets) {
  test::CaseRun run("bed_recirculated");
  run.fill_from(fed_scene, {"inlet.west.bed_load=recirculated", "output.end=12 s"});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const double in = column(run, "west_sediment", "kg").back();
  const double out = -column(run, "east_sediment", "kg").back();
  const double particle = bed_density * 1e-4;
  EXPECT_GT(out, 2.5 * particle);
  EXPECT_NEAR(in, out, 2.5 * particle);  // one is on its way for half a second; each passes as a whole
}

TEST(BedLoadOfInlets, ContinuesBitForBit) {
  const std::vector<std::string> options = {"output.end=\"1.2 s\"", "output.interval=\"0.2 s\"",
                                            "inlet.west.bed_load=\"fixed\"", "inlet.west.bed_load_rate=\"2e-4 m^2/s\""};
  test::TwoEnds ends;
  ASSERT_NO_FATAL_FAILURE(test::run_with_a_break(fed_scene, options, "0.8 s", ends));
  test::expect_equal_ends(ends, {"Openings", "Population"});
}

TEST(BedLoadOfInlets, NeedsGroundAndABed) {
  test::CaseRun run("bed_without_ground");
  EXPECT_THAT([&] { run.fill_from(fed_scene, {"shape.west_end.to=[\"0 m\", \"0.04 m\"]"}); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("0 of 6 particles of ground lie under its zone")));
  EXPECT_THAT([&] { run.fill_from(fed_scene, {"shape.bed.from=[\"0.05 m\", \"0 m\"]"}); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("no bed begins at its plane")));
}

}  // namespace
}  // namespace thalweg
