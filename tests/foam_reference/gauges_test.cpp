// The case's gauges on a mesh: what OpenFOAM is asked to record, and what is made of its records.
#include "foam_reference/gauges.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "common/csv.hpp"
#include "tests/foam_reference/small_scene.hpp"
#include "tests/foam_reference/temporary_folder.hpp"

namespace thalweg::foam {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

Gauge gauge(const std::string& name, GaugeKind kind, const Vec3& at) {
  Gauge made;
  made.name = name;
  made.kind = kind;
  made.at = at;
  return made;
}

class MeshGauges : public testing::Test {
 protected:
  /// A record of a gauge's field, as OpenFOAM writes it.
  void record(int number, const std::string& field, const std::string& rows) const {
    const fs::path table = folder_.path() / "case/postProcessing" / ("gauge_" + std::to_string(number)) / "0" / field;
    fs::create_directories(table.parent_path());
    std::ofstream(table) << "# Time\n" << rows;
  }
  [[nodiscard]] CsvTable written(const Case& scene) const {
    write_gauges(make_foam_case(scene, 1), folder_.path());
    return CsvTable::read(folder_.path() / "gauges.csv");
  }

  TemporaryFolder folder_;
};

TEST_F(MeshGauges, WithoutGaugesNothingIsRecorded) {
  const FoamCase foam_case = make_foam_case(water_tank(), 1);
  EXPECT_EQ(gauge_functions(foam_case), "");
  write_gauges(foam_case, folder_.path());
  EXPECT_FALSE(fs::exists(folder_.path() / "gauges.csv"));
}

TEST_F(MeshGauges, PressureIsRecordedAtItsPlaceAndNeverOutsideTheBlock) {
  Case scene = water_tank();
  scene.gauges = {gauge("inside", GaugeKind::pressure, Vec3(0.1, 0, 0.03)),
                  gauge("at the wall", GaugeKind::pressure, Vec3(0.4, 0, 0))};
  scene.output.gauge_interval = 0.002;
  const std::string functions = gauge_functions(make_foam_case(scene, 1));
  EXPECT_THAT(functions, HasSubstr("fields          (p);"));
  EXPECT_THAT(functions, HasSubstr("probeLocations  ( (0.1 0 0.03) );"));
  EXPECT_THAT(functions, HasSubstr("probeLocations  ( (0.39999 0 1e-05) );"));  // a thousandth of a cell of 10 mm
  EXPECT_THAT(functions, HasSubstr("writeInterval   0.002;"));
}

TEST_F(MeshGauges, ALevelRecordsItsWholeColumnOfCells) {
  Case scene = water_tank();
  scene.gauges = {gauge("level", GaugeKind::water_level, Vec3(0.103, 0, 0))};
  const std::string functions = gauge_functions(make_foam_case(scene, 1));
  EXPECT_THAT(functions, HasSubstr("fields          (alpha.air);"));
  EXPECT_THAT(functions, HasSubstr("(0.105 0 0.005) (0.105 0 0.015)"));
  EXPECT_THAT(functions, HasSubstr("interpolationScheme cell;"));
}

TEST_F(MeshGauges, NothingRecordsAFlux) {
  Case scene = water_tank();
  scene.gauges = {gauge("flux", GaugeKind::flux, Vec3::Zero())};
  EXPECT_EQ(gauge_functions(make_foam_case(scene, 1)), "");
}

// Ten cells of 10 mm hold water, the eleventh 0.3 of it, and those above are air: 103 mm. The grains of four cells and a
// half: 45 mm.
TEST_F(MeshGauges, LevelAndBedAreIntegralsOverTheColumn) {
  Case scene = still_tank();
  scene.gauges = {gauge("level", GaugeKind::water_level, Vec3(0.1, 0, 0))};
  const auto cells = static_cast<int>(make_foam_case(scene, 1).plan.cells[2]);
  std::string air = "0.5";
  std::string grains = "0.5";
  for (int k = 0; k < cells; ++k) {
    air += k < 10 ? " 0" : k == 10 ? " 0.7" : " 1";
    grains += k < 4 ? " 1" : k == 4 ? " 0.5" : " 0";
  }
  record(1, "alpha.air", air + "\n");
  record(1, "alpha.sediment", grains + "\n");
  const CsvTable table = written(scene);
  EXPECT_THAT(table.numbers("time", "s"), testing::ElementsAre(0.5));
  EXPECT_NEAR(table.numbers("level.level", "m").at(0), 0.103, 1e-9);
  EXPECT_NEAR(table.numbers("level.bed", "m").at(0), 0.045, 1e-9);
}

TEST_F(MeshGauges, VelocityInThePlaneHasTwoComponents) {
  Case scene = water_tank();
  scene.gauges = {gauge("u", GaugeKind::velocity, Vec3(0.1, 0, 0.03))};
  record(1, "U", "0.1 (0.5 7 -0.25)\n0.2 (1 7 2)\n");
  const CsvTable table = written(scene);
  EXPECT_THAT(table.numbers("u.velocity_x", "m/s"), testing::ElementsAre(0.5, 1));
  EXPECT_THAT(table.numbers("u.velocity_z", "m/s"), testing::ElementsAre(-0.25, 2));
}

TEST_F(MeshGauges, APlaceInASolidIsEmptyAndSaysWhy) {
  Case scene = water_tank();
  scene.gauges = {gauge("p", GaugeKind::pressure, Vec3(0.1, 0, 0.03)), gauge("flux", GaugeKind::flux, Vec3::Zero())};
  record(1, "p", "0.1 -1.79769313486e+307\n");
  const CsvTable table = written(scene);
  EXPECT_TRUE(std::isnan(table.numbers("p.pressure", "Pa").at(0)));
  EXPECT_THAT(table.texts("note").at(0), HasSubstr("p: in a solid"));
  EXPECT_THAT(table.texts("note").at(0), HasSubstr("flux: no flux on a mesh"));
}

}  // namespace
}  // namespace thalweg::foam
