// Maps of a bed from above: a conical hole of known depth and volume, its contours, columns, walls and stresses.
#include "postproc/bed_map.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <numbers>

#include "common/csv.hpp"
#include "postproc/figures/bed_figures.hpp"
#include "tests/postproc/synthetic_run.hpp"

namespace thalweg {
namespace {

using manufactured::contents_of;
using manufactured::TemporaryFolder;

constexpr double hole_depth = 0.05;  // [m]
constexpr double hole_radius = 0.2;  // [m]
constexpr double hole_x = 0.5;       // [m]
constexpr double hole_y = 0.3;       // [m]
constexpr double level = 0.1;        // [m] of the bed around it
constexpr double grid_step = 0.01;   // [m]

double cone(double x, double y) {
  return hole_depth * std::max(0.0, 1 - std::hypot(x - hole_x, y - hole_y) / hole_radius);
}

/// A bed under water from x = 0 to 1 m and y = 0 to 0.6 m, and three columns of nothing around it.
LevelMap bed_with(double (*hole)(double, double)) {
  LevelMap map;
  map.grid.step = grid_step;
  map.grid.first_x = map.grid.first_y = -3;
  map.grid.nx = 107;
  map.grid.ny = 67;
  const double none = std::nan("");
  map.levels.assign(map.grid.columns(), ColumnLevels{none, none, none, none});
  for (std::size_t i = 3; i < 104; ++i) {
    for (std::size_t j = 3; j < 64; ++j) {
      const double bed = level - hole(map.grid.x(i), map.grid.y(j));
      map.levels[map.grid.column(i, j)] = {0.2, bed, bed, 0};
    }
  }
  return map;
}

BedMap cone_map() {
  return map_of_levels(bed_with([](double, double) { return 0.0; }), bed_with(cone));
}

std::vector<double> changes_of(const BedMap& map) {
  std::vector<double> change(map.size());
  for (std::size_t k = 0; k < map.size(); ++k) change[k] = map.change(k);
  return change;
}

TEST(BedMap, AConicalHoleHasItsDepthItsPlaceAndItsVolume) {
  const BedMap map = cone_map();
  EXPECT_EQ(map.nx, 105U);  // two columns of the empty ones are left at each end
  EXPECT_EQ(map.ny, 65U);
  const BedExtremes found = extremes_of(map);
  EXPECT_NEAR(found.scour, hole_depth, 1e-12);
  EXPECT_NEAR(map.x(found.scour_at[0]), hole_x, 1e-9);
  EXPECT_NEAR(map.y(found.scour_at[1]), hole_y, 1e-9);
  const double volume = std::numbers::pi * hole_radius * hole_radius * hole_depth / 3;
  EXPECT_NEAR(found.eroded, volume, 2e-3 * volume);
  EXPECT_EQ(found.deposited, 0);
  // The balance over the same columns, which series.csv holds, says the same.
  const auto balance = bed_balance(bed_with([](double, double) { return 0.0; }), bed_with(cone));
  ASSERT_TRUE(balance);
  EXPECT_NEAR(balance->eroded, found.eroded, 1e-9);
  EXPECT_NEAR(balance->scour, found.scour, 1e-12);
}

TEST(BedMap, ContoursOfAConeAreCircles) {
  const BedMap map = cone_map();
  const std::vector<double> change = changes_of(map);
  const std::vector<double> levels = contour_levels(change, 0.01);
  ASSERT_EQ(levels.size(), 5U);  // -0.05 to -0.01, and none at 0
  const std::vector<Contour> contours = contours_of(map, change, {-0.04, -0.025, -0.01});
  ASSERT_EQ(contours.size(), 3U) << "one closed line each";
  for (const Contour& contour : contours) {
    const double radius = hole_radius * (1 + contour.level / hole_depth);
    EXPECT_GT(contour.points.size(), 20U);
    for (const auto& [x, y] : contour.points) {
      EXPECT_NEAR(std::hypot(x - hole_x, y - hole_y), radius, 0.12 * grid_step) << contour.level;
    }
    EXPECT_EQ(contour.points.front(), contour.points.back());
  }
}

TEST(BedMap, TheTableAndThePicturesHoldTheNumbers) {
  const TemporaryFolder folder("bed_map");
  const BedMap map = cone_map();
  const MapTable table{map, folder.path() / "data" / "bed_map.csv"};
  write_bed_map(table.file, map, 10);
  const CsvTable written = CsvTable::read(table.file);
  const std::vector<double> change = written.numbers("change", "m");
  ASSERT_EQ(change.size(), map.size());
  double deepest = 0;
  for (const double value : change) deepest = std::fmin(deepest, value);
  EXPECT_NEAR(deepest, -hole_depth, 1e-6);
  const FigureWriter writer(folder.path() / "pictures");
  const std::string script = contents_of(change_map_script(writer, table, height_unit(hole_depth, 0.2)));
  EXPECT_NE(script.find("set cbrange [-50:50]"), std::string::npos) << "symmetric, of the bed alone, in mm";
  EXPECT_NE(script.find("bed risen or sunk  [mm]"), std::string::npos);
  const std::string section =
      contents_of(section_script(writer, table, true, extremes_of(map).scour_at, height_unit(hole_depth, 0.2)));
  EXPECT_NE(section.find("from 0.5,100 to 0.5,50"), std::string::npos) << "the arrow at the deepest place";
  const std::vector<double> now = CsvTable::read(folder.path() / "data" / "section_x.csv").numbers("now", "m");
  double lowest = level;
  for (const double value : now) lowest = std::fmin(lowest, value);
  EXPECT_NEAR(lowest, level - hole_depth, 1e-6);
}

/// A bed of 20 x 10 columns 10 mm wide in two layers under water, around a pier of 2 x 2 columns, between side walls.
ParticleSet columns(double lowered) {
  ParticleSet set;
  set.info.dimension = 3;
  set.info.spacing = grid_step;
  const auto add = [&](ParticleType type, double x, double y, double z, float shear) {
    set.id.push_back(static_cast<std::int64_t>(set.size()));
    set.type.push_back(type);
    set.position.emplace_back(x, y, z);
    set.scalars["BedShear"].push_back(shear);
  };
  for (int i = 0; i < 20; ++i) {
    for (int j = -1; j < 11; ++j) {
      const double x = 0.005 + grid_step * i;
      const double y = 0.005 + grid_step * j;
      const bool pier = (i == 9 || i == 10) && (j == 4 || j == 5);
      if (pier || j < 0 || j > 9) {
        for (int k = 0; k < 8; ++k) add(ParticleType::wall, x, y, 0.005 + grid_step * k, 0);
        continue;
      }
      const double fall = i == 8 && j == 4 ? lowered : 0;
      add(ParticleType::sediment, x, y, 0.005 - fall, 0);
      add(ParticleType::sediment, x, y, 0.015 - fall, i == 8 && j == 4 ? 5.F : 2.F);
      for (int k = 2; k < 8; ++k) add(ParticleType::water, x, y, 0.005 + grid_step * k, 0);
    }
  }
  return set;
}

TEST(BedMap, ColumnsFallByWhatTheirParticlesDo) {
  BedMap map = map_of_columns(columns(0), columns(0.004));
  ASSERT_EQ(map.nx, 20U);
  ASSERT_EQ(map.ny, 10U);
  const BedExtremes found = extremes_of(map);
  EXPECT_NEAR(found.scour, 0.004, 1e-12);
  EXPECT_EQ(found.scour_at, (std::array<std::size_t, 2>{8, 4}));
  EXPECT_NEAR(found.eroded, 0.004 * 1e-4, 1e-15);
  EXPECT_NEAR(map.now[map.index(3, 3)], 0.02, 1e-12);
  EXPECT_NEAR(map.water[map.index(3, 3)], 0.08, 1e-12);

  add_ground(map, columns(0.004));
  EXPECT_EQ(map.ground[map.index(9, 4)], Ground::body);
  EXPECT_EQ(map.ground[map.index(8, 4)], Ground::bed);
  EXPECT_EQ(std::count(map.ground.begin(), map.ground.end(), Ground::body), 4);

  add_shields(map, columns(0.004), 10);
  EXPECT_NEAR(map.shields[map.index(8, 4)], 0.5, 1e-6);
  EXPECT_NEAR(map.shields[map.index(2, 2)], 0.2, 1e-6);
  EXPECT_TRUE(std::isnan(map.shields[map.index(9, 4)]));
}

TEST(BedMap, SaysNothingOfStressesThatTheFilesDoNotCarry) {
  ParticleSet set = columns(0);
  set.scalars.clear();
  BedMap map = map_of_columns(set, set);
  add_shields(map, set, 10);
  EXPECT_TRUE(map.shields.empty());
  EXPECT_EQ(extremes_of(map).scour, 0);
}

TEST(BedMap, BecomesASurveyThatReachesTheEndsOfTheBed) {
  BedMap map = map_of_columns(columns(0), columns(0.004));
  add_ground(map, columns(0.004));
  const TemporaryFolder folder("bed_survey");
  write_bed_survey(folder.path() / "bed.csv", map, Vec3::Constant(-1), Vec3::Constant(1));
  const CsvTable survey = CsvTable::read(folder.path() / "bed.csv");
  const auto x = survey.numbers("x", "m");
  const auto y = survey.numbers("y", "m");
  const auto z = survey.numbers("z", "m");
  // 200 columns but for the four of the pier; half a column outside 64 around the bed, and 8 towards the pier.
  EXPECT_EQ(x.size(), 196U + 64U + 8U);
  EXPECT_NEAR(*std::min_element(x.begin(), x.end()), map.x0 - 0.005, 1e-9);
  EXPECT_NEAR(*std::max_element(y.begin(), y.end()), map.y(9) + 0.005, 1e-9);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::abs(x[i] - map.x(8)) > 1e-6 || std::abs(y[i] - map.y(4)) > 1e-6) continue;
    EXPECT_NEAR(z[i], map.now[map.index(8, 4)], 1e-9);
  }
}

