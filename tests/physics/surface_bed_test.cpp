#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "physics/bed/advance_bed.hpp"
#include "tests/physics/sand_bed.hpp"

// The bed as a surface against exact solutions: a heap's slope, the kinematic wave of a dune and of a trench, uniform
// transport, ends.
namespace thalweg {
namespace {

using test::bed_of;
using test::sand;

/// Friction velocity of a Shields number.
double friction_velocity_at(const Grains& of, double shields) {
  return std::sqrt(shields * (of.density / of.water_density - 1) * of.gravity * of.diameter);
}

double bed_load_at(const Grains& of, double shields) {
  const BedStress stress = bed_stress_of(of, friction_velocity_at(of, shields), 1, 0);
  return bed_load_of(of, stress, stress.flat_critical);
}

// A column of grains set free becomes a cone of the angle of repose in every direction, within half a degree.
TEST(SurfaceBed, AHeapIsAConeOfTheAngleOfRepose) {
  const Grains of = sand();
  for (const int cells : {31, 61}) {
    const double dx = 0.3 / cells;
    GrainColumns bed = bed_of(cells, cells, dx, of, 0);
    const int middle = cells / 2;
    const double volume = bed.packing * M_PI / 3 * of.tan_friction * std::pow(0.1, 3);  // of a cone of the radius 0.1 m
    // Grains fall onto the middle little by little, as from a funnel.
    const int parts = 100;
    for (int part = 0; part < parts; ++part) {
      bed.grains[static_cast<std::size_t>(middle * cells + middle)] += volume / parts;
      ASSERT_TRUE(avalanche(bed, of.tan_friction, 200000));
    }
    EXPECT_NEAR(bed.total(), volume, 1e-9 * volume);
    const auto level = [&](double angle, double radius) {
      const double x = middle + radius * std::cos(angle) / dx;
      const double y = middle + radius * std::sin(angle) / dx;
      const int i = static_cast<int>(x);
      const int j = static_cast<int>(y);
      const double fx = x - i;
      const double fy = y - j;
      const auto at = [&](int a, int b) { return bed.level(b * cells + a); };
      return (1 - fx) * ((1 - fy) * at(i, j) + fy * at(i, j + 1)) +
             fx * ((1 - fy) * at(i + 1, j) + fy * at(i + 1, j + 1));
    };
    double sum = 0;
    const int directions = 32;
    for (int k = 0; k < directions; ++k) {
      const double angle = 2 * M_PI * k / directions;
      const double slope = (level(angle, 0.02) - level(angle, 0.08)) / 0.06;
      EXPECT_NEAR(std::atan(slope) * 180 / M_PI, 32, cells > 50 ? 0.5 : 1.0) << "direction " << angle;
      sum += slope / directions;
    }
    EXPECT_NEAR(std::atan(sum) * 180 / M_PI, 32, 0.5) << cells;
  }
}

/// Level-weighted middle of a bump or trench on a flat bed of the level `flat` [m].
double middle_of(const GrainColumns& bed, double flat) {
  double sum = 0;
  double first = 0;
  for (int c = 0; c < bed.grid.columns(); ++c) {
    const double height = bed.level(c) - flat;
    sum += height;
    first += height * (c + 0.5) * bed.grid.dx;
  }
  return first / sum;
}

/// A low dune, or a shallow trench, in a current of unit discharge under a rigid lid: theta = theta_0 (H/(H - z))^2. Its
/// celerity is that of the kinematic wave, (dq/dz)/(1 - n).
double celerity_error(double amplitude, double dx) {
  const Grains of = sand();
  const double lid = 0.2;      // [m] depth
  const double shields = 0.2;  // on the flat bed
  const double flat = 0.05;    // [m]
  const double length = 1.2;   // [m]
  const auto shields_at = [&](double z) { return shields * std::pow(lid / (lid - z), 2); };
  GrainColumns bed = bed_of(static_cast<int>(std::lround(2.4 / dx)), 1, dx, of, flat);
  bed.grid.periodic_x = true;
  for (int c = 0; c < bed.grid.columns(); ++c) {
    const double x = (c + 0.5) * dx - 0.7;
    const double height = std::abs(x) < 0.5 * length ? 0.5 * amplitude * (1 + std::cos(2 * M_PI * x / length)) : 0;
    bed.grains[GrainColumns::at(c)] += bed.packing * bed.area[0] * height;
  }
  const double start = middle_of(bed, flat);
  const double before = bed.total();
  double time = 0;
  std::vector<BedStress> stress(bed.grains.size());
  while (time < 300) {
    for (int c = 0; c < bed.grid.columns(); ++c) {
      stress[GrainColumns::at(c)] = bed_stress_of(of, friction_velocity_at(of, shields_at(bed.level(c) - flat)), 1, 0);
    }
    time += advance_bed(bed, of, stress, {}, 300 - time, 0.02 * dx).time;
  }
  EXPECT_NEAR(bed.total(), before, 1e-9 * before);
  // The middle of a bump of any height moves with the mean of (q(z) - q(0))/(1 - n) over that of z.
  double flux = 0;
  double height = 0;
  for (int k = 0; k < 1000; ++k) {
    const double z = 0.5 * amplitude * (1 + std::cos(2 * M_PI * (k + 0.5) / 1000));
    flux += bed_load_at(of, shields_at(z)) - bed_load_at(of, shields);
    height += z;
  }
  const double exact = flux / height / (1 - of.porosity);
  return (middle_of(bed, flat) - start) / time / exact - 1;
}

TEST(SurfaceBed, ADuneMovesAsTheKinematicWave) {
  EXPECT_NEAR(celerity_error(0.005, 0.02), 0, 0.05);
  EXPECT_NEAR(celerity_error(0.005, 0.01), 0, 0.05);
}

TEST(SurfaceBed, ATrenchMovesAsTheKinematicWave) {
  EXPECT_NEAR(celerity_error(-0.005, 0.02), 0, 0.05);
  EXPECT_NEAR(celerity_error(-0.005, 0.01), 0, 0.05);
}

// The mesh model moves its bed with every step of the flow (foam_reference/library/eroding_bed.C), particles move theirs
// between windows. Under the same series of stresses both have the same grains, bit for bit, avalanches included.
TEST(SurfaceBed, IsTheBedOfTheMeshModelUnderTheSameStresses) {
  const Grains of = sand();
  GrainColumns mesh = bed_of(24, 16, 0.01, of, 0.1);
  const std::vector<double> start = mesh.grains;
  mesh.grains[GrainColumns::at(7 * mesh.grid.nx + 8)] *= 1.4;  // 40 mm high on 10 mm: it slides
  GrainColumns particles = mesh;
  std::vector<BedStress> stress(mesh.grains.size());
  constexpr double dt = 1e-3;  // [s]
  for (int step = 0; step < 500; ++step) {
    for (int c = 0; c < mesh.grid.columns(); ++c) {
      const double angle = 0.3 * std::sin(0.02 * step + c);
      const double shields = 0.08 + 0.05 * std::cos(0.1 * step + 0.7 * c);
      stress[GrainColumns::at(c)] =
          bed_stress_of(of, friction_velocity_at(of, shields), std::cos(angle), std::sin(angle));
    }
    const auto sent = [&](int column, int axis, bool forward) {
      return bed_load_between(mesh, of, stress[GrainColumns::at(column)], column, axis, forward);
    };
    move_bed_load(mesh, sent, dt);
    avalanche(mesh, of.tan_friction);
    ASSERT_EQ(advance_bed(particles, of, stress, {}, dt, 1).time, dt);
  }
  EXPECT_EQ(mesh.grains, particles.grains);
  const auto moved = [&](std::size_t c) { return mesh.grains[c] != start[c]; };
  int places = 0;
  for (std::size_t c = 0; c < start.size(); ++c) places += moved(c) ? 1 : 0;
  EXPECT_GT(places, 300);
}

// Grains that settle raise the bed by their volume over its packing; those that rise lower it, down to the ground.
TEST(SurfaceBed, SettlingRaisesTheBedAndRisingLowersIt) {
  const Grains of = sand();
  GrainColumns bed = bed_of(10, 1, 0.01, of, 0.05);
  const std::vector<BedStress> still(10);
  std::vector<double> settling(10, 6e-6 * 0.01);  // [m^3/s], 6 um/s
  settling[4] = -1e-4 * 0.01;
  const double before = bed.total();
  BedAdvance done = advance_bed(bed, of, still, settling, 100, 1);
  EXPECT_DOUBLE_EQ(done.time, 100);
  EXPECT_NEAR(bed.level(0), 0.051, 1e-12);
  EXPECT_NEAR(bed.level(4), 0.05 - 1e-2 / 0.6, 0.011);  // its slopes slide
  EXPECT_NEAR(bed.total() + bed.lifted, before, 1e-12 * before);
  settling.assign(10, -1e-3 * 0.01);
  done = advance_bed(bed, of, still, settling, 100, 1);
  EXPECT_DOUBLE_EQ(done.time, 100);
  for (int c = 0; c < 10; ++c) EXPECT_NEAR(bed.level(c), 0, 1e-15);
  EXPECT_NEAR(bed.lifted, before, 1e-12 * before);
}

// A column at a fed end keeps its level, and one below a body takes no more than it has room for.
TEST(SurfaceBed, SettlingStopsAtFedEndsAndBelowBodies) {
  const Grains of = sand();
  GrainColumns bed = bed_of(10, 1, 0.01, of, 0.05);
  bed.end.assign(10, BedEnd::closed);
  bed.end.front() = BedEnd::fed;
  bed.ceiling.assign(10, INFINITY);
  bed.ceiling.back() = 0.0505;
  const double before = bed.total();
  advance_bed(bed, of, std::vector<BedStress>(10), std::vector<double>(10, 6e-6 * 0.01), 100, 1);
  EXPECT_NEAR(bed.level(0), 0.05, 1e-15);
  EXPECT_NEAR(bed.level(9), 0.0505, 1e-15);
  EXPECT_NEAR(bed.level(5), 0.051, 1e-12);
  EXPECT_NEAR(bed.fed, -6e-6, 1e-18);  // what settles on the fed end is taken out there
  EXPECT_NEAR(bed.total() + bed.lifted - bed.fed, before, 1e-12 * before);
}

// A fed end takes what settles on it out of the water also where the rest of the bed is at rest.
TEST(SurfaceBed, AFedEndTakesWhatSettlesWhileTheBedIsAtRest) {
  const Grains of = sand();
  GrainColumns bed = bed_of(10, 1, 0.01, of, 0.05);
  bed.end.assign(10, BedEnd::closed);
  bed.end.front() = BedEnd::fed;
  std::vector<double> settling(10, 0.0);
  settling.front() = 6e-6 * 0.01;
  const std::vector<double> before = bed.grains;
  EXPECT_DOUBLE_EQ(advance_bed(bed, of, std::vector<BedStress>(10), settling, 100, 1).time, 100);
  EXPECT_EQ(bed.grains, before);
  EXPECT_NEAR(bed.lifted, -6e-6, 1e-18);
  EXPECT_NEAR(bed.fed, -6e-6, 1e-18);
}

// Under one stress everywhere a bed between a fed and an open end stays as it is, and what leaves is the law's.
TEST(SurfaceBed, UniformTransportLeavesTheBedAlone) {
  const Grains of = sand();
  GrainColumns bed = bed_of(40, 1, 0.01, of, 0.05);
  bed.end.assign(40, BedEnd::closed);
  bed.end.front() = BedEnd::fed;
  bed.end.back() = BedEnd::forth_x;
  const std::vector<BedStress> stress(40, bed_stress_of(of, friction_velocity_at(of, 0.15), 1, 0));
  const double before = bed.total();
  const BedAdvance done = advance_bed(bed, of, stress, {}, 100, 1);
  EXPECT_DOUBLE_EQ(done.time, 100);
  for (int c = 0; c < 40; ++c) EXPECT_NEAR(bed.level(c), 0.05, 1e-12);
  EXPECT_NEAR(bed.left / 100, bed_load_at(of, 0.15), 1e-9 * bed_load_at(of, 0.15));
  EXPECT_NEAR(bed.total() + bed.left - bed.fed, before, 1e-9 * before);
}

TEST(SurfaceBed, BelowThresholdNothingMovesAtAll) {
  const Grains of = sand();
  GrainColumns bed = bed_of(20, 5, 0.01, of, 0.05);
  const std::vector<double> before = bed.grains;
  const std::vector<BedStress> stress(100, bed_stress_of(of, friction_velocity_at(of, 0.046), 1, 0));
  EXPECT_DOUBLE_EQ(advance_bed(bed, of, stress, {}, 1e5, 0.1).time, 1e5);
  EXPECT_EQ(bed.grains, before);
}

// Behind a fixed floor clear water digs, and the hole's rate at the edge is q/((1 - n) dx).
TEST(SurfaceBed, ClearWaterScoursBehindAFixedFloor) {
  const Grains of = sand();
  GrainColumns bed = bed_of(40, 1, 0.01, of, 0.05);
  for (std::size_t c = 0; c < 10; ++c) {
    bed.floor[c] = 0.05;
    bed.grains[c] = 0;
  }
  std::vector<BedStress> stress(40, bed_stress_of(of, friction_velocity_at(of, 0.15), 1, 0));
  const BedAdvance done = advance_bed(bed, of, stress, {}, 1e4, 0.0005);
  EXPECT_NEAR(done.largest_change, 0.0005, 5e-5);
  const double expected = bed_load_at(of, 0.15) / (1 - of.porosity) / 0.01 * done.time;
  EXPECT_NEAR(0.05 - bed.level(10), expected, 0.12 * expected);  // the slope towards the hole speeds it up
}

// Beneath a body grains fill the gap and no more.
TEST(SurfaceBed, ABedStopsBelowABody) {
  const Grains of = sand();
  GrainColumns bed = bed_of(30, 1, 0.01, of, 0.05);
  bed.ceiling.assign(30, INFINITY);
  bed.ceiling[15] = 0.052;
  std::vector<BedStress> stress(30);
  for (int c = 0; c < 30; ++c) {
    stress[GrainColumns::at(c)] = bed_stress_of(of, friction_velocity_at(of, c <= 15 ? 0.2 : 0.02), 1, 0);
  }
  const double before = bed.total();
  advance_bed(bed, of, stress, {}, 1e3, 1);
  EXPECT_LE(bed.level(15), 0.052 + 1e-12);
  EXPECT_NEAR(bed.total(), before, 1e-9 * before);
}

// A flow across a slope carries grains down it, by Ikeda's share of the bed load.
TEST(SurfaceBed, GrainsRollDownASlopeAcrossTheFlow) {
  const Grains of = sand();
  GrainColumns bed = bed_of(9, 9, 0.01, of, 0.05);
  for (int c = 0; c < 81; ++c) bed.grains[GrainColumns::at(c)] += bed.packing * bed.area[0] * 0.001 * (c / 9);
  const BedStress stress = bed_stress_of(of, friction_velocity_at(of, 0.15), 1, 0);
  const double slope = 0.1;
  const double critical = critical_on_slope(of, stress, 0, slope);
  const double along = bed_load_between(bed, of, stress, 40, 0, true);
  EXPECT_NEAR(along, bed_load_of(of, stress, critical), 1e-12);
  EXPECT_NEAR(bed_load_between(bed, of, stress, 40, 1, false) / along, 1.5 * std::sqrt(critical / 0.15) * slope, 1e-9);
  EXPECT_EQ(bed_load_between(bed, of, stress, 40, 1, true), 0);
}

// Down 18 degrees sand with a friction of 32 begins to move at sin(14)/sin(32) = 0.4565 of the flat bed's stress, up 18 at
// sin(50)/sin(32) = 1.4456 (Fernandez Luque & van Beek 1976 measured falling beds). At three times the flat bed's
// 0.047: 8 (0.141 - 0.02146)^1.5 = 0.33066 and 8 (0.141 - 0.06794)^1.5 = 0.15797. With friction these are divided by
// 1 -+ tan(18)/tan(32): 0.68884 and 0.10393.
TEST(SurfaceBed, ASlopeAlongTheFlowChangesTheThresholdAloneOrTheFrictionToo) {
  Grains of = sand();
  const double slope = std::tan(18 * M_PI / 180);
  const BedStress stress = bed_stress_of(of, friction_velocity_at(of, 0.141), 1, 0);
  const double unit = bed_load_scale(of.diameter, of.density, of.water_density, of.gravity);
  for (const bool up : {false, true}) {
    GrainColumns bed = bed_of(9, 1, 0.01, of, 0.1);
    for (int c = 0; c < 9; ++c) {
      bed.grains[GrainColumns::at(c)] += bed.packing * bed.area[0] * (up ? slope : -slope) * 0.01 * (c - 4);
    }
    of.slope_effect = SlopeEffect::threshold;
    EXPECT_NEAR(bed_load_between(bed, of, stress, 4, 0, true) / unit, up ? 0.15797 : 0.33066, 2e-5);
    of.slope_effect = SlopeEffect::friction;
    EXPECT_NEAR(bed_load_between(bed, of, stress, 4, 0, true) / unit, up ? 0.10393 : 0.68884, 4e-5);
  }
}

}  // namespace
}  // namespace thalweg
