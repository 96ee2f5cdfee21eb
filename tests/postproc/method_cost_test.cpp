#include "postproc/method_cost.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "common/csv.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

// A finished run whose free surface lies at `surface` and whose bed at `bed` [m], at one time.
void write_run(const fs::path& folder, const std::string& resolution, const std::string& elements, double size,
               double surface, double bed) {
  fs::create_directories(folder / "profiles");
  std::ofstream(folder / "summary.csv") << "quantity,value,unit\n"
                                        << resolution << ',' << size << ",m\n"
                                        << elements << ",100,-\nsteps,50,-\ncpu_seconds,2,s\n";
  Profile profile;
  profile.x = {0, 1, 2};
  profile.free_surface.assign(3, surface);
  profile.bed.assign(3, bed);
  write_profile(folder / "profiles" / profile_file_name(0.5), profile, {});
}

class MethodCost : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(run_.root);
    write_run(run_.root, "spacing", "fluid_particles", 0.005, 0.1, 0.06);
    write_run(run_.coarser(2).root, "spacing", "fluid_particles", 0.01, 0.103, 0.056);
    write_run(run_.foam() / "eroding-bed", "cell_size", "cells", 0.01, 0.1, 0.06);
    write_run(run_.foam() / "eroding-bed-2x", "cell_size", "cells", 0.02, 0.098, 0.06);
    write_run(run_.foam() / "stock", "cell_size", "cells", 0.01, 0.1, 0.06);
  }
  void TearDown() override { fs::remove_all(run_.root); }

  RunFolder run_{fs::temp_directory_path() / ("thalweg_methods_" + std::to_string(getpid()))};
};

TEST_F(MethodCost, FindsEveryRunOfEveryMethodTheFinestFirst) {
  const std::vector<Method> methods = read_methods(run_);
  ASSERT_EQ(methods.size(), 3U);
  EXPECT_EQ(methods[0].name, "particles");
  EXPECT_EQ(methods[1].name, "eroding-bed");
  EXPECT_EQ(methods[2].name, "stock");
  ASSERT_EQ(methods[0].runs.size(), 2U);
  EXPECT_EQ(methods[0].runs[0].label, "particles 5 mm");
  EXPECT_EQ(methods[1].runs[1].label, "eroding-bed 20 mm");
  EXPECT_EQ(methods[2].runs.size(), 1U);
  EXPECT_DOUBLE_EQ(methods[0].runs[0].element_steps_per_second(), 100 * 50 / 2.0);
}

TEST_F(MethodCost, MeasuresDistancesFromTheFinestOfTheSameMethod) {
  const std::vector<Method> methods = read_methods(run_);
  EXPECT_EQ(methods[0].runs[0].error_bed, 0);
  EXPECT_NEAR(methods[0].runs[1].error_free_surface, 0.003, 1e-12);
  EXPECT_NEAR(methods[0].runs[1].error_bed, 0.004, 1e-12);
  EXPECT_NEAR(methods[1].runs[1].error_free_surface, 0.002, 1e-12);
  EXPECT_NEAR(methods[1].runs[1].error_bed, 0, 1e-12);
}

TEST_F(MethodCost, WritesThemAsATable) {
  const fs::path file = run_.root / "cost.csv";
  write_costs(file, read_methods(run_));
  const CsvTable table = CsvTable::read(file);
  EXPECT_EQ(table.rows(), 5U);
  EXPECT_THAT(table.texts("method"),
              testing::ElementsAre("particles", "particles", "eroding-bed", "eroding-bed", "stock"));
}

TEST(CoarserMesh, IsToldByTheNameOfItsFolder) {
  EXPECT_TRUE(is_coarser_mesh("foam/eroding-bed-2x"));
  EXPECT_FALSE(is_coarser_mesh("foam/eroding-bed"));
  EXPECT_FALSE(is_coarser_mesh("foam/x"));
  EXPECT_FALSE(is_coarser_mesh("foam/box"));
}

}  // namespace
}  // namespace thalweg
