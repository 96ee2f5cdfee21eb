// The sediment of libthalwegFoam as a phase, in the real OpenFOAM.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "foam_reference/field_file.hpp"
#include "physics/sediment/effective_pressure.hpp"
#include "physics/sediment/material.hpp"
#include "tests/foam_reference/library_fixture.hpp"

namespace thalweg::foam {
namespace {

std::string list_of(const std::vector<double>& values, const char* form) {
  std::string text =
      fmt::format("nonuniform List<{}> {}(", std::string(form) == "{}" ? "scalar" : "vector", values.size());
  for (const double value : values) text += fmt::format(fmt::runtime(form), value) + " ";
  return text + ")";
}

// A share of sediment and a shear rate for each of twenty cells.
struct States {
  std::vector<double> shares;  // [-]
  std::vector<double> rates;   // [1/s], 1e-3 to 1e3
};

States twenty_states() {
  States states;
  for (int i = 0; i < 20; ++i) {
    states.shares.push_back(0.4 + 0.6 * (7 * i % 20) / 19.0);
    states.rates.push_back(std::pow(10.0, -3 + 6.0 * (3 * i % 20) / 19));
  }
  return states;
}

// Twenty cells of 10 mm beside each other, one high, in these states; a lid that moves shears them.
CaseFiles row_of_cells(FoamCase one_row, const States& states) {
  one_row.plan.low = Vec3(0, -0.5, 0);
  one_row.plan.high = Vec3(0.2, 0.5, 0.01);
  one_row.plan.cells = {20, 1, 1};
  std::vector<double> rest, speeds;
  for (const double share : states.shares) rest.push_back(1 - share);
  for (const double rate : states.rates) speeds.push_back(rate * 0.01);
  CaseFiles files = case_files(one_row);
  files["system/setFieldsDict"] =
      "FoamFile { version 2.0; format ascii; class dictionary; object setFieldsDict; }\n"
      "defaultFieldValues (); regions ();\n";
  replace(files["0.orig/alpha.sediment"], "uniform 0", list_of(states.shares, "{}"));
  replace(files["0.orig/alpha.water"], "uniform 0", list_of(rest, "{}"));
  replace(files["0.orig/alpha.air"], "uniform 1", "uniform 0");
  replace(files["0.orig/U"], "type pressureInletOutletVelocity; value uniform (0 0 0)",
          "type fixedValue; value " + list_of(speeds, "({:.17g} 0 0)"));
  fix_step(files["system/controlDict"], "1e-6");
  return files;
}

// Effective pressure [Pa] in a cell of that row: 1300 - 1000 kg/m^3 times 9.81 m/s^2 is 2943 N/m^3.
double pressure_in(const States& states, std::size_t i, double friction_angle) {
  const double level = states.shares[i] * 0.01;
  const double before = i > 0 ? states.shares[i - 1] * 0.01 : level;
  const double after = i < 19 ? states.shares[i + 1] * 0.01 : level;
  const double run_length = i > 0 && i < 19 ? 0.02 : 0.01;
  const double slope = std::min(std::abs(after - before) / run_length, std::tan(friction_angle));
  return effective_pressure_of_column(2943.0, std::max(0.0, level - 0.005), 1 / (1 + slope * slope));
}

// Twenty states of effective pressure and shear rate, in which OpenFOAM's viscosity is the particle model's law.
TEST_F(FoamLibraryTest, HasTheParticleModelsViscosityInTwentyStates) {
  const States states = twenty_states();
  struct Choices {
    MaterialChoices laws;
    double flow_index;
  };
  for (const auto& [laws, flow_index] :
       {Choices{{YieldCriterion::drucker_prager, YieldFit::sine, Rheology::herschel_bulkley}, 1.0},
        Choices{{YieldCriterion::drucker_prager, YieldFit::sine, Rheology::herschel_bulkley}, 1.8},
        Choices{{YieldCriterion::drucker_prager, YieldFit::outer, Rheology::herschel_bulkley}, 1.0},
        Choices{{YieldCriterion::drucker_prager, YieldFit::outer, Rheology::herschel_bulkley}, 1.8},
        Choices{{YieldCriterion::drucker_prager, YieldFit::outer, Rheology::mu_of_i}, 1.0},
        Choices{{YieldCriterion::mohr_coulomb, YieldFit::sine, Rheology::mu_of_i}, 1.0}}) {
    Case scene = still_tank();
    scene.model.yield = laws.yield;
    scene.model.yield_fit = laws.yield_fit;
    scene.model.rheology = laws.rheology;
    SedimentParameters& sand = scene.sediments["sand"];
    sand.cohesion = 2;
    sand.flow_index = flow_index;
    sand.consistency = 0.3;
    sand.dynamic_friction_angle = 0.7;
    scene.output.end = 1e-6;
    scene.compare.times = {1e-6};
    run_files(row_of_cells(foam_case(scene, FoamModel::same_material), states), 1e-6, "multiphaseInterFoam");

    const std::vector<double> nu = read_scalar_field(folder_.path() / "case/1e-06/nu.sediment");
    ASSERT_EQ(nu.size(), 20U);
    const auto material = make_material<double>(sand, laws);
    for (std::size_t i = 0; i < 20; ++i) {
      const double pressure = pressure_in(states, i, sand.friction_angle);
      const double yield_stress = yield_stress_of(material, pressure, 0.0);  // the shear is plane
      const double eta = apparent_viscosity_of(material, states.rates[i], yield_stress, pressure, 0.0);
      EXPECT_NEAR(nu[i] * 1300 / eta, 1, 1e-10) << "share " << states.shares[i] << ", rate " << states.rates[i];
    }
    fs::remove_all(folder_.path() / "case");
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

}  // namespace
}  // namespace thalweg::foam
