#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "common/input_errors.hpp"
#include "tests/case/case_files.hpp"

namespace thalweg {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The good case with one text replaced by another, several times.
fs::path changed_case(const std::string& name, const std::vector<std::pair<std::string, std::string>>& changes) {
  std::ostringstream content;
  content << std::ifstream(source / "tests/case/good_case.toml").rdbuf();
  std::string text = content.str();
  for (const auto& [from, to] : changes) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    if (at != std::string::npos) text.replace(at, from.size(), to);
  }
  const fs::path file = fs::path(::testing::TempDir()) / (name + ".toml");
  std::ofstream(file) << text;
  return file;
}

std::vector<std::string> mistakes_of(const fs::path& file, const std::vector<std::string>& overrides = {}) {
  try {
    read_case(file, overrides);
  } catch (const InputErrors& errors) {
    return errors.messages();
  } catch (const InputError& error) {
    return {error.what()};
  }
  return {};
}

TEST(Mistakes, AreToldTogetherInTheOrderOfTheFile) {
  const fs::path file = changed_case("together", {{"to = [\"0.9 m\", \"0.3 m\"]", "to = [\"0.9 m\", \"0.3 kg\"]"},
                                                  {"grain_diameter = ", "grain_diametre = "},
                                                  {"spacing = \"", "spacing = \"5 kg\" #"},
                                                  {"end = \"", "end = 2 #"}});
  EXPECT_THAT(mistakes_of(file),
              ElementsAre(HasSubstr("shape.walls.to"), HasSubstr("did you mean materials.pvc.grain_diameter?"),
                          HasSubstr("numerics.spacing"), HasSubstr("output.end = 2 has no unit")));
}

// The unknown key is the missing one, misspelt.
TEST(Mistakes, OfAMisspeltKeyAreOne) {
  EXPECT_THAT(mistakes_of(changed_case("misspelt", {{"spacing = ", "spacng = "}})),
              ElementsAre(HasSubstr("did you mean numerics.spacing?")));
}

TEST(Mistakes, OfOverridesAreToldTogether) {
  EXPECT_THAT(mistakes_of(source / "tests/case/good_case.toml", {"numerics.spacing", "nothing.at.all=1"}),
              ElementsAre(HasSubstr("--set numerics.spacing: has no value"), HasSubstr("nothing.at.all=1: not a key")));
}

TEST(Mistakes, AreNoneInAGoodCase) { EXPECT_THAT(mistakes_of(source / "tests/case/good_case.toml"), IsEmpty()); }

TEST(Mistakes, NameTheKeyThatAWordOfTheFieldStandsFor) {
  EXPECT_THAT(mistakes_of(changed_case("d50", {{"grain_diameter = ", "d50 = "}})),
              ElementsAre(HasSubstr("unknown key materials.pvc.d50; did you mean materials.pvc.grain_diameter?")));
  const auto other = mistakes_of(changed_case("colour", {{"[materials.pvc]", "[materials.pvc]\nhue = 1"}}));
  EXPECT_THAT(other, ElementsAre(HasSubstr("`thalweg explain materials.pvc` lists the keys")));
}

// A bulk or grain density may be meant, and another table's key of that name is not.
TEST(Mistakes, NameTheKeysOfTheirOwnTable) {
  EXPECT_THAT(mistakes_of(changed_case("density", {{"grain_density = ", "density = "}})),
              ElementsAre(HasSubstr("did you mean materials.pvc.grain_density or materials.pvc.bed_density or "
                                    "materials.pvc.pore_density?")));
}

}  // namespace
}  // namespace thalweg
