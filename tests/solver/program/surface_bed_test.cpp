#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "case/models/grains.hpp"
#include "common/error.hpp"
#include "physics/bed/grains.hpp"
#include "physics/transport/rouse.hpp"
#include "physics/water/log_profile.hpp"
#include "solver/models/surface_bed/arrays.hpp"
#include "solver/models/surface_bed/make_bed_rows.hpp"
#include "tests/solver/program/broken_run.hpp"

// A bed that is a surface, in whole runs: at rest, at the law's rate, around a pier, across a restart.
namespace thalweg {
namespace {

std::string scene(const std::string& name) {
  return THALWEG_SOURCE_DIR "/tests/solver/program/surface_bed/" + name + ".toml";
}

double last(const test::CaseRun& run, const std::string& name, const std::string& unit) {
  return CsvTable::read(run.folder().history()).numbers(name, unit).back();
}

/// Level of the bed's surface over each place of the ground [m].
std::map<std::pair<long, long>, double> levels(const ParticleSet& particles) {
  std::map<std::pair<long, long>, double> found;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.type[i] != ParticleType::sediment) continue;
    const Vec3& x = particles.position[i];
    const double dp = particles.info.spacing;
    const std::pair place(std::lround(x.x() / dp - 0.5), std::lround(x.y() / dp - 0.5));
    const auto known = found.find(place);
    if (known == found.end() || known->second < x.z() + 0.5 * dp) found[place] = x.z() + 0.5 * dp;
  }
  return found;
}

TEST(SurfaceBedRun, NothingMovesBelowTheThreshold) {
  test::CaseRun run("surface_rest");
  // u* = 44 mm/s over grains of 4 mm: theta = 0.030, threshold 0.047.
  run.fill_from(scene("channel"), {"materials.sand.grain_diameter=\"4 mm\"", "surface_bed.factor=1000"});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  EXPECT_EQ(last(run, "bed_lowest", "m"), 0);
  EXPECT_EQ(last(run, "bed_highest", "m"), 0);
  EXPECT_GT(last(run, "bed_time", "s"), 1000);
  // The bed drags as a wall of its roughness: the mean velocity of the logarithmic law.
  const double mean = log_profile(0.044, 0.1 * std::exp(-1.0), 1e-6, 0.001);
  EXPECT_NEAR(last(run, "bulk_velocity", "m/s"), mean, 0.03 * mean);
}

TEST(SurfaceBedRun, MovesGrainsAtTheRateOfTheLaw) {
  test::CaseRun run("surface_between");
  run.fill_from(scene("between"), {});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  // A discharge of 0.0655 m^2/s over ks = 1 mm. It is 0.1 m deep at the tail and some 3 mm deeper at the inlet, as much as
  // friction takes along the flume, S/(1 - Fr^2) with S = u*^2/(g h).
  const CsvTable history = CsvTable::read(run.folder().history());
  const auto level = history.numbers("west_level", "m");
  double depth = 0;
  for (std::size_t i = level.size() / 2; i < level.size(); ++i) {
    depth += (level[i] - 0.04) / static_cast<double>(level.size() - level.size() / 2);
  }
  EXPECT_NEAR(depth, 0.1027, 0.0015);
  Grains sand;
  sand.density = 2650, sand.diameter = 0.001, sand.porosity = 0.4, sand.tan_friction = std::tan(0.5585);
  sand.critical_shields = 0.047, sand.water_density = 1000, sand.water_viscosity = 1e-6, sand.gravity = 9.81;
  const auto law_at = [&sand](double of_depth) {
    const double friction = friction_velocity_of_current(0.0655 / of_depth, of_depth, 1e-6, 0.001);
    const BedStress stress = bed_stress_of(sand, friction, 1, 0);
    return bed_load_of(sand, stress, stress.flat_critical);
  };
  const double time = last(run, "bed_time", "s");
  EXPECT_NEAR(last(run, "bed_fed", "m^3") / time, law_at(depth), 0.1 * law_at(depth));
  EXPECT_NEAR(last(run, "bed_left", "m^3") / time, law_at(0.1), 0.5 * law_at(0.1));  // the water speeds up there
  const double before = 0.6 * 0.04 * 1.0;
  EXPECT_NEAR(last(run, "bed_grains", "m^3") + last(run, "bed_left", "m^3") - last(run, "bed_fed", "m^3"), before,
              1e-9 * before);
  EXPECT_NEAR(last(run, "bed_lowest", "m"), 0.04, 0.002);
}

