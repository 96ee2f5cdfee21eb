#include <gmock/gmock.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>

#include "common/error.hpp"
#include "common/run_lock.hpp"
#include "solver/program/checkpoint_file.hpp"
#include "solver/program/restart_check.hpp"
#include "tests/solver/case_run.hpp"

// Restarts: what a checkpoint has to be, and what a run's folder is mended to.
namespace thalweg {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::vector<std::string> short_louvain = {"numerics.spacing=\"20 mm\"", "output.end=\"0.04 s\"",
                                                "output.interval=\"0.01 s\"", "compare.times=[]"};

/// One half run for all tests; each works on a copy of its folder.
class DurableRun : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    half_run = new test::CaseRun("half_run");
    half_run->fill("louvain", short_louvain);
    RunOptions half = half_run->options();
    half.until = "0.02 s";
    ASSERT_EQ(run_solver(half), Exit::done);
  }
  static void TearDownTestSuite() { delete half_run; }

  DurableRun() { std::filesystem::copy(half_run->folder().root, run.folder().root, recursive); }

  RunOptions restart(const std::filesystem::path& from = "latest") const {
    RunOptions options = run.options();
    options.restart = from;
    return options;
  }
  RunOptions restart_with(const std::string& override) const {
    RunOptions options = restart();
    options.overrides = {override};
    return options;
  }
  static std::string refusal_of(const RunOptions& options) {
    try {
      run_solver(options);
    } catch (const InputError& error) {
      EXPECT_LE(std::string(error.what()).size(), 300U);
      return error.what();
    }
    return "it ran";
  }
  /// The checkpoint, changed by someone who also writes a fitting seal.
  template <class Change>
  void forge(const Change& change) const {
    Checkpoint checkpoint = read_checkpoint(run.folder().checkpoint());
    change(checkpoint);
    write_checkpoint(run.folder(), checkpoint);
    std::filesystem::remove(run.folder().previous_checkpoint());
  }
  std::size_t rows() const { return CsvTable::read(run.folder().history()).rows(); }

  static constexpr auto recursive =
      std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing;
  static inline test::CaseRun* half_run = nullptr;
  test::CaseRun run{"durable_run"};
};

TEST_F(DurableRun, RefusesAnotherMaterialModelAndScene) {
  EXPECT_THAT(refusal_of(restart_with("materials.pvc.grain_density=\"2650 kg/m^3\"")),
              AllOf(HasSubstr("materials.pvc.grain_density"), HasSubstr("1540"), HasSubstr("2650")));
  EXPECT_THAT(refusal_of(restart_with("model.sediment=viscoplastic")), HasSubstr("model.sediment"));
  EXPECT_THAT(refusal_of(restart_with("domain.gravity=[\"0 m/s^2\", \"-1.62 m/s^2\"]")), HasSubstr("domain.gravity"));
}

TEST_F(DurableRun, ChangesWhatMayChangeWhereItIsNamed) {
  RunOptions other = restart_with("numerics.cfl=0.3");
  EXPECT_THAT(refusal_of(other), HasSubstr("numerics.cfl 0.5 -> 0.3; set them back, or go on with --restart-anyway "
                                           "numerics.cfl"));
  other.restart_anyway = {"numerics.spacing"};
  EXPECT_THAT(refusal_of(other), HasSubstr("--restart-anyway numerics.spacing: no key that may change"));
  other.restart_anyway = {"numerics.cfl"};
  EXPECT_EQ(run_solver(other), Exit::done);
}

TEST_F(DurableRun, GoesOnWithOtherOutputThreadsAndInstructions) {
  RunOptions other = restart_with("output.interval=\"0.005 s\"");
  other.threads = 2;
  other.instruction_set = "baseline";
  EXPECT_EQ(run_solver(other), Exit::done);
}

