#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/solver/case_run.hpp"

namespace thalweg {
namespace {

/// Largest rise of the total energy above its first value [J].
double largest_gain(const CsvTable& history) {
  const auto kinetic = history.numbers("kinetic_energy", "J");
  const auto potential = history.numbers("potential_energy", "J");
  const auto internal = history.numbers("internal_energy", "J");
  double gain = 0;
  for (std::size_t i = 1; i < kinetic.size(); ++i) {
    gain = std::max(gain, kinetic[i] + potential[i] + internal[i] - (kinetic[0] + potential[0] + internal[0]));
  }
  return gain;
}

double total_mass(const CsvTable& history) {
  return history.numbers("water_mass", "kg")[0] + history.numbers("sediment_mass", "kg")[0];
}

TEST(StillWater, DoesNotGainEnergyWithoutDensityDiffusion) {
  test::CaseRun run("still_conservative");
  run.fill("still_water", {"numerics.density_diffusion=0", "output.end=\"0.4 s\"", "compare.times=[]"});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const CsvTable history = CsvTable::read(run.folder().history());
  EXPECT_LT(largest_gain(history), test::limit_of("still_water", "energy_gain_without_diffusion") *
                                       history.numbers("potential_energy", "J")[0]);
}

TEST(StillWater, TwoLayersStayAtRestForTwoSeconds) {
  test::CaseRun run("still_water");
  run.fill("still_water", {});
  ASSERT_EQ(run.scene().output.end, 2);
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const ParticleSet end = run.snapshot_at(2);
  ASSERT_EQ(end.size(), run.start().size()) << "a particle was lost";

  std::map<std::int64_t, Vec3> before;
  for (std::size_t i = 0; i < run.start().size(); ++i) before[run.start().id[i]] = run.start().position[i];
  const double dp = run.scene().numerics.spacing;
  const double surface = 0.16;
  const double bed = 0.06;
  const double g = 9.81;
  const double rho_bed = run.scene().sediment().bed_density();

  const double most_displacement = test::limit_of("still_water", "sediment_displacement") * dp;
  double speed2 = 0;
  double error2 = 0;
  double scale2 = 0;
  int water = 0;
  int fluid = 0;
  for (std::size_t i = 0; i < end.size(); ++i) {
    if (end.type[i] == ParticleType::wall) continue;
    const double z = end.position[i].z();
    const double expected = z > bed ? 1000 * g * (surface - z) : 1000 * g * (surface - bed) + rho_bed * g * (bed - z);
    error2 += std::pow(double(end.pressure[i]) - expected, 2);
    scale2 += expected * expected;
    ++fluid;
    if (end.type[i] == ParticleType::water) {
      speed2 += double(end.velocity[i].squaredNorm());
      ++water;
    } else {
      EXPECT_LT((end.position[i] - before.at(end.id[i])).norm(), most_displacement)
          << "sediment particle " << end.id[i];
    }
  }
  EXPECT_LT(std::sqrt(speed2 / water), test::limit_of("still_water", "water_speed") * std::sqrt(g * surface));
  EXPECT_LT(std::sqrt(error2 / scale2), test::limit_of("still_water", "pressure"));
  RecordProperty("water_rms_speed", std::to_string(std::sqrt(speed2 / water)));
  RecordProperty("pressure_error", std::to_string(std::sqrt(error2 / scale2)));

  // DoesNotGainEnergyWithoutDensityDiffusion is the strict form.
  const CsvTable history = CsvTable::read(run.folder().history());
  EXPECT_LT(largest_gain(history), total_mass(history) * g * test::limit_of("still_water", "energy_gain") * dp);
  const auto water_mass = history.numbers("water_mass", "kg");
  const auto sediment_mass = history.numbers("sediment_mass", "kg");
  for (std::size_t i = 1; i < water_mass.size(); ++i) {
    EXPECT_EQ(water_mass[i], water_mass[0]);
    EXPECT_EQ(sediment_mass[i], sediment_mass[0]);
  }
}

}  // namespace
}  // namespace thalweg
