// The eroding bed of libthalwegFoam, in the real OpenFOAM.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "foam_reference/field_file.hpp"
#include "physics/transport/lift_settling.hpp"
#include "tests/foam_reference/library_fixture.hpp"

namespace thalweg::foam {
namespace {

TEST_F(FoamLibraryTest, ConservesGrainsOfAnErodingBed) {
  run(small_dam_break(), FoamModel::eroding_bed);
  EXPECT_LT(std::abs(summary("grains_volume_error")), 1e-6);
  EXPECT_LT(std::abs(summary("water_volume_error")), 1e-4);
  EXPECT_LT(std::ranges::min(profile(0.2).moving_bed), 0.0495);  // something has moved
}

// Nothing is at the threshold of motion: 2 s of still water leave the bed as it was, to rounding.
TEST_F(FoamLibraryTest, DoesNotMoveABedUnderStillWater) {
  Case scene = still_tank();
  scene.output.end = 2;
  scene.compare.times = {2};
  run(scene, FoamModel::eroding_bed);
  EXPECT_THAT(profile(2).moving_bed, testing::Each(testing::DoubleNear(0.05, 1e-12)));
  EXPECT_THAT(profile(2).free_surface, testing::Each(testing::DoubleNear(0.1, 1e-4)));
}

// Water that runs at 0.6 m/s over a flat bed, held so: the first column, to which nothing comes, loses the bed load of
// Meyer-Peter & Mueller at the log law's shear stress, worked out here once more.
TEST_F(FoamLibraryTest, MovesTheBedLoadOfMeyerPeterAndMueller) {
  Case scene = still_tank();
  scene.shapes[2].to.z() = 0.18;
  scene.output.end = 1e-4;
  scene.compare.times = {1e-4};
  CaseFiles files = case_files(foam_case(scene, FoamModel::eroding_bed));
  replace(files["0.orig/U"], "uniform (0 0 0)", "uniform (0.6 0 0)");
  replace(files["system/fvSolution"], "momentumPredictor   yes;", "momentumPredictor   yes;\n    frozenFlow yes;");
  fix_step(files["system/controlDict"], "1e-4");
  run_files(files, 1e-4, "interFoam");

  const double z = 0.005;  // the first centre above the bed; its sand is rough: ks+ = 0.0568 * 0.002/1e-6 > 70
  const double u = 0.41 * 0.6 / std::log(z / (0.033 * 0.002));
  const double shields = 1000 * u * u / (600 * 9.81 * 0.002);
  const double reynolds = u * 0.002 / 1e-6;
  const double critical = 0.010595 * std::log(reynolds) + 0.110476 / reynolds + 0.0027197;
  const double flux = 8 * std::pow(shields - critical, 1.5) * std::sqrt(0.6 * 9.81 * std::pow(0.002, 3));

  const auto rows = columns("0.0001");
  ASSERT_EQ(rows.size(), 40U);
  EXPECT_NEAR(rows[20][6] / shields, 1, 2e-3);  // friction_velocity stops at 1e-3
  EXPECT_NEAR(rows[20][8] / flux, 1, 5e-3);
  // Column 20 gets as much as it gives; both lose the same to suspension. (1 - n) dx dz = q dt
  const double lost = 0.5 * 0.01 * (rows[20][3] - rows[0][3]) / 1e-4;
  EXPECT_NEAR(lost / flux, 1, 5e-3);
}

// A thin cloud of grains in still water sinks at Soulsby's velocity: its middle, which upwinding smears but does not
// shift.
TEST_F(FoamLibraryTest, LetsGrainsSettleAtTheSoulsbyVelocity) {
  Case scene = still_tank();
  scene.sediments["sand"].grain_diameter = 0.0005;
  scene.shapes[2].to.z() = 0.19;
  scene.output.end = 0.4;
  scene.compare.times = {0.2, 0.4};
  CaseFiles files = case_files(foam_case(scene, FoamModel::eroding_bed));
  std::string& fill = files["system/setFieldsDict"];
  fill.replace(fill.rfind(");"), 2,
               "    boxToCell { box (-1 -1 0.14) (1 1 0.16); fieldValues ( volScalarFieldValue grains 1e-5 ); }\n);");
  run_files(files, 0.4, "interFoam");

  const std::vector<double> z = read_scalar_field(folder_.path() / "case/constant/Cz");
  const auto middle = [&](const char* time) {
    const std::vector<double> grains = read_scalar_field(folder_.path() / "case" / time / "grains");
    return std::inner_product(z.begin(), z.end(), grains.begin(), 0.0) /
           std::accumulate(grains.begin(), grains.end(), 0.0);
  };
  const double d_star = dimensionless_diameter(0.0005, 1600.0, 1000.0, 9.81, 1e-3);
  const double soulsby = settling_velocity(d_star, 0.0005, 1e-6);  // 0.042 m/s: 8 mm between the two
  EXPECT_NEAR((middle("0.2") - middle("0.4")) / 0.2 / soulsby, 1, 0.01);
}

TEST_F(FoamLibraryTest, HasTheSameBedOnTwoRanks) {
  Case scene = small_dam_break();
  scene.output.end = 0.1;
  scene.compare.times = {0.1};
  run(scene, FoamModel::eroding_bed);
  const Profile serial = profile(0.1);
  run(scene, FoamModel::eroding_bed, 2);
  const Profile parallel = profile(0.1);
  EXPECT_LT(std::abs(summary("grains_volume_error")), 1e-6);
  ASSERT_EQ(serial.x.size(), parallel.x.size());
  for (std::size_t i = 0; i < serial.x.size(); ++i) {
    // The pressure is solved to 1e-7 Pa in another order: far below a grain.
    EXPECT_NEAR(serial.moving_bed[i], parallel.moving_bed[i], 1e-5);
    EXPECT_NEAR(serial.bed[i], parallel.bed[i], 1e-5);
  }
}

// A slab of three columns' width between slip-free ends would feel its side walls; periodic, it is the 2-D scene.
TEST_F(FoamLibraryTest, HasTheSameBedInASlabOfThreeDimensions) {
  Case scene = small_dam_break();
  scene.output.end = 0.1;
  scene.compare.times = {0.1};
  run(scene, FoamModel::eroding_bed);
  const Profile plane = profile(0.1);
  scene.info.dimension = 3;
  for (Shape& shape : scene.shapes) shape.to.y() = 0.03;
  scene.domain.to.y() = 0.03;
  scene.domain.periodic = {"y"};
  run(scene, FoamModel::eroding_bed);
  EXPECT_EQ(summary("cells"), 3 * 40 * 15);
  EXPECT_LT(std::abs(summary("grains_volume_error")), 1e-6);
  const Profile slab = profile(0.1);
  for (std::size_t i = 0; i < plane.x.size(); ++i) EXPECT_NEAR(slab.moving_bed[i], plane.moving_bed[i], 1e-5);
}

}  // namespace
}  // namespace thalweg::foam