TEST(ReportUnits, AreChosenByMagnitudeAndPrintedAlike) {
  EXPECT_EQ(height_unit(0.02, 0.3).text(0.0177), "17.7\u00a0mm");
  EXPECT_EQ(height_unit(1.2, 8).text(1.2), "1.200\u00a0m");
  EXPECT_EQ(height_unit(0.3, 8).name, "m") << "deep water: one unit for all heights";
  EXPECT_EQ(time_unit(100).name, "s");
  EXPECT_EQ(time_unit(4 * 3600).text(5400), "1.5\u00a0h");
  EXPECT_EQ(volume_unit(0.004, 2).text(0.004), "40.0\u00a0cm^2");
  EXPECT_EQ(volume_unit(0.004, 3).drawn(), "cm³");
  EXPECT_EQ(volume_unit(2, 3).name, "m^3");
  EXPECT_EQ(height_unit(0.02, 0.3).signed_number(-0.0012), "\u22121.2");
  EXPECT_EQ(height_unit(0.02, 0.3).signed_number(0.00001), "0.0");
  EXPECT_EQ(height_unit(0.02, 0.3).text_or_less(0.00003), "less than 0.1\u00a0mm");
  EXPECT_EQ(height_unit(0.02, 0.3).number(std::nan("")), "–");
}

}  // namespace
}  // namespace thalweg
