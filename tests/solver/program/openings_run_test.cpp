#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <numbers>

#include "common/error.hpp"
#include "physics/water/log_profile.hpp"
#include "solver/models/openings/flow.hpp"
#include "solver/models/openings/make_zone.hpp"
#include "tests/solver/case_run.hpp"
#include "tests/solver/program/broken_run.hpp"
#include "tests/solver/program/row_speeds.hpp"
#include "tests/solver/program/trend.hpp"
#include "tests/solver/program/wall_jet.hpp"

// Water that enters and leaves, in whole runs: a uniform current, a free fall, jets, a pump, and runs that must stop.
namespace thalweg {
namespace {

std::string scene(const std::string& name) {
  return THALWEG_SOURCE_DIR "/tests/solver/program/openings/" + name + ".toml";
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

/// Root of the mean square of the deviation from the mean.
double scatter_of(const std::vector<double>& values) {
  const double mean = mean_of(values);
  std::vector<double> squares;
  for (const double v : values) squares.push_back((v - mean) * (v - mean));
  return std::sqrt(mean_of(squares));
}

/// A column of history.csv from a time [s] on.
struct Column {
  std::vector<double> time;
  std::vector<double> value;

  [[nodiscard]] double mean() const { return mean_of(value); }
  [[nodiscard]] double rate() const { return test::trend(time, value, 0); }
};

Column column(const test::CaseRun& run, const std::string& name, const std::string& unit, double from) {
  const CsvTable history = CsvTable::read(run.folder().history());
  const auto t = history.numbers("time", "s");
  const auto v = history.numbers(name, unit);
  Column kept;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (t[i] >= from) kept.time.push_back(t[i]), kept.value.push_back(v[i]);
  }
  return kept;
}

/// Water that is there, less what came in, plus what went out [kg]: at the first and at the last row.
std::pair<double, double> balance(const test::CaseRun& run) {
  const CsvTable history = CsvTable::read(run.folder().history());
  const auto water = history.numbers("water_mass", "kg");
  const auto in = history.numbers("mass_in", "kg");
  const auto out = history.numbers("mass_out", "kg");
  return {water.front() - in.front() + out.front(), water.back() - in.back() + out.back()};
}

/// Mean speed [m/s] of the rows of water over a floor [m], from a time [s] on, away from the openings.
std::vector<double> speeds_of_rows(const test::CaseRun& run, double from, double floor) {
  return test::row_speeds(test::snapshots_from(run, from), run.scene().numerics.spacing, {0.1, 0.95, floor});
}

TEST(OpenChannel, KeepsLevelAndDischarge) {
  test::CaseRun run("open_channel");
  run.fill_from(scene("channel"), {"output.end=\"16 s\"", "output.history_interval=\"0.1 s\""});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  // 0.04 m^2/s of water that weighs 1000 kg/m^3 and is compressed by 1.2e-3 in the mean, 490 Pa over rho c^2.
  const double entering = 40 * (1 + 490 / (1000 * 19.81 * 19.81));
  EXPECT_NEAR(column(run, "west_water", "kg", 4).rate(), entering, 0.005 * entering);
  EXPECT_NEAR(-column(run, "east_water", "kg", 4).rate(), entering, 0.005 * entering);
  for (const char* name : {"west_level", "east_level"}) {
    EXPECT_NEAR(column(run, name, "m", 4).mean(), 0.1, 0.5 * 0.01) << name;
  }
  const auto [first, last] = balance(run);
  EXPECT_NEAR(last, first, 1e-6 * first);

  // Velocity and pressure in the middle, from 8 s on: the inlet's profile, and no suction at the outlet.
  double below = 0;
  double snapshots = 0;
  for (const SeriesEntry& e : read_series(run.folder().snapshot_series())) {
    if (e.time < 8) continue;
    const ParticleSet p = read_particles(run.folder().root / e.file);
    double most = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Vec3& x = p.position[i];
      if (p.type[i] != ParticleType::water || x.x() < 0.1 || x.x() > 0.95) continue;
      most = std::max(most, 9810 * (0.1 - x.z()) - double(p.pressure[i]));
    }
    below += most, snapshots += 1;
  }
  const std::vector<double> speeds = speeds_of_rows(run, 8, 0);
  const double friction = friction_velocity_of_current(0.4, 0.1, 1e-6, 1e-3);
  double squares = 0;
  for (std::size_t row = 0; row < 10; ++row) {
    const double z = (static_cast<double>(row) + 0.5) * 0.01;
    squares += std::pow(speeds[row] - log_profile(friction, z, 1e-6, 1e-3), 2) / 10;
  }
  EXPECT_LT(std::sqrt(squares), 0.03 * 0.4);
  EXPECT_LT(below / snapshots,
            0.1 * 981);  // of single particles at rest in their rows; a suction would be of the order of p
}

// Cells of the lattice end at -2 mm, 8 mm, …: the lower edge goes to the nearest. A round opening stays, and so does the
// side along which the domain repeats itself.
TEST(Openings, StandOnTheCellsOfTheLattice) {
  Case of;
  of.info.dimension = 3;
  of.numerics.spacing = 0.01;
  Inlet inlet;
  inlet.at = Vec3(0, 0.1, 0.1);
  inlet.direction = Vec3::UnitX();
  inlet.height = inlet.width = 0.2;
  const Vec3 node(0, 0.004, 0.003);
  const Zone zone = make_zone(inlet, of, node);
  EXPECT_NEAR(zone.at[2] - zone.half_up, -0.002, 1e-12);
  EXPECT_NEAR(zone.at[1] - zone.half_across, -0.001, 1e-12);
  EXPECT_EQ(zone.at[0], 0);
  of.domain.periodic = {"y"};
  EXPECT_EQ(make_zone(inlet, of, node).at[1], 0.1);
  EXPECT_EQ(make_zone(inlet, of, std::nullopt).at[2], 0.1);
  inlet.height = inlet.width = 0;
  inlet.diameter = 0.2;
  EXPECT_EQ(make_zone(inlet, of, node).at[2], 0.1);
}

// Behind the zone of an outlet leave water in its section, and grains that slide on the floor, half in it.
// A bed under a fall stays, but for the grains that move.
TEST(Openings, TakeGrainsOnTheFloorBehindAnOutlet) {
  Zone zone;
  zone.flow[0] = zone.up[2] = 1;
  zone.half_up = 0.1;
  zone.half_across = 1;
  zone.length = 0.066;
  zone.spacing = 0.01;
  Record record{};
  Position position{};
  const Role role = Role::integrated;
  const auto leaves = [&](double along, double up, bool is_grain, float grain = kind::deposit) {
    record.kind = is_grain ? grain : kind::water;
    position.x[0] = along;
    position.x[2] = up;
    return LeavesThrough{&record, &position, &role, &zone, nullptr, is_grain}(0);
  };
  EXPECT_TRUE(leaves(0.06, 0, true));
  EXPECT_TRUE(leaves(0.06, -0.105, true));
  EXPECT_FALSE(leaves(0.05, -0.105, true));
  EXPECT_FALSE(leaves(0.06, -0.115, true));
  EXPECT_TRUE(leaves(0.06, 0, false));
  EXPECT_FALSE(leaves(0.06, -0.105, false));
  zone.falls = true;
  EXPECT_TRUE(leaves(0.01, -0.105, false));
  EXPECT_FALSE(leaves(0.01, -0.105, true));
  EXPECT_TRUE(leaves(0.01, -0.105, true, kind::bed_load));
  EXPECT_TRUE(leaves(0.01, -0.105, true, kind::suspended));
  EXPECT_FALSE(leaves(0.01, -0.115, true, kind::bed_load));
}

// A floor whose lattice lies a third of a spacing higher than its shape: the water comes in on it, not within it.
TEST(OpenChannel, EntersOnTheLatticeOfItsFloor) {
  for (const char* spacing : {"20 mm", "10 mm"}) {
    SCOPED_TRACE(spacing);
    test::CaseRun run("open_beside_lattice");
    const double shift = std::string(spacing) == "10 mm" ? 0.0033 : 0.0067;  // a third of the spacing
    run.fill_from(scene("channel"), {std::string("numerics.spacing=\"") + spacing + "\"",
                                     "domain.from=[\"-0.2 m\", \"" + std::to_string(shift - 0.1) + " m\"]",
                                     "output.end=\"6 s\"", "output.interval=\"0.5 s\""});
    ASSERT_EQ(run_solver(run.options()), Exit::done);
    const std::vector<double> speeds = speeds_of_rows(run, 3, shift);
    const double friction = friction_velocity_of_current(0.4, 0.1, 1e-6, 1e-3);
    const double lowest = log_profile(friction, 0.5 * run.scene().numerics.spacing, 1e-6, 1e-3);
    EXPECT_NEAR(speeds.front(), lowest, 0.08 * lowest);
  }
}

TEST(OpenChannel, TakesALevelBetweenTwoRows) {
  // Ten and a half rows of water. With whole rows only, the level beside the inlet went up and down by 2.7 mm and the
  // speed over the floor behind it by 2.9 %.
  test::CaseRun run("open_between_rows");
  run.fill_from(scene("channel"), {"outlet.east.level=\"0.105 m\"", "output.end=\"16 s\"", "output.interval=\"0.25 s\"",
                                   "output.history_interval=\"0.1 s\""});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const double entering = 40 * (1 + 515 / (1000 * 19.81 * 19.81));
  EXPECT_NEAR(column(run, "west_water", "kg", 6).rate(), entering, 0.002 * entering);
  const Column level = column(run, "west_level", "m", 6);
  EXPECT_NEAR(level.mean(), 0.105, 0.0015);
  EXPECT_LT(scatter_of(level.value), 0.0015);
  std::vector<double> lowest;
  for (const ParticleSet& p : test::snapshots_from(run, 6)) {
    lowest.push_back(test::row_speeds({p}, run.scene().numerics.spacing, {0, 0.1, 0}).front());
  }
  const double friction = friction_velocity_of_current(0.04 / level.mean(), level.mean(), 1e-6, 1e-3);
  const double law = log_profile(friction, 0.005, 1e-6, 1e-3);
  EXPECT_NEAR(mean_of(lowest), law, 0.03 * law);
  EXPECT_LT(scatter_of(lowest), 0.02 * law);
}

TEST(OpenChannel, FollowsAHydrograph) {
  // From 0.03 to 0.05 m^2/s between 2 and 4 s, and the tail water by 30 mm. The level of the outlet gives way to
  // the wave that this makes, and returns within 3 s: seven seconds later what enters leaves.
  test::CaseRun run("open_hydrograph");
  run.fill_from(scene("hydrograph"), {"output.end=\"17 s\""});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  EXPECT_NEAR(column(run, "west_water", "kg", 11).rate(), 50, 0.01 * 50);
  // The sum that has come in is the hydrograph's area, 2 s x 30 + 2 s x 40 + 13 s x 50 kg/s, whatever the level does;
  // water under half of 0.1 to 0.13 m is compressed by 1.2e-3 to 1.6e-3.
  EXPECT_NEAR(column(run, "west_water", "kg", 0).value.back(), 790 * 1.0015, 0.004 * 790);
  EXPECT_NEAR(-column(run, "east_water", "kg", 11).rate(), 50, 0.02 * 50);
  EXPECT_NEAR(column(run, "east_level", "m", 11).mean(), 0.13, 0.005);
  EXPECT_NEAR(column(run, "west_level", "m", 11).mean(), 0.13, 0.005);
}

/// Rise [m] of the water between heap and inlet, largest: of the heap's wave that runs upstream, and later of what the inlet
/// has thrown back. The wave passes the gauge after 0.4 m / 0.8 m/s, the inlet after 1 m / 0.8 m/s, and with 1.2 m/s the
/// gauge again, at 1.75 s; it is 0.4 m long.
std::pair<double, double> waves_at_inlet(const std::string& absorbs) {
  test::CaseRun run("open_wave");
  run.fill_from(scene("wave"), {"inlet.west.absorbs_waves=" + absorbs});
  EXPECT_EQ(run_solver(run.options()), Exit::done);
  const CsvTable gauges = CsvTable::read(run.folder().gauges());
  const auto t = gauges.numbers("time", "s");
  const auto level = gauges.numbers("between.level", "m");
  std::pair<double, double> largest{0, 0};
  for (std::size_t i = 0; i < t.size(); ++i) {
    double& most = t[i] < 1.1 ? largest.first : largest.second;
    if (t[i] < 1.1 || t[i] > 1.5) most = std::max(most, level[i] - 0.1);
  }
  return largest;
}

TEST(OpenChannel, LetsAWaveOutThroughAnInletThatAbsorbsIt) {
  const auto [came, returned] = waves_at_inlet("true");
  const auto [came_again, thrown_back] = waves_at_inlet("false");
  EXPECT_GT(came, 0.008);  // half of the heap each way, and its front steepens
  EXPECT_GT(thrown_back, 0.5 * came_again);
  EXPECT_LT(returned, 0.35 * came);
}

TEST(OpenChannel, ContinuesBitForBit) {
  const std::vector<std::string> options = {"output.end=\"3 s\"", "output.interval=\"0.5 s\"",
                                            "inlet.west.absorbs_waves=true"};
  test::TwoEnds ends;
  ASSERT_NO_FATAL_FAILURE(test::run_with_a_break(scene("hydrograph"), options, "2.5 s", ends));
  test::expect_equal_ends(ends, {"Openings", "Population"});
}

TEST(OpenChannel, StandsStillWithoutAnInflow) {
  // A tail water at the level of still water: nothing moves in or out.
  test::CaseRun run("open_still");
  run.fill_from(scene("still"), {});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const CsvTable history = CsvTable::read(run.folder().history());
  const auto out = history.numbers("mass_out", "kg");
  const auto water = history.numbers("water_mass", "kg");
  EXPECT_LE(out.back(), 0.01 * water.front());  // one column of particles, if that
  EXPECT_NEAR(column(run, "east_level", "m", 2).mean(), 0.1, 0.005);
}

TEST(OpenChannel, LeavesABedAtRestThatTheCurrentCannotMove) {
  test::CaseRun run("open_bed");
  run.fill_from(scene("bed"), {});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  std::map<std::int64_t, Vec3> before;
  for (std::size_t i = 0; i < run.start().size(); ++i) before[run.start().id[i]] = run.start().position[i];
  const ParticleSet end = run.snapshot_at(6);
  double farthest = 0;
  int sediment = 0;
  for (std::size_t i = 0; i < end.size(); ++i) {
    if (end.type[i] != ParticleType::sediment) continue;
    ++sediment;
    // Beside the upright ends of the bed it settles by a third of a spacing in the first four seconds.
    const double x = before.at(end.id[i]).x();
    const double moved = (end.position[i] - before.at(end.id[i])).norm();
    if (x < 0.05 || x > 0.95) {
      EXPECT_LT(moved, 0.5 * run.scene().numerics.spacing) << "x = " << x;
      continue;
    }
    farthest = std::max(farthest, moved);
  }
  EXPECT_EQ(sediment, 400);
  EXPECT_LT(farthest, 0.01 * run.scene().numerics.spacing);
  EXPECT_NEAR(-column(run, "east_water", "kg", 3).rate(), 36.9, 0.02 * 36.9);
}

TEST(Overfall, DrawsTheWaterDownToItsBrink) {
  // Rouse (1936) measured 0.715 of the critical depth at the brink of a smooth level channel, which is reached three to
  // four critical depths upstream: here 54.6 mm. The column next to the outlet counts 66 mm of water before it.
  test::CaseRun run("overfall");
  run.fill_from(scene("overfall"), {"output.end=\"14 s\""});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const double critical = std::cbrt(0.04 * 0.04 / 9.81);
  const double brink = column(run, "east_level", "m", 8).mean() / critical;
  EXPECT_GT(brink, 0.715);
  EXPECT_LT(brink, 0.9);
  EXPECT_NEAR(-column(run, "east_water", "kg", 8).rate(), 40, 0.02 * 40);
}

TEST(Jets, FallAsProjectilesDo) {
  // z = z0 + x tan a - g x^2/(2 u^2 cos^2 a): the axis of a jet through air, of any thickness, without friction.
  test::CaseRun run("jets");
  run.fill_from(scene("jets"), {});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const ParticleSet p = run.snapshot_at(0.6);
  const auto axis_at = [&](double x, double expected) {
    double sum = 0;
    double number = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Vec3& at = p.position[i];
      if (p.type[i] != ParticleType::water || std::abs(at.x() - x) > 0.01 || std::abs(at.z() - expected) > 0.05)
        continue;
      sum += at.z(), number += 1;
    }
    EXPECT_GT(number, 15);
    return sum / number;
  };
  for (const double x : {0.1, 0.2, 0.3}) {
    const double level = 0.2 - 9.81 * x * x / (2 * 1.5 * 1.5);
    EXPECT_NEAR(axis_at(x, level), level, 0.0125) << x;
    const double upwards = -0.1 + x - 9.81 * x * x / (2 * 2.0);
    EXPECT_NEAR(axis_at(x, upwards), upwards, 0.0125) << x;
  }
  // Volume per time is the opening's height times the speed, whatever the direction.
  EXPECT_NEAR(column(run, "level_water", "kg", 0.1).rate(), 60, 0.5);
  EXPECT_NEAR(column(run, "upwards_water", "kg", 0.1).rate(), 80, 0.7);
}

