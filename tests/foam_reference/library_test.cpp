// libthalwegFoam in the real OpenFOAM; skipped, visibly, where either cannot be had.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

#include "common/csv.hpp"
#include "common/error.hpp"
#include "common/profile.hpp"
#include "foam_reference/field_file.hpp"
#include "foam_reference/foam_library.hpp"
#include "foam_reference/reference_run.hpp"
#include "physics/sediment/herschel_bulkley.hpp"
#include "physics/transport/bed_load.hpp"
#include "physics/transport/bed_shear.hpp"
#include "physics/transport/critical_shields.hpp"
#include "physics/transport/lift_settling.hpp"
#include "tests/foam_reference/small_scene.hpp"
#include "tests/foam_reference/temporary_folder.hpp"

namespace thalweg::foam {
namespace {

namespace fs = std::filesystem;

class FoamLibraryTest : public testing::Test {
 protected:
  void SetUp() override {
    try {
      require_openfoam();
    } catch (const InputError& error) {
      GTEST_SKIP() << error.what();
    }
    const auto library = foam_library();
    if (!library) GTEST_SKIP() << "libthalwegFoam cannot be had here (tools/foam-library says why)";
    library_ = *library;
  }

  [[nodiscard]] FoamCase foam_case(const Case& scene, FoamModel model, int ranks = 1) const {
    return make_foam_case(scene, ranks, model, library_);
  }

  void run(const Case& scene, FoamModel model, int ranks = 1) {
    ASSERT_EQ(reference_run(foam_case(scene, model, ranks), folder_.path()), Reference::computed);
  }

  // Runs a case whose files a test has changed.
  void run_files(CaseFiles files, double end, const std::string& application) {
    for (const auto& [name, text] : files) folder_.write("case" / name, text);
    run_foam(folder_.path() / "case", end, application);
  }

  [[nodiscard]] double summary(const std::string& quantity) const {
    const CsvTable table = CsvTable::read(folder_.path() / "summary.csv");
    const auto quantities = table.texts("quantity");
    const auto found = std::ranges::find(quantities, quantity);
    if (found != quantities.end()) {
      return std::stod(table.texts("value")[static_cast<std::size_t>(found - quantities.begin())]);
    }
    ADD_FAILURE() << "no row " << quantity;
    return 0;
  }

  [[nodiscard]] Profile profile(double time) const {
    return read_profile(folder_.path() / "profiles" / profile_file_name(time));
  }

  // The eroding bed's table at a time: a row a column.
  [[nodiscard]] std::vector<std::vector<double>> columns(const std::string& time) const {
    std::ifstream stream(folder_.path() / "case/postProcessing/bed" / time / "columns.dat");
    std::vector<std::vector<double>> rows;
    for (std::string line; std::getline(stream, line);) {
      if (line.starts_with("#")) continue;
      std::istringstream text(line);
      rows.emplace_back();
      for (double value = 0; text >> value;) rows.back().push_back(value);
    }
    return rows;
  }

