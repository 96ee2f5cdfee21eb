#include <gmock/gmock.h>

#include "foam_reference/case_files.hpp"
#include "tests/foam_reference/small_scene.hpp"

namespace thalweg::foam {
namespace {

using testing::HasSubstr;
using testing::Not;

// By hand: rho_bed = 0.5 * 1000 + 0.5 * 1600 = 1300, submerged 300 kg/m^3; at 0.025 m depth p_eff = 300 * 9.81 * 0.025
// = 73.575 Pa; K = sin 30 deg = 0.5, tau_0 = 36.7875 Pa; cap = 36.7875 * 100 / 2 + 0.0015 = 1839.3765 Pa s.
TEST(StockRheology, TakesTheYieldStressAtTheMiddleOfTheBed) {
  const StockRheology rheology = make_foam_case(still_tank(), 1).rheology.value();
  EXPECT_NEAR(rheology.density, 1300, 1e-9);
  EXPECT_NEAR(rheology.effective_pressure, 73.575, 1e-9);
  EXPECT_NEAR(rheology.yield_stress, 36.7875, 1e-9);
  EXPECT_NEAR(rheology.viscosity_cap, 1839.3765, 1e-9);
}

TEST(StockRheology, AddsTheCohesionOfTheSameFit) {
  Case scene = still_tank();
  scene.sediments["sand"].cohesion = 10;
  EXPECT_NEAR(make_foam_case(scene, 1).rheology.value().yield_stress, 36.7875 + 10 * std::sqrt(0.75), 1e-9);
}

TEST(TransportProperties, HoldKinematicConstantsAndSayWhereTheyComeFrom) {
  const std::string text = model_files(make_foam_case(still_tank(), 1)).at("constant/transportProperties");
  EXPECT_THAT(text, HasSubstr("tau0        0.0282980769231;"));  // 36.7875 / 1300
  EXPECT_THAT(text, HasSubstr("k           1.15384615385e-06;"));
  EXPECT_THAT(text, HasSubstr("nu0         1.414905;"));  // 1839.3765 / 1300 = 1.4149050
  EXPECT_THAT(text, HasSubstr("rho             1300;"));
  EXPECT_THAT(text, HasSubstr("nu              1e-06;\n        rho             1000;"));
  EXPECT_THAT(
      text, HasSubstr("// K p_eff + c_0 at the middle of the bed as it lies at the start: K = 0.5, p_eff = 73.58 Pa"));
  EXPECT_THAT(text, HasSubstr("of the case \"tank\""));
  EXPECT_THAT(text, HasSubstr("(water sediment) 0\n    (water air) 0\n    (sediment air) 0\n"));
}

TEST(TransportProperties, KnowNoSedimentInAWaterTank) {
  const CaseFiles files = case_files(make_foam_case(water_tank(), 1));
  EXPECT_THAT(files.at("constant/transportProperties"), Not(HasSubstr("sediment")));
  EXPECT_FALSE(files.contains("0.orig/alpha.sediment"));
  EXPECT_TRUE(files.contains("0.orig/alpha.water"));
}

TEST(ControlDict, HoldsTheTimesOfTheCase) {
  const std::string text = control_files(make_foam_case(still_tank(), 1)).at("system/controlDict");
  EXPECT_THAT(text, HasSubstr("endTime         0.1;"));
  EXPECT_THAT(text, HasSubstr("writeInterval   0.05;"));
  // 0.4 * 0.01 / sqrt(9.81 * 0.15) = 3.297 ms
  EXPECT_THAT(text, HasSubstr("maxDeltaT       0.0032974"));
  EXPECT_THAT(text, HasSubstr("fields          ( alpha.water alpha.sediment alpha.air );"));
}

TEST(FvSolution, FixesThePressureOnlyInAClosedTank) {
  Case scene = still_tank();
  EXPECT_THAT(control_files(make_foam_case(scene, 1)).at("system/fvSolution"), Not(HasSubstr("pRefPoint")));
  scene.shapes.front().open.clear();
  EXPECT_THAT(control_files(make_foam_case(scene, 1)).at("system/fvSolution"),
              HasSubstr("pRefPoint       (0.395 0 0.195);"));
}

TEST(InitialFields, LetAirInThroughOpenFaces) {
  const CaseFiles files = initial_fields(make_foam_case(still_tank(), 1));
  EXPECT_THAT(files.at("0.orig/alpha.air"),
              HasSubstr("    atmosphere { type inletOutlet; inletValue uniform 1; value uniform 1; }"));
  EXPECT_THAT(files.at("0.orig/alpha.water"),
              HasSubstr("    atmosphere { type inletOutlet; inletValue uniform 0; value uniform 0; }"));
  EXPECT_THAT(files.at("0.orig/U"), HasSubstr("    walls { type noSlip; }"));
}

TEST(Gravity, IsTheCases) {
  Case scene = still_tank();
  scene.domain.gravity = Vec3(1, 0, -9.75);
  EXPECT_THAT(model_files(make_foam_case(scene, 1)).at("constant/g"), HasSubstr("value (1 0 -9.75);"));
}

TEST(Allrun, RunsInParallelOnSeveralRanks) {
  const std::string text = scripts(make_foam_case(still_tank(), 2)).at("Allrun");
  EXPECT_THAT(text, HasSubstr("mpirun --use-hwthread-cpus -np 2 multiphaseInterFoam -parallel"));
  EXPECT_THAT(text, HasSubstr("cd \"${0%/*}\" || exit 1"));
  EXPECT_THAT(scripts(make_foam_case(still_tank(), 1)).at("Allrun"), Not(HasSubstr("mpirun")));
}

}  // namespace
}  // namespace thalweg::foam