TEST(WallJet, SlowsDownAsMeasured) { test::expect_a_jet_that_slows_down_as_measured("5 mm"); }

TEST(Nozzle, BringsItsAreaTimesItsVelocity) {
  // pi/4 (50 mm)^2 times 1 m/s: 1.9635 kg/s until 0.3 s.
  test::CaseRun run("nozzle");
  run.fill_from(scene("nozzle"), {"output.end=\"0.3 s\""});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const Column water = column(run, "nozzle_water", "kg", 0);
  // A layer of particles is 0.0196 kg.
  const double duration = water.time.back() - water.time.front();
  EXPECT_GT(duration, 0.2);
  EXPECT_NEAR(water.value.back() - water.value.front(), 1.9635 * duration, 0.025);
}

TEST(Pump, KeepsTheWater) {
  test::CaseRun run("pump");
  run.fill_from(scene("pump"), {"output.end=\"12 s\"", "output.history_interval=\"0.1 s\""});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const Column water = column(run, "water_mass", "kg", 0.5);
  // Particles leave by columns, of 1 kg each; apart from that the water stays.
  for (const double mass : water.value) EXPECT_NEAR(mass, water.value.front(), 1.5);
  EXPECT_LT(std::abs(column(run, "water_mass", "kg", 4).rate()) * 8, 0.005 * water.value.front());
  EXPECT_NEAR(column(run, "west_water", "kg", 4).rate(), 40, 0.01 * 40);
}