TEST_F(DurableRun, RefusesAnIncompleteCheckpoint) {
  const auto refused = [&](auto change, const std::string& named) {
    forge(change);
    EXPECT_THAT(refusal_of(restart()), HasSubstr(named));
    std::filesystem::copy(half_run->folder().root, run.folder().root, recursive);
  };
  refused([](Checkpoint& c) { c.particles.info.time = -1; }, "TimeValue in its field data is -1;");
  refused([](Checkpoint& c) { c.particles.info.code_version = "9.9.9"; }, "version 9.9.9");
  refused([](Checkpoint& c) { c.particles.id[1] = c.particles.id[0]; }, "two particles have the id");
  refused([](Checkpoint& c) { c.particles.mass[0] = NAN; }, "its mass is nan kg");
  refused([](Checkpoint& c) { c.particles.position[1] = c.particles.position[0]; }, "it lies in the place of particle");
  refused([](Checkpoint& c) { c.particles.info.spacing = NAN; }, "Spacing in its field data is nan;");
}

// Arrays that are left out, or the half of all particles, as a tool that rewrites the file would do.
TEST_F(DurableRun, RefusesArraysThatAreMissing) {
  std::map<std::string, std::string> texts;
  ParticleSet particles = read_particles(run.folder().checkpoint(), &texts);
  particles.doubles.erase("SedimentState");
  write_particles(run.folder().checkpoint(), particles, PositionPrecision::double_precision, texts);
  EXPECT_THAT(refusal_of(restart()), HasSubstr("is incomplete: it should hold SedimentState"));
  particles.velocity.clear();
  write_particles(run.folder().checkpoint(), particles, PositionPrecision::double_precision, texts);
  EXPECT_THAT(refusal_of(restart()), HasSubstr("is incomplete: it should hold Velocity"));
  EXPECT_THAT(refusal_of(restart(run.folder().snapshots() / "s00001.vtp")), HasSubstr("is no checkpoint"));
}

// A bit anywhere: in the header, in an array, in the seal.
TEST_F(DurableRun, RefusesADamagedCheckpointWhereverTheDamageIs) {
  std::ifstream whole(run.folder().checkpoint(), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(whole), {}};
  for (std::size_t n = 0; n < 100; ++n) {
    std::string damaged = bytes;
    const std::size_t at = n * (bytes.size() - 1) / 99;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << (n % 8)));
    if (n % 10 == 9) damaged.resize(at);
    std::ofstream(run.folder().checkpoint(), std::ios::binary) << damaged;
    ASSERT_THROW(read_checkpoint(run.folder().checkpoint()), InputError) << "byte " << at << " of " << bytes.size();
  }
}

TEST_F(DurableRun, FallsBackOnTheCheckpointBefore) {
  RunOptions further = restart();
  further.until = "0.03 s";
  ASSERT_EQ(run_solver(further), Exit::done);
  EXPECT_EQ(read_checkpoint(run.folder().previous_checkpoint()).particles.info.time, 0.02);
  std::filesystem::resize_file(run.folder().checkpoint(), 1000);
  EXPECT_EQ(run_solver(restart()), Exit::done);
  EXPECT_EQ(read_series(run.folder().snapshot_series()).size(), 5U);
}

TEST_F(DurableRun, StartsWhereThereIsNoCheckpointYet) {
  std::filesystem::remove_all(run.folder().snapshots());
  std::filesystem::remove(run.folder().snapshot_series());
  std::filesystem::remove(run.folder().checkpoint());
  EXPECT_EQ(run_solver(restart()), Exit::done);
  EXPECT_EQ(read_series(run.folder().snapshot_series()).size(), 5U);
}

TEST_F(DurableRun, MendsATornRowAndAMissingSeries) {
  const std::size_t rows_before = rows();
  std::ofstream(run.folder().history(), std::ios::app) << "0.0199,999,1e-4,sou";
  std::filesystem::remove(run.folder().snapshot_series());
  RunOptions at_once = restart();
  at_once.until = "0.0201 s";
  ASSERT_EQ(run_solver(at_once), Exit::done);
  EXPECT_GE(rows(), rows_before);
  const auto series = read_series(run.folder().snapshot_series());
  ASSERT_EQ(series.size(), 4U) << "0, 0.01, 0.02 s of the first part, and the new end";
  for (const auto& entry : series) EXPECT_TRUE(std::filesystem::exists(run.folder().root / entry.file)) << entry.file;
}

