#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "common/csv.hpp"
#include "physics/scour/dey_sarkar_wall_jet.hpp"
#include "physics/scour/laursen_clear_water.hpp"
#include "physics/scour/laursen_live_bed.hpp"
#include "physics/transport/friction_velocity.hpp"
#include "physics/transport/lift_settling.hpp"

// The formulas against measurements. Tables of others do not belong to the repository: the tests read them from a
// folder beside it and are skipped where it is absent.
namespace thalweg {
namespace {

namespace fs = std::filesystem;

const fs::path measurements = THALWEG_MEASUREMENTS;

double number_of(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return end == text.c_str() ? std::nan("") : value;
}

/// Shares of rows whose depth is met within a quarter, and whose scour depth is.
struct Hits {
  int rows = 0;
  int of_depth = 0;
  int scour_rows = 0;
  int of_scour = 0;

  void count(double computed, double measured, double upstream) {
    ++rows;
    of_depth += std::abs(computed / measured - 1) <= 0.25 ? 1 : 0;
    if (!(measured > upstream)) return;
    ++scour_rows;
    of_scour += std::abs((computed - upstream) / (measured - upstream) - 1) <= 0.25 ? 1 : 0;
  }
};

/// Laboratory runs, Straub 1934 to Nowroozpour & Ettema 2021.
struct ContractionRow {
  double d, s, b1, b2, u1, y1, y2;

  [[nodiscard]] bool is_complete() const { return std::isfinite(d + s + b1 + b2 + u1 + y1 + y2); }
  [[nodiscard]] double clear_water_depth() const {
    return laursen_clear_water_depth({.discharge = u1 * y1 * b1 / b2, .grain_diameter = d, .relative_density = s});
  }
  [[nodiscard]] double live_bed_depth() const {
    const double d_star = dimensionless_diameter(d, 1000 * s, 1000.0, 9.81, 1e-3);
    return laursen_live_bed_depth(
        {.depth = y1,
         .width = b1,
         .contracted_width = b2,
         .friction_velocity = friction_velocity(u1, y1 / M_E, 1e-6, 2.5 * d).friction_velocity,
         .settling_velocity = settling_velocity(d_star, d, 1e-6)});
  }
};

// Laursen's depths in the contraction are met within a quarter in four of five runs (19 of 24 with a live bed, 85 of
// 102 in clear water); the scour depth, their difference to the depth upstream, in far fewer, because the shares of
// error add up. Both are some 15 % low: a median ratio of 0.85 and 0.83.
TEST(ScourAgainstMeasurements, ContractionsAreAsDeepAsLaursenSays) {
  const fs::path file = measurements / "contraction_scour_rows" / "rows.csv";
  if (!fs::exists(file)) GTEST_SKIP() << file << " is absent";
  const CsvTable table = CsvTable::read(file);
  const auto column = [&](const char* name) { return table.texts(name); };
  const auto d = column("Median diameter");
  const auto s = column("Specific density");
  const auto b1 = column("Upstream width b1");
  const auto b2 = column("Contracted width b2");
  const auto u1 = column("Upstream average flow velocity u1");
  const auto y1 = column("Upstream flow depth y1");
  const auto y2 = column("Flow depth at contracted reach y2");
  const auto ds = column("Equilibrium scour depth ds");
  const auto kind = column("Type of scour");
  Hits live;
  Hits clear;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    ContractionRow row{1e-3 * number_of(d[i]), number_of(s[i]),  number_of(b1[i]), number_of(b2[i]),
                       number_of(u1[i]),       number_of(y1[i]), number_of(y2[i])};
    if (std::isnan(row.y2)) row.y2 = row.y1 + number_of(ds[i]);
    if (!row.is_complete()) continue;
    if (kind[i] == "live-bed") live.count(row.live_bed_depth(), row.y2, row.y1);
    if (kind[i] == "clear-water") clear.count(row.clear_water_depth(), row.y2, row.y1);
  }
  std::cout << "within 25 %, live bed: depth " << live.of_depth << " of " << live.rows << ", scour " << live.of_scour
            << " of " << live.scour_rows << "; clear water: depth " << clear.of_depth << " of " << clear.rows
            << ", scour " << clear.of_scour << " of " << clear.scour_rows << "\n";
  EXPECT_GE(live.rows, 20);
  EXPECT_GE(live.of_depth, 0.75 * live.rows);
  EXPECT_GE(clear.rows, 100);
  EXPECT_GE(clear.of_depth, 0.8 * clear.rows);
}

// Dey & Sarkar 2006 (J. Hydraul. Eng. 132(3), 246-257), run 1R8: opening 15 mm, apron 0.4 m, 1.21 m/s, tailwater
// 0.163 m. The last hole that was measured is 80 mm deep. Its grains are not known here: the formula gives 96 mm
// with the finest sand of the paper and 56 mm with its coarsest grains, 75 mm with 0.8 mm.
TEST(ScourAgainstMeasurements, TheHoleBelowAnApronLiesBetweenTheFinestAndTheCoarsestGrain) {
  DeySarkarWallJet jet{.velocity = 1.21, .opening = 0.015, .apron = 0.4, .tailwater = 0.163, .relative_density = 2.65};
  jet.grain_diameter = 0.26e-3;
  EXPECT_NEAR(dey_sarkar_scour(jet), 0.096, 1e-3);
  jet.grain_diameter = 3.1e-3;
  EXPECT_NEAR(dey_sarkar_scour(jet), 0.056, 1e-3);
}

}  // namespace
}  // namespace thalweg