TEST(SurfaceBedRun, ClearWaterFeedsNothing) {
  test::CaseRun run("surface_clear");
  run.fill_from(scene("between"), {"surface_bed.feed=\"none\"", "output.end=\"3 s\""});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  EXPECT_EQ(last(run, "bed_fed", "m^3"), 0);
  const auto level = levels(run.snapshot_at(3));
  EXPECT_LT(level.begin()->second, 0.0395);  // the bed's first column sinks, the middle stays
  EXPECT_NEAR(level.at({50, level.begin()->first.second}), 0.04, 2e-4);
}

// Rows for grains to come lie in the ground of bare floors. Surfaces found in files would be raised by their mass.
TEST(SurfaceBedRun, BareFloorsStayAsTheyAre) {
  test::CaseRun run("surface_bare");
  run.fill_from(scene("between"), {"output.end=\"0.1 s\""});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const ParticleSet particles = run.snapshot_at(0.1);
  const double dp = particles.info.spacing;
  std::map<std::pair<long, long>, std::pair<int, double>> walls;  // number and mass [kg] at each place
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.type[i] != ParticleType::wall) continue;
    const Vec3& x = particles.position[i];
    auto& [number, mass] = walls[{std::lround(x.x() / dp - 0.5), std::lround(x.z() / dp - 0.5)}];
    ++number;
    mass += double(particles.mass[i]);
  }
  int shared = 0;
  for (const auto& [place, of] : walls) {
    shared += of.first > 1;
    EXPECT_NEAR(of.second, 1000 * dp * dp, 1e-4 * 1000 * dp * dp) << place.first << " " << place.second;
  }
  EXPECT_GT(shared, 10);
}

TEST(SurfaceBedRun, ContinuedIsTheSameBitForBit) {
  test::TwoEnds ends;
  ASSERT_NO_FATAL_FAILURE(
      test::run_with_a_break(scene("hump"), {"output.end=\"1 s\"", "output.interval=\"0.25 s\""}, "0.5 s", ends));
  EXPECT_EQ(ends.straight.doubles, ends.joined.doubles);
  EXPECT_EQ(ends.straight.facts.at("SurfaceBed"), ends.joined.facts.at("SurfaceBed"));
  EXPECT_GT(last(ends.straight_run, "bed_steps", "-"), 3);
}

TEST(SurfaceBedRun, WithSuspendedGrainsContinuedIsTheSameBitForBit) {
  test::TwoEnds ends;
  ASSERT_NO_FATAL_FAILURE(
      test::run_with_a_break(scene("hump"),
                             {"output.end=\"1 s\"", "output.interval=\"0.25 s\"", "suspended_load.carried_by=\"water\"",
                              "materials.sand.grain_diameter=\"0.2 mm\""},
                             "0.5 s", ends));
  EXPECT_EQ(ends.straight.doubles, ends.joined.doubles);
  EXPECT_EQ(ends.straight.facts.at("SurfaceBed"), ends.joined.facts.at("SurfaceBed"));
  EXPECT_NE(last(ends.straight_run, "bed_lifted", "m^3"), 0);
}

TEST(SurfaceBedRun, GrainsThatSettleRaiseTheBed) {
  test::CaseRun run("surface_settling");
  run.fill_from(scene("settling"), {});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const double settled = 0.01 * 0.1 * 0.1;  // [m^2]
  const CsvTable history = CsvTable::read(run.folder().history());
  const auto grains = history.numbers("bed_grains", "m^3");
  const auto lifted = history.numbers("bed_lifted", "m^3");
  const auto suspended = history.numbers("suspended_mass", "kg");
  EXPECT_NEAR(suspended.front(), 2650 * settled, 0.02 * 2650 * settled);
  EXPECT_LT(suspended.back(), 3e-3 * suspended.front());
  const double before = 0.6 * 0.03 * 0.1;
  const double in_window = 2e-3 * settled;  // that the bed takes at its next step
  EXPECT_NEAR(grains.back() + suspended.back() / 2650, grains.front() + suspended.front() / 2650, in_window);
  for (std::size_t n = 0; n < grains.size(); ++n) EXPECT_NEAR(grains[n] + lifted[n], before, 1e-9 * before);
  EXPECT_NEAR(last(run, "bed_lowest", "m"), settled / 0.1 / 0.6, 0.02 * settled / 0.1 / 0.6);
  EXPECT_NEAR(last(run, "bed_highest", "m"), settled / 0.1 / 0.6, 0.02 * settled / 0.1 / 0.6);
}

