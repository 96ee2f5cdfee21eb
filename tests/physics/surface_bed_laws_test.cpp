#include "physics/bed/grain_columns.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

#include "physics/bed/avalanche.hpp"
#include "physics/bed/grains.hpp"
#include "physics/bed/move_bed_load.hpp"

namespace thalweg {
namespace {

// A flat bed 0.05 m thick, half of it grains, in columns of 10 mm.
GrainColumns flat_bed(int nx, int ny) {
  GrainColumns bed;
  bed.grid = {nx, ny, 0.01, 0.01, false, false};
  bed.packing = 0.5;
  const auto columns = static_cast<std::size_t>(nx * ny);
  bed.area.assign(columns, 1e-4);
  bed.floor.assign(columns, 0.0);
  bed.grains.assign(columns, 0.5 * 1e-4 * 0.05);
  return bed;
}

TEST(Bed, LevelsFollowTheGrains) {
  GrainColumns bed = flat_bed(3, 1);
  EXPECT_NEAR(bed.level(1), 0.05, 1e-15);
  bed.floor[1] = 0.02;
  EXPECT_NEAR(bed.level(1), 0.07, 1e-15);
  EXPECT_NEAR(bed.slope(0, 0), 2, 1e-12);  // one-sided: 0.02 over 0.01
  EXPECT_NEAR(bed.slope(1, 0), 0, 1e-12);
  EXPECT_EQ(bed.slope(1, 1), 0);
}

TEST(Bed, NeighboursEndAtWallsAndGoAroundPeriods) {
  GrainColumns bed = flat_bed(3, 2);
  EXPECT_EQ(bed.grid.neighbour(0, 0, false), -1);
  EXPECT_EQ(bed.grid.neighbour(2, 1, true), 5);
  bed.grid.periodic_x = true;
  EXPECT_EQ(bed.grid.neighbour(0, 0, false), 2);
  EXPECT_EQ(bed.grid.neighbour(5, 0, true), 3);
  bed.area[3] = 0;  // a solid
  EXPECT_EQ(bed.open_neighbour(5, 0, true), -1);
}

// A uniform bed load changes the ends only: dz = q dt/((1 - n) dx) = 1e-3 * 0.01/(0.5 * 0.01) = 2 mm.
TEST(MoveBedLoad, ErodesAtTheBeginningAndDepositsAtTheEnd) {
  GrainColumns bed = flat_bed(5, 1);
  const double before = bed.total();
  move_bed_load(
      bed, [](int, int axis, bool forward) { return axis == 0 && forward ? 1e-3 : 0.0; }, 0.01);
  EXPECT_NEAR(bed.level(0), 0.048, 1e-15);
  EXPECT_NEAR(bed.level(2), 0.050, 1e-15);
  EXPECT_NEAR(bed.level(4), 0.052, 1e-15);
  EXPECT_NEAR(bed.total(), before, 1e-15 * before);
}

TEST(MoveBedLoad, TakesNoMoreThanThereIs) {
  GrainColumns bed = flat_bed(3, 3);
  const double before = bed.total();
  move_bed_load(
      bed, [](int, int, bool) { return 10.0; }, 1);
  for (const double grains : bed.grains) EXPECT_GE(grains, 0);
  EXPECT_NEAR(bed.total(), before, 1e-14 * before);
}

// A tower slides into a heap whose slopes are at the angle of repose, as many grains as before.
TEST(Avalanche, LeavesSlopesAtTheAngleOfRepose) {
  for (const int ny : {1, 21}) {
    GrainColumns bed = flat_bed(21, ny);
    bed.grains[static_cast<std::size_t>(10 + 21 * (ny / 2))] *= 4;
    const double before = bed.total();
    const double repose = std::tan(0.6);
    EXPECT_TRUE(avalanche(bed, repose, 10000));
    EXPECT_NEAR(bed.total(), before, 1e-12 * before);
    for (int column = 0; column < bed.grid.columns(); ++column) {
      for (const int axis : {0, 1}) {
        const int next = bed.open_neighbour(column, axis, true);
        if (next < 0) continue;
        EXPECT_LE(std::abs(bed.level(next) - bed.level(column)), repose * 0.01 * (1 + 2e-6));
      }
    }
  }
}

TEST(Avalanche, LeavesAFlatBedAlone) {
  GrainColumns bed = flat_bed(4, 4);
  const std::vector<double> before = bed.grains;
  EXPECT_TRUE(avalanche(bed, 0.5));
  EXPECT_EQ(bed.grains, before);
}

Grains pvc() {
  Grains of;
  of.density = 1540;
  of.diameter = 0.0035;
  of.porosity = 0.47;
  of.tan_friction = std::tan(38 * M_PI / 180);
  of.lift_ratio = 0.85;
  of.roughness = 0.0035;
  of.water_density = 1000;
  of.water_viscosity = 1e-6;
  of.gravity = 9.81;
  return of;
}

// Water at 0.6 m/s, 2 mm above grains of 3.5 mm: u* = 0.0863 m/s, theta = 7.44/18.54 = 0.401 (physics' check values);
// R* = 302: theta_cr = 0.010595 ln 302 + 0.110476/302 + 0.00272 = 0.0636; q = 8 (0.401 - 0.0636)^1.5 * 4.766e-4.
TEST(BedStress, GivesTheBedLoadOfAFlatBed) {
  const Grains of = pvc();
  const BedStress stress = bed_stress(of, 0.6, 0.002, 1, 0);
  EXPECT_NEAR(stress.friction_velocity, 0.0863, 5e-5);
  EXPECT_NEAR(stress.shields, 0.401, 1e-3);
  const double critical = critical_on_slope(of, stress, 0, 0);
  EXPECT_NEAR(critical, 0.0636, 1e-4);
  EXPECT_NEAR(bed_load_of(of, stress, critical), 8 * std::pow(0.3378, 1.5) * 4.766e-4, 5e-6);
}

// k = 0.501927 down and 1.377458 up a slope of 20 degrees, 0.764522 across (slope_factor.hpp); never below a twentieth.
TEST(BedStress, FeelsTheSlope) {
  const Grains of = pvc();
  const BedStress stress = bed_stress(of, 0.6, 0.002, 1, 0);
  const double flat = critical_on_slope(of, stress, 0, 0);
  const double slope = std::tan(20 * M_PI / 180);
  EXPECT_NEAR(critical_on_slope(of, stress, -slope, 0) / flat, 0.501927, 1e-6);
  EXPECT_NEAR(critical_on_slope(of, stress, slope, 0) / flat, 1.377458, 1e-6);
  EXPECT_NEAR(critical_on_slope(of, stress, 0, slope) / flat, 0.764522, 1e-6);
  EXPECT_NEAR(critical_on_slope(of, stress, -1, 0) / flat, 0.05, 1e-12);
}

TEST(BedStress, IsNothingInStillWater) {
  const BedStress stress = bed_stress(pvc(), 0, 0.005, 0, 0);
  EXPECT_EQ(bed_load_of(pvc(), stress, critical_on_slope(pvc(), stress, 0, 0)), 0);
  EXPECT_EQ(pick_up_of(pvc(), stress, 0), 0);
}

}  // namespace
}  // namespace thalweg
