#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "common/csv.hpp"
#include "common/error.hpp"
#include "common/profile.hpp"
#include "foam_reference/foam_library.hpp"
#include "foam_reference/reference_run.hpp"
#include "tests/foam_reference/small_scene.hpp"
#include "tests/foam_reference/temporary_folder.hpp"

namespace thalweg::foam {

namespace fs = std::filesystem;

/// Runs cases with libthalwegFoam in a folder of its own; skips, visibly, where OpenFOAM or the library cannot be had.
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
    const auto silent = [](const std::string&) {};
    ASSERT_EQ(reference_run(foam_case(scene, model, ranks), folder_.path(), silent), Reference::computed);
  }

  /// Runs a case whose files a test has changed.
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

  /// The eroding bed's table at a time: a row a column.
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

inline void replace(std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from << " in\n" << text;
  text.replace(at, from.size(), to);
}

inline void fix_step(std::string& control, const std::string& step) {
  replace(control, "adjustTimeStep  yes;", "adjustTimeStep  no;");
  const std::size_t at = control.find("deltaT  ");
  control.replace(at, control.find(';', at) - at, "deltaT  " + step);
}

/// Half the water of the tank falls over the bed.
inline Case small_dam_break() {
  Case scene = still_tank();
  scene.shapes[2].to.x() = 0.15;
  scene.output.end = 0.2;
  scene.compare.times = {0.2};
  return scene;
}

}  // namespace thalweg::foam