const std::vector<std::string> fine_sand_in_suspension = {"suspended_load.carried_by=\"water\"",
                                                          "materials.sand.grain_diameter=\"0.2 mm\"",
                                                          "inlet.west.grains=\"equilibrium\""};

// The inlet brings what the bed in front of it holds: the bed gives no more than a twentieth of that, and takes no more.
// The current is slow, so that its depth falls by 0.7 % along the bed, and what it can carry hardly rises. All grains that
// come in go out, or lie in the bed: what is in the water stays as it is to the hundredth.
TEST(SurfaceBedRun, AnInletBringsTheGrainsThatTheBedHolds) {
  test::CaseRun run("surface_inlet");
  std::vector<std::string> settings = fine_sand_in_suspension;
  settings.insert(settings.end(),
                  {"materials.sand.grain_diameter=\"0.15 mm\"", "flow.discharge=\"0.04 m^2/s\"",
                   "inlet.west.discharge=\"0.04 m^2/s\"", "surface_bed.factor=1", "output.end=\"8 s\""});
  run.fill_from(scene("between"), settings);
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const CsvTable history = CsvTable::read(run.folder().history());
  const auto brought = history.numbers("west_grains", "kg");
  const auto lifted = history.numbers("bed_lifted", "m^3");
  const auto left = history.numbers("east_grains", "kg");
  const auto carried = history.numbers("suspended_mass", "kg");
  const std::size_t half = brought.size() / 2;
  const double in = brought.back() - brought[half];
  const double from_bed = (lifted.back() - lifted[half]) * 2650;
  EXPECT_GT(in, 0.02);
  EXPECT_LT(std::abs(from_bed), 0.05 * in);
  EXPECT_NEAR(in + from_bed + left.back() - left[half], carried.back() - carried[half], 0.01 * in);
}

TEST(SurfaceBedRun, WithGrainsOfAnInletContinuedIsTheSameBitForBit) {
  test::TwoEnds ends;
  std::vector<std::string> settings = fine_sand_in_suspension;
  settings.insert(settings.end(),
                  {"surface_bed.spin_up=\"0.1 s\"", "output.end=\"1 s\"", "output.interval=\"0.25 s\""});
  ASSERT_NO_FATAL_FAILURE(test::run_with_a_break(scene("between"), settings, "0.5 s", ends));
  EXPECT_EQ(ends.straight.doubles, ends.joined.doubles);
  EXPECT_EQ(ends.straight.facts.at("SurfaceBed"), ends.joined.facts.at("SurfaceBed"));
  EXPECT_EQ(ends.straight.facts.at("Openings"), ends.joined.facts.at("Openings"));
}

TEST(SurfaceBedRun, EndsAtTheBedsTimeAndShowsTheTimesAskedFor) {
  test::CaseRun run("surface_end");
  run.fill_from(scene("channel"), {"surface_bed.end=\"12 s\"", "compare.bed_times=[\"5 s\", \"9 s\"]"});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const CsvTable history = CsvTable::read(run.folder().history());
  const auto bed = history.numbers("bed_time", "s");
  const auto water = history.numbers("time", "s");
  EXPECT_GE(bed.back(), 12);
  EXPECT_LT(bed.back(), 12 + 2 * 10 * 0.1);  // a window of 0.1 s and its motion, ten times as fast
  EXPECT_LT(water.back(), 3);                // of the four that output.end allows
  std::vector<double> shown;
  for (const SeriesEntry& entry : read_series(run.folder().snapshot_series())) shown.push_back(entry.time);
  for (const double wanted : {5.0, 9.0, 12.0}) {
    const auto row = std::lower_bound(bed.begin(), bed.end(), wanted) - bed.begin();
    const double time = water[static_cast<std::size_t>(row)];
    EXPECT_TRUE(std::any_of(shown.begin(), shown.end(), [&](double t) { return std::abs(t - time) < 1e-6; })) << wanted;
  }
  EXPECT_NEAR(shown.back(), water.back(), 1e-6);  // history.csv has nine digits
}

