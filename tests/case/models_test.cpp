#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "case/case.hpp"
#include "case/models/all.hpp"
#include "case/reader/declarations.hpp"
#include "tests/case/case_files.hpp"

namespace thalweg {
namespace {

using ::testing::HasSubstr;

template <class Visit>
void for_each_model(Visit visit) {
  std::apply([&](auto... model) { (visit(model), ...); }, models::All{});
}

TEST(Models, BlameKeysThatExist) {
  int rules = 0;
  for_each_model([&]<class Model>(Model) {
    if constexpr (requires { &Model::rules; }) {
      for (const models::Rule& rule : Model::rules()) {
        const auto dot = rule.blamed.rfind('.');
        const TableDeclaration* table = find_table(case_declarations(), rule.blamed.substr(0, dot));
        ASSERT_NE(table, nullptr) << rule.blamed;
        const std::vector<std::string> keys = table->key_names();
        EXPECT_NE(std::find(keys.begin(), keys.end(), rule.blamed.substr(dot + 1)), keys.end()) << rule.blamed;
        EXPECT_FALSE(rule.what.empty() || rule.cure.empty());
        ++rules;
      }
    }
  });
  EXPECT_GE(rules, 18);
}

TEST(Models, AreOffUnlessNamed) {
  Case none;
  none.model.rest = false;  // the only one that is on by default
  for_each_model([&]<class Model>(Model) { EXPECT_FALSE(Model::is_on(none)); });
  const Case bed = read_case(good_case);
  EXPECT_TRUE(models::SedimentMotion::is_on(bed));
  EXPECT_TRUE(models::Rest::is_on(bed));
  EXPECT_TRUE(models::MovingWalls::is_on(read_case(source / "tests/case/good_case_moving.toml")));
}

TEST(Models, NothingRestsThatSeepsOrDrainsOrWeighsNothing) {
  EXPECT_FALSE(models::Rest::is_on(read_case(good_case, {"model.rest=false"})));
  EXPECT_FALSE(models::Rest::is_on(read_case(good_case, {"model.seepage=mixture"})));
  EXPECT_FALSE(models::Rest::is_on(read_case(good_case, {"model.pore_pressure=diffusion"})));
  EXPECT_FALSE(models::Rest::is_on(
      read_case(good_case, {"domain.gravity=[\"0 m/s^2\", \"0 m/s^2\"]", "numerics.maximum_speed=1 m/s"})));
}

struct Contradiction {
  std::vector<std::string> overrides;
  const char* message;
};

class BrokenRule : public ::testing::TestWithParam<Contradiction> {};

TEST_P(BrokenRule, IsRefused) {
  EXPECT_THAT(message_of(good_case, GetParam().overrides), HasSubstr(GetParam().message));
}

// The rules of which bad_cases/ holds no example.
INSTANTIATE_TEST_SUITE_P(
    Models, BrokenRule,
    ::testing::Values(
        Contradiction{{"model.sediment=viscoplastic", "model.bed_surface=held"},
                      "model.bed_surface is of beds that move by laws; remove it"},
        Contradiction{
            {"model.seepage=mixture", "model.effective_pressure=eos"},
            "a mixture has the pressure of its grains, or that of the columns; write \"grains\" or \"column\""},
        Contradiction{{"model.pore_pressure=diffusion", "model.effective_pressure=laplace"},
                      "model.pore_pressure takes the effective pressure from the columns; write \"column\""},
        Contradiction{{"model.seepage=mixture", "model.sediment=three-state"},
                      "the grains of a mixture have no states; write sediment = \"viscoplastic\""},
        Contradiction{{"model.seepage=mixture", "numerics.viscosity=capped"},
                      "drag in a mixture is part of the implicit solve; write \"implicit\""},
        Contradiction{{"model.pore_pressure=diffusion", "materials.pvc.porosity=0.1"},
                      "model.pore_pressure needs a porosity of 0.2 or more; use Ergun's law where it holds"},
        Contradiction{{"model.seepage=mixture", "materials.water.viscosity=0 Pa s"},
                      "model.seepage needs the water's viscosity; give materials.water.viscosity"}));

}  // namespace
}  // namespace thalweg