TEST(OpenBoundaries, StopWhereTheLevelRunsAway) {
  test::CaseRun run("runaway");
  run.fill_from(scene("basin"), {});
  try {
    run_solver(run.options());
    FAIL() << "ran to the end";
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("the water at west stands at z = "));
    EXPECT_THAT(error.what(), testing::HasSubstr("above the opening: its level runs away"));
  }
  EXPECT_TRUE(std::filesystem::exists(run.folder().checkpoint()));
}

TEST(OpenBoundaries, BringGrainsBackThatWaterHasTakenOut) {
  // A concentration of 0.01 at the start; the pump brings back what it takes, so that the grains stay.
  test::CaseRun run("recirculated");
  run.fill_from(scene("grains"), {});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const CsvTable history = CsvTable::read(run.folder().history());
  const auto grains = history.numbers("grain_mass", "kg");
  const auto west = history.numbers("west_grains", "kg");
  const auto east = history.numbers("east_grains", "kg");
  EXPECT_GT(west.back(), 1);
  for (std::size_t i = 0; i < grains.size(); ++i) {
    // To rounding, from the boundaries' own books.
    EXPECT_NEAR(grains[i] - west[i] - east[i], grains[0] - west[0] - east[0], 1e-6 * grains[0]);
    // Within what lies in the pump for a second: 0.4 m/s of a channel of 1.06 m.
    EXPECT_NEAR(grains[i], grains[0], 0.45 * grains[0]);
  }
}

}  // namespace
}  // namespace thalweg
