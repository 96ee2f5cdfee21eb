#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "common/error.hpp"
#include "tests/solver/program/broken_run.hpp"

// The choices a case has for the sediment, each on a coarse Louvain dam-break.
namespace thalweg {
namespace {

using testing::HasSubstr;

/// A coarse and short run with these choices, as overrides.
std::vector<std::string> short_run(std::vector<std::string> choices, const std::string& end = "0.1 s") {
  choices.insert(choices.end(), {"numerics.spacing=\"20 mm\"", "output.end=\"" + end + "\"",
                                 "output.interval=\"0.05 s\"", "compare.times=[]"});
  return choices;
}

/// The run with these choices; its particles at the end are read from the checkpoint.
class LouvainRun : public test::CaseRun {
 public:
  LouvainRun(const std::string& name, const std::vector<std::string>& choices, const std::string& end = "0.1 s")
      : CaseRun("choices_" + name) {
    fill("louvain", short_run(choices, end));
  }

  ParticleSet end() const { return read_particles(folder().checkpoint()); }
  std::vector<double> history(const char* column) const {
    return CsvTable::read(folder().history()).numbers(column, "-");
  }
};

ParticleSet end_of(const std::string& name, const std::vector<std::string>& choices, const std::string& end = "0.1 s") {
  const LouvainRun run(name, choices, end);
  EXPECT_EQ(run_solver(run.options()), Exit::done) << name;
  return run.end();
}

/// Root mean square distance between the sediment of two runs [m].
double sediment_distance(const ParticleSet& a, const ParticleSet& b) {
  std::map<std::int64_t, Vec3> place;
  for (std::size_t i = 0; i < b.size(); ++i) place[b.id[i]] = b.position[i];
  double squares = 0;
  double count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a.type[i] != ParticleType::sediment) continue;
    squares += (a.position[i] - place.at(a.id[i])).squaredNorm();
    count += 1;
  }
  return std::sqrt(squares / count);
}

TEST(ModelChoices, ExplicitViscosityGivesWhatTheImplicitGives) {
  // Ten times shorter steps, 3 mm of motion. With the implicit steps ever shorter the difference goes to zero with
  // them: 3.2 % of the motion at a Courant number of 0.5, 2.0 at 0.35, 0.9 at 0.2, 0.3 at 0.1.
  const LouvainRun run("explicit", {"numerics.viscosity=explicit"});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const ParticleSet implicit = end_of("implicit", {"numerics.cfl=0.2"});
  const double moved = sediment_distance(implicit, run.start());
  EXPECT_GT(moved, 2e-3);
  EXPECT_LT(sediment_distance(implicit, run.end()), 0.012 * moved);
  const auto limiter = CsvTable::read(run.folder().history()).texts("dt_limiter");
  EXPECT_EQ(limiter.front(), "viscosity");
}

TEST(ModelChoices, CappedViscosityCountsWhatItCut) {
  const LouvainRun run("capped", {"numerics.viscosity=capped"});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  for (const double capped : run.history("viscosity_capped")) EXPECT_GT(capped, 0);
}

TEST(ModelChoices, MohrCoulombInThePlaneIsTheConeOfPlaneStrain) {
  const ParticleSet cone = end_of("cone", {});
  const ParticleSet hexagon = end_of("hexagon", {"model.yield=mohr-coulomb"});
  EXPECT_EQ(sediment_distance(cone, hexagon), 0);
}

// In the first tenth of a second the bed hardly shears, and runs differ by more than the laws do.
TEST(ModelChoices, GrowingFrictionSlowsTheBed) {
  const LouvainRun run("mu_of_i", {"model.rheology=mu-of-i", "materials.pvc.dynamic_friction_angle=\"60 deg\""},
                       "0.3 s");
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  EXPECT_LT(sediment_distance(run.end(), run.start()),
            sediment_distance(end_of("one_friction", {}, "0.3 s"), run.start()));
}

TEST(ModelChoices, StrengthFromTheStateStopsTheBed) {
  // 344 Pa under 0.1 m of water where the bed's own weight is 168 Pa at its floor (docs/theory.md).
  const LouvainRun run("eos", {"model.effective_pressure=eos"});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  EXPECT_LT(sediment_distance(run.end(), run.start()), 0.9 * sediment_distance(end_of("column", {}), run.start()));
}

TEST(ModelChoices, LaplacePressureContinuesBitForBit) {
  test::TwoEnds ends;
  ASSERT_NO_FATAL_FAILURE(test::run_with_a_break(test::case_folder("louvain"),
                                                 short_run({"model.effective_pressure=laplace"}), "0.05 s", ends));
}

TEST(ViscousFallback, GoesOnWithShorterStepsAndCountsThem) {
  const LouvainRun run("few_iterations", {"numerics.viscous_iterations=3"});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  EXPECT_GT(run.history("viscous_retries").back(), 0);
  for (const double residual : run.history("viscous_residual")) EXPECT_LE(residual, 1e-3);
}

TEST(ViscousFallback, StopsWithADiagnosisWhenNothingHelps) {
  const LouvainRun run("one_iteration", {"numerics.viscous_iterations=1", "numerics.viscous_tolerance=1e-6"});
  try {
    run_solver(run.options());
    FAIL() << "it did not stop";
  } catch (const RunError& e) {
    EXPECT_THAT(e.what(), HasSubstr("the implicit viscosity did not converge, not even with the step halved"));
    EXPECT_THAT(e.what(), HasSubstr("numerics.viscous_iterations"));
  }
  for (const auto& u : read_particles(run.folder().root / "diverged.vtp").velocity) EXPECT_TRUE(u.allFinite());
}

}  // namespace
}  // namespace thalweg