  TemporaryFolder folder_;
  fs::path library_;
};

void replace(std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from << " in\n" << text;
  text.replace(at, from.size(), to);
}

void fix_step(std::string& control, const std::string& step) {
  replace(control, "adjustTimeStep  yes;", "adjustTimeStep  no;");
  const std::size_t at = control.find("deltaT  ");
  control.replace(at, control.find(';', at) - at, "deltaT  " + step);
}

std::string list_of(const std::vector<double>& values, const char* form) {
  std::string text =
      fmt::format("nonuniform List<{}> {}(", std::string(form) == "{}" ? "scalar" : "vector", values.size());
  for (const double value : values) text += fmt::format(fmt::runtime(form), value) + " ";
  return text + ")";
}

// Half the water of the tank falls over the bed.
Case small_dam_break() {
  Case scene = still_tank();
  scene.shapes[2].to.x() = 0.15;
  scene.output.end = 0.2;
  scene.compare.times = {0.2};
  return scene;
}

// Twenty cells beside each other, one high, each with a share of sediment and a lid that moves at its own speed: twenty
// states of effective pressure and shear rate, in which OpenFOAM's viscosity is the particle model's law.
TEST_F(FoamLibraryTest, HasTheParticleModelsViscosityInTwentyStates) {
  for (const YieldFit fit : {YieldFit::sine, YieldFit::outer}) {
    for (const double flow_index : {1.0, 1.8}) {
      Case scene = still_tank();
      scene.model.yield_fit = fit;
      SedimentParameters& sand = scene.sediments["sand"];
      sand.cohesion = 2;
      sand.flow_index = flow_index;
      sand.consistency = 0.3;
      scene.output.end = 1e-6;
      scene.compare.times = {1e-6};
      FoamCase one_row = foam_case(scene, FoamModel::same_material);
      one_row.plan.low = Vec3(0, -0.5, 0);
      one_row.plan.high = Vec3(0.2, 0.5, 0.01);
      one_row.plan.cells = {20, 1, 1};
      std::vector<double> shares, rates, rest, speeds;
      for (int i = 0; i < 20; ++i) {
        shares.push_back(0.4 + 0.6 * (7 * i % 20) / 19.0);
        rates.push_back(std::pow(10.0, -3 + 6.0 * (3 * i % 20) / 19));  // 1e-3 to 1e3 1/s
        rest.push_back(1 - shares.back());
        speeds.push_back(rates.back() * 0.01);
      }
      CaseFiles files = case_files(one_row);
      files["system/setFieldsDict"] =
          "FoamFile { version 2.0; format ascii; class dictionary; object setFieldsDict; }\n"
          "defaultFieldValues (); regions ();\n";
      replace(files["0.orig/alpha.sediment"], "uniform 0", list_of(shares, "{}"));
      replace(files["0.orig/alpha.water"], "uniform 0", list_of(rest, "{}"));
      replace(files["0.orig/alpha.air"], "uniform 1", "uniform 0");
      replace(files["0.orig/U"], "type pressureInletOutletVelocity; value uniform (0 0 0)",
              "type fixedValue; value " + list_of(speeds, "({:.17g} 0 0)"));
      fix_step(files["system/controlDict"], "1e-6");
      run_files(files, 1e-6, "multiphaseInterFoam");

      const std::vector<double> nu = read_scalar_field(folder_.path() / "case/1e-06/nu.sediment");
      ASSERT_EQ(nu.size(), 20U);
      const double K = yield_pressure_coefficient(sand.friction_angle, fit);
      for (std::size_t i = 0; i < 20; ++i) {
        const double level = shares[i] * 0.01;
        const double before = i > 0 ? shares[i - 1] * 0.01 : level;
        const double after = i < 19 ? shares[i + 1] * 0.01 : level;
        const double run_length = i > 0 && i < 19 ? 0.02 : 0.01;
        const double slope = std::min(std::abs(after - before) / run_length, std::tan(sand.friction_angle));
        // (1300 - 1000) kg/m^3 * 9.81 m/s^2 = 2943 N/m^3
        const double pressure =
            effective_pressure_of_column(2943.0, std::max(0.0, level - 0.005), 1 / (1 + slope * slope));
        const double yield_stress = K * pressure + yield_cohesion_term(2.0, sand.friction_angle, fit);
        const double eta = herschel_bulkley_viscosity(rates[i], yield_stress, 100.0, 0.3, flow_index);
        EXPECT_NEAR(nu[i] * 1300 / eta, 1, 1e-10) << "share " << shares[i] << ", rate " << rates[i];
      }
      fs::remove_all(folder_.path() / "case");
    }
  }
}

TEST_F(FoamLibraryTest, ConservesWaterAndSedimentOfOneMaterial) {
  run(small_dam_break(), FoamModel::same_material);
  EXPECT_LT(std::abs(summary("water_volume_error")), 1e-4);
  EXPECT_LT(std::abs(summary("sediment_volume_error")), 1e-4);
  EXPECT_GT(std::ranges::max(profile(0.2).bed), 0.0505);  // something has moved
}

// Every closure of the effective pressure keeps a flat bed under still water where it is.
TEST_F(FoamLibraryTest, KeepsLayersAtRestWithEveryEffectivePressure) {
  for (const EffectivePressure closure :
       {EffectivePressure::column, EffectivePressure::laplace, EffectivePressure::eos}) {
    Case scene = still_tank();
    scene.model.effective_pressure = closure;
    run(scene, FoamModel::same_material);
    EXPECT_THAT(profile(0.1).bed, testing::Each(testing::DoubleNear(0.05, 1e-3)));
  }
}

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