// A cut row that happens to have all its cells has no end of line; a merged one has too many cells.
TEST_F(DurableRun, KeepsNoRowThatWasCutOrMerged) {
  std::ifstream file(run.folder().history());
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::string last = text.substr(text.rfind('\n', text.size() - 2) + 1);
  const std::size_t rows_before = rows();
  std::ofstream(run.folder().history(), std::ios::app) << last.substr(0, 9) << last << last.substr(0, last.size() - 2);
  RunOptions at_once = restart();
  at_once.until = "0.0201 s";
  ASSERT_EQ(run_solver(at_once), Exit::done);
  const auto step = CsvTable::read(run.folder().history()).numbers("step", "-");
  ASSERT_GE(step.size(), rows_before);
  for (std::size_t i = 1; i < step.size(); ++i) EXPECT_GT(step[i], step[i - 1]);
}

TEST_F(DurableRun, DoesNotReplaceARunUnasked) {
  EXPECT_THAT(refusal_of(run.options()), HasSubstr("holds a run up to t = 0.02 s; continue it with --restart latest"));
  EXPECT_EQ(read_series(run.folder().snapshot_series()).size(), 3U);
  RunOptions forced = run.options();
  forced.force = true;
  EXPECT_EQ(run_solver(forced), Exit::done);
  EXPECT_EQ(read_series(run.folder().snapshot_series()).size(), 5U);
  EXPECT_FALSE(std::filesystem::exists(run.folder().previous_checkpoint())) << "of the run before";
}

TEST_F(DurableRun, WaitsForNoOtherProgram) {
  const RunLock lock(run.folder().root, "thalweg-solver");
  EXPECT_THAT(refusal_of(restart()), HasSubstr("is at work there"));
}

TEST_F(DurableRun, AddsTheCostsOfAllParts) {
  const auto summary = [&](const std::string& quantity) {
    const CsvTable table = CsvTable::read(run.folder().summary());
    const auto names = table.texts("quantity");
    const auto at = std::find(names.begin(), names.end(), quantity) - names.begin();
    return std::stod(table.texts("value")[static_cast<std::size_t>(at)]);
  };
  const double wall = summary("wall_seconds");
  const double steps = summary("steps");
  forge([](Checkpoint& c) { c.counts.viscous_retries = 7, c.counts.wall_seconds += 100, c.counts.cpu_seconds += 90; });
  ASSERT_EQ(run_solver(restart()), Exit::done);
  EXPECT_EQ(summary("viscous_retries"), 7);
  EXPECT_GT(summary("wall_seconds"), wall + 100 - 0.01);
  EXPECT_GT(summary("cpu_seconds"), 90);
  EXPECT_EQ(summary("steps_since_restart"), summary("steps") - steps);
  EXPECT_EQ(summary("restarts"), 1);
  // All steps over all seconds: 625 particles in 100 s and more.
  EXPECT_LT(summary("particle_steps_per_second"), 625 * summary("steps") / 100 * 1.01);
}

TEST_F(DurableRun, RefusesMoreSnapshotsThanFit) {
  EXPECT_THAT(refusal_of(restart_with("output.interval=\"1e-9 s\"")), HasSubstr("4e+07 snapshots"));
}

TEST(RestartRules, AreListedInTheDocumentation) {
  std::ifstream file(THALWEG_SOURCE_DIR "/docs/file-formats.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  for (const RestartRule& rule : restart_rules) {
    EXPECT_THAT(text, HasSubstr(std::string("| `") + rule.key + "` | " + (rule.asked ? "yes" : "no") + " |"));
  }
}

}  // namespace
}  // namespace thalweg