// In the end the current holds what Rouse's profile over the bed's reference concentration holds; also where the number of
// its particles is no multiple of the four of a cluster (0.21 m).
TEST(SurfaceBedRun, HoldsTheGrainsOfRousesProfile) {
  for (const double length : {0.2, 0.21}) {
    SCOPED_TRACE(length);
    test::CaseRun run("surface_rouse");
    std::vector<std::string> settings = {"suspended_load.carried_by=\"water\"",
                                         "materials.sand.grain_diameter=\"0.13 mm\"",
                                         "materials.sand.critical_shields=0.6",
                                         "surface_bed.factor=1",
                                         "output.end=\"24 s\"",
                                         "output.interval=\"8 s\""};
    const auto ends_at = [&](const char* what, const char* top) {
      settings.push_back(fmt::format("{}.to=[\"{} m\", \"{} m\"]", what, length, top));
    };
    ends_at("domain", "0.2"), ends_at("shape.floor", "-0.05"), ends_at("shape.bed", "0"), ends_at("shape.water", "0.1");
    run.fill_from(scene("channel"), settings);
    ASSERT_EQ(run_solver(run.options()), Exit::done);
    const Grains sand = grains_of(run.scene());
    const double friction = std::sqrt(9.81 * 0.1 * 0.00197);
    const double reference = reference_concentration(sand, friction, sand.settling(0));
    double exact = 0;  // [m] of grains
    constexpr int layers = 10000;
    for (int n = 0; n < layers; ++n) {
      const double z = 0.001 + (0.1 - 0.001) * (n + 0.5) / layers;
      exact += reference * rouse_share(z, 0.001, 0.1, friction, sand.settling(0)) * (0.1 - 0.001) / layers;
    }
    const CsvTable history = CsvTable::read(run.folder().history());
    const auto suspended = history.numbers("suspended_mass", "kg");
    const double held = suspended.back() / 2650 / length;
    EXPECT_NEAR(held, exact, 0.08 * exact);
    EXPECT_NEAR(suspended[suspended.size() * 3 / 4], suspended.back(), 0.05 * suspended.back());
    EXPECT_NEAR(last(run, "bed_lifted", "m^3"), length * held, 0.01 * length * held);
  }
}

TEST(SurfaceBedRun, APierIsScouredAtItsFlanksAndGrainsAreKept) {
  test::CaseRun run("surface_pier");
  run.fill_from(scene("pier"), {});
  const double before = 0.6 * 0.06 * (0.5 * 0.2);
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  EXPECT_LT(last(run, "bed_grains", "m^3"), before);  // the pier stands in part of the bed
  const CsvTable history = CsvTable::read(run.folder().history());
  const auto grains = history.numbers("bed_grains", "m^3");
  EXPECT_NEAR(grains.back(), grains.front(), 1e-9 * grains.front());
  const auto level = levels(run.snapshot_at(1));
  double deepest = 0;
  std::pair<long, long> at;
  for (const auto& [place, z] : level) {
    if (z < deepest) deepest = z, at = place;
  }
  EXPECT_LT(deepest, -0.002);
  // Beside the pier, which stands at x = 0.2, y = 0.1 m with a radius of 0.03 m; not behind it.
  EXPECT_NEAR(0.01 * (double(at.first) + 0.5), 0.19, 0.035);
  EXPECT_GT(std::abs(0.01 * (double(at.second) + 0.5) - 0.1), 0.015);
}

TEST(SurfaceBedRows, APipeIsACeilingAndASolidWallNoColumn) {
  test::CaseRun run("surface_rows");
  run.fill_from(scene("hump"), {});
  ParticleSet particles = run.start();
  const std::size_t sediment =
      static_cast<std::size_t>(std::count(particles.type.begin(), particles.type.end(), ParticleType::sediment));
  const LaidBed laid = lay_bed(run.scene(), particles);
  double thickness = 0;
  int under_pipe = 0;
  for (int c = 0; c < laid.columns.grid.columns(); ++c) {
    if (laid.columns.ceiling[GrainColumns::at(c)] < 1) ++under_pipe;
    thickness += laid.columns.level(c) - laid.columns.floor[GrainColumns::at(c)];
  }
  EXPECT_NEAR(thickness, 0.01 * static_cast<double>(sediment), 1e-9);
  EXPECT_EQ(under_pipe, 4);  // a pipe of 40 mm
  EXPECT_TRUE(laid.columns.grid.periodic_x);
  ASSERT_TRUE(particles.doubles.contains(field::bed_place.name));
  EXPECT_EQ(particles.doubles.at(field::bed_place.name).size(), 4 * particles.size());
}

TEST(SurfaceBedRows, HangingSedimentIsRefused) {
  test::CaseRun run("surface_hanging");
  run.fill_from(scene("hump"), {});
  ParticleSet particles = run.start();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.type[i] == ParticleType::water && particles.position[i].z() > 0.08) {
      particles.type[i] = ParticleType::sediment;
      break;
    }
  }
  EXPECT_THROW(lay_bed(run.scene(), particles), InputError);
}

}  // namespace
}  // namespace thalweg
