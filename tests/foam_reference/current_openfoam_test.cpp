// Currents in the real OpenFOAM, on meshes of some hundred cells; skipped, visibly, where it or the library is missing.
#include <gmock/gmock.h>

#include <cmath>

#include "case/reader/case_file.hpp"
#include "physics/water/log_profile.hpp"
#include "tests/foam_reference/current_scene.hpp"
#include "tests/foam_reference/library_fixture.hpp"

namespace thalweg::foam {
namespace {

class FoamCurrentTest : public FoamLibraryTest {
 protected:
  [[nodiscard]] std::vector<double> history(const std::string& column, const std::string& unit) const {
    return CsvTable::read(folder_.path() / "history.csv").numbers(column, unit);
  }

  /// Mean velocity at the middle station [m/s].
  [[nodiscard]] double station_mean() const {
    const CsvTable table = CsvTable::read(folder_.path() / "stations.csv");
    const std::vector<double> means = table.numbers("mean_velocity", "m/s");
    return means.at(means.size() / 2);
  }
};

// The current that the slope keeps in equilibrium starts from the log law and stays near it: u*/kappa (ln(H/z0) - 1) is
// 0.7444 m/s. The model's own equilibrium is 1.4 % above (docs/mesh-comparison.md), and 3 s are a seventh of the way.
TEST_F(FoamCurrentTest, KeepsTheCurrentOfASlope) {
  Case scene = flume();
  scene.output.end = 3;
  scene.compare.times = {3};
  run(scene, FoamModel::stock);
  const double u = std::sqrt(9.81 * 0.1 * 0.00197);
  const double law = log_profile(u, 0.1 * std::exp(-1.0), 1e-6, 1e-3);
  EXPECT_NEAR(history("bulk_velocity", "m/s").back() / law, 1, 0.02);
  EXPECT_NEAR(station_mean() / law, 1, 0.02);
  EXPECT_NEAR(history("drive", "m/s^2").back(), 9.81 * 0.00197, 1e-9);
  EXPECT_LT(std::abs(summary("water_volume_error")), 1e-9);
}

// From rest: the control reaches the discharge in some of its times of 0.1 H/u* = 0.3 s, and keeps it.
TEST_F(FoamCurrentTest, ReachesADischargeFromRest) {
  Case scene = flume();
  scene.flow.drive = Drive::discharge;
  scene.flow.discharge = 0.05;
  scene.flow.start = FlowStart::rest;
  scene.output.end = 3;
  scene.compare.times = {3};
  run(scene, FoamModel::stock);
  EXPECT_NEAR(history("bulk_velocity", "m/s").back(), 0.5, 0.005);
}

// The inlet brings the case's discharge, the books of the water close, and the outlet keeps its level.
TEST_F(FoamCurrentTest, ConservesTheDischargeBetweenInletAndTailWater) {
  Case scene = channel();
  scene.output.end = 2;
  scene.compare.times = {2};
  run(scene, FoamModel::stock);
  const std::vector<double> in = history("west_water", "kg");
  const std::vector<double> out = history("east_water", "kg");
  EXPECT_NEAR(in.back() / (1000 * 0.04 * 2), 1, 1e-3);
  const double water = 1000 * (summary("water_volume_end") - summary("water_volume_start"));
  EXPECT_NEAR(in.back() + out.back(), water, 1e-4);
  EXPECT_NEAR(history("east_level", "m").back(), 0.1, 0.002);
  EXPECT_NEAR(history("west_level", "m").back(), 0.1, 0.003);
  EXPECT_NEAR(station_mean(), 0.4, 0.01);
}

// Nothing passes the gate over the slot: what comes in and does not leave through the outlet is in the tank.
TEST_F(FoamCurrentTest, LosesNoWaterThroughAGate) {
  Case scene = sluice();
  run(scene, FoamModel::stock);
  const double in = history("west_water", "kg").back();
  EXPECT_NEAR(in, 1000 * 0.04 * 1, 0.04);
  const double water = 1000 * (summary("water_volume_end") - summary("water_volume_start"));
  EXPECT_NEAR(in + history("east_water", "kg").back(), water, 1e-3);
}

// A pump takes out what the inlets bring, and the volume of the water stays; on two ranks too, where each has one end.
TEST_F(FoamCurrentTest, PumpsWhatComesInOnTwoRanks) {
  Case scene = channel();
  scene.outlets[0].kind = OutletKind::pump;
  run(scene, FoamModel::stock, 2);
  EXPECT_NEAR(summary("water_volume_end"), 0.06, 1e-4);
  EXPECT_NEAR(history("east_water", "kg").back(), -1000 * 0.04, 0.1);
}

// u* = 22 mm/s over sand of 1 mm, Shields number 0.03 below the threshold of 0.047: nothing moves, and the velocity stays
// that of the law over the bed's roughness.
TEST_F(FoamCurrentTest, RunsOverAnErodingBed) {
  Case scene = flume();
  scene.domain.to.z() = 0.3;
  scene.shapes.insert(scene.shapes.begin() + 1, box("bed", ShapeRole::sediment, Vec3(0, 0, 0), Vec3(0.2, 0, 0.04)));
  scene.shapes.back().from.z() = 0.04;
  scene.shapes.back().to.z() = 0.14;
  SedimentParameters sand;
  sand.grain_density = 2650;
  sand.porosity = 0.4;
  sand.grain_diameter = 0.001;
  sand.friction_angle = 0.56;
  sand.critical_shields = 0.047;
  scene.sediments["sand"] = sand;
  scene.model.sediment = SedimentModel::three_state;
  scene.flow.slope = 0.000493;
  run(scene, FoamModel::eroding_bed);
  EXPECT_THAT(profile(1).moving_bed, testing::Each(testing::DoubleNear(0.04, 1e-9)));
  const double u = std::sqrt(9.81 * 0.1 * 0.000493);
  EXPECT_NEAR(station_mean() / log_profile(u, 0.1 * std::exp(-1.0), 1e-6, 1e-3), 1, 0.02);
}

// u* = 48 mm/s over sand of 1 mm: without feed the bed loses 3 mm next to the inlet's plane in 2 s.
TEST_F(FoamCurrentTest, KeepsTheBedBesideAnInletThatFeedsIt) {
  const std::vector<std::string> options = {"output.end=2 s", "output.interval=1 s", "compare.times=[\"2 s\"]"};
  const std::string file = THALWEG_SOURCE_DIR "/tests/solver/program/openings/feed.toml";
  run(read_case(file, options), FoamModel::eroding_bed);
  EXPECT_NEAR(profile(2).moving_bed.front(), 0.06, 0.0007);
  EXPECT_LT(std::abs(summary("grains_volume_error")), 1e-9);
}

}  // namespace
}  // namespace thalweg::foam
