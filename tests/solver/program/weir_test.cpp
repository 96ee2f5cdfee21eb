#include <gtest/gtest.h>

#include <cmath>

#include "tests/solver/case_run.hpp"
#include "tests/solver/program/channel_run.hpp"

// Water over a weir and down into a pool, against what others have measured (cases/weir/README.md).
namespace thalweg {
namespace {

/// A figure of cases/weir/expected.toml.
double value_of(const std::string& what) {
  const auto file = test::case_folder("weir") / "expected.toml";
  return toml::parse_file(file.string())[what]["value"].value<double>().value();
}

TEST(Weir, HasTheHeadThePoolAndTheSheetThatWereMeasured) {
  test::CaseRun run("weir");
  run.fill("weir", {"output.end=\"4 s\""});
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const CsvTable gauges = CsvTable::read(run.folder().gauges());
  const auto time = gauges.numbers("time", "s");
  const auto mean = [&](const std::string& gauge) {
    const auto levels = gauges.numbers(gauge + ".level", "m");
    double sum = 0;
    double number = 0;
    for (std::size_t i = 0; i < time.size(); ++i) {
      if (time[i] < 2 || std::isnan(levels[i])) continue;
      sum += levels[i], number += 1;
    }
    EXPECT_GT(number, 100) << gauge;
    return sum / number;
  };
  const double crest = 0.2;
  const double head = value_of("head");
  EXPECT_NEAR(mean("head") - crest, head, test::limit_of("weir", "head") * head);
  EXPECT_NEAR(mean("pool"), value_of("pool"), test::limit_of("weir", "pool") * value_of("pool"));
  EXPECT_NEAR(mean("sheet"), value_of("sheet"), test::limit_of("weir", "sheet") * value_of("sheet"));

  const CsvTable history = CsvTable::read(run.folder().history());
  const auto t = history.numbers("time", "s");
  std::size_t half = 0;
  while (t[half] < 2) ++half;
  const double in = test::trend(t, history.numbers("river_water", "kg"), half);
  const double out = -test::trend(t, history.numbers("sheet_water", "kg"), half);
  EXPECT_NEAR(in, 20, 0.01 * 20);
  EXPECT_NEAR(out, in, test::limit_of("weir", "discharge") * in);
}

}  // namespace
}  // namespace thalweg
