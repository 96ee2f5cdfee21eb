#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "common/error.hpp"
#include "measures.hpp"
#include "suite.hpp"
#include "tests/solver/case_run.hpp"

// Runs every case of cases/stability/suite.toml and compares its measures with their bounds. Writes both to the table
// <build>/stability/<case>.csv, from which docs/stability.md is made.
namespace thalweg::test {
namespace {

std::string bound_text(const Bound& b) {
  if (b.at_least == b.at_most) return csv_number(b.at_most);
  if (std::isinf(b.at_least)) return "<= " + csv_number(b.at_most);
  if (std::isinf(b.at_most)) return ">= " + csv_number(b.at_least);
  return csv_number(b.at_least) + " to " + csv_number(b.at_most);
}

/// The results of one case.
class Results {
 public:
  explicit Results(std::string name)
      : name_(std::move(name)),
        table_({{"case", ""},
                {"particles", "-"},
                {"steps", "-"},
                {"cpu", "s"},
                {"measure", ""},
                {"value", ""},
                {"unit", ""},
                {"bound", ""},
                {"holds", ""}}) {}

  void add(const FinishedRun& run, const std::string& measure, double value, const std::string& unit,
           const std::string& bound, bool holds) {
    table_.add_row({name_, csv_number(run.fluid_particles), csv_number(run.steps),
                    fmt::format("{:.1f}", run.cpu_seconds), measure, fmt::format("{:.3g}", value), unit, bound,
                    holds ? "yes" : "no"});
  }
  void write() const { table_.write(std::filesystem::path(THALWEG_STABILITY_RESULTS) / (name_ + ".csv")); }

 private:
  std::string name_;
  CsvTable table_;
};

void run_to_the_end(const StabilityCase& c) {
  CaseRun scene("stability_" + c.name);
  scene.fill("stability/" + c.scene, c.set);
  RunOptions options = scene.options();
  options.threads = 1;
  ASSERT_EQ(run_solver(options), Exit::done);
  const FinishedRun run = read_run(scene.scene(), scene.start(), scene.folder().root);
  Results results(c.name);
  for (const auto& [name, bound] : c.bounds) {
    const auto measure = measures().find(name);
    ASSERT_NE(measure, measures().end()) << "suite.toml bounds " << name << ", which is no measure";
    const double value = measure->second.of(run);
    EXPECT_TRUE(bound.holds(value)) << name << " is " << value << " " << measure->second.unit << ", has to be "
                                    << bound_text(bound) << ": " << bound.why;
    results.add(run, name, value, measure->second.unit, bound_text(bound), bound.holds(value));
  }
  results.write();
}

void stop_with_diagnosis(const StabilityCase& c) {
  CaseRun scene("stability_" + c.name);
  scene.fill("stability/" + c.scene, c.set);
  RunOptions options = scene.options();
  options.threads = 1;
  std::string message = "it ran to its end";
  try {
    run_solver(options);
  } catch (const RunError& e) {
    message = e.what();
  }
  bool holds = true;
  for (const std::string& word : c.fails) {
    EXPECT_THAT(message, testing::HasSubstr(word));
    holds = holds && message.find(word) != std::string::npos;
  }
  const FinishedRun run = read_run(scene.scene(), scene.start(), scene.folder().root);
  const Measure& not_finite = measures().at("not_finite");
  EXPECT_EQ(not_finite.of(run), 0) << "a run that diverges leaves no file with numbers that are none";
  Results results(c.name);
  results.add(run, "diagnosis", 0, "", message.substr(0, message.find("; particles as they are")), holds);
  results.add(run, "not_finite", not_finite.of(run), not_finite.unit, "0", not_finite.of(run) == 0);
  results.write();
}

class Stability : public testing::TestWithParam<StabilityCase> {};

TEST_P(Stability, Holds) {
  if (GetParam().fails.empty()) {
    run_to_the_end(GetParam());
  } else {
    stop_with_diagnosis(GetParam());
  }
}

std::string name_of(const testing::TestParamInfo<StabilityCase>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Suite, Stability, testing::ValuesIn(read_suite()), name_of);

}  // namespace
}  // namespace thalweg::test
