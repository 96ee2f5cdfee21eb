#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "case/field_words.hpp"
#include "case/physics_checks.hpp"
#include "tests/case/case_files.hpp"

namespace thalweg {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string explained(const std::string& key) {
  std::ostringstream text;
  explain(text, key);
  return text.str();
}

TEST(Explain, FindsKeysHoweverTheyAreNamed) {
  const std::string expected =
      "numerics.spacing\n  m, 1 um to 100 m; required\n  Distance of the particles at the start (dp).\n";
  EXPECT_EQ(explained("numerics.spacing"), expected);
  EXPECT_EQ(explained("spacing"), expected);
  EXPECT_THAT(explained("numerics"), HasSubstr(expected));
  EXPECT_THAT(explained(""), HasSubstr(expected));
  EXPECT_THAT(explained("materials.pvc.porosity"),
              AllOf(HasSubstr("materials.<sediment>.porosity\n"), Not(HasSubstr("cohesion"))));
  EXPECT_THAT(explained("shape.kind"), HasSubstr("\"difference\": the first shape of `of` without the others"));
  try {
    explained("spacng");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "explain: there is no key or table spacng; did you mean spacing?");
  }
}

// The words that users type first, and where each leads.
TEST(Explain, AnswersTheWordsOfTheField) {
  EXPECT_THAT(explained("inflow"), HasSubstr("[[inlet]]"));
  EXPECT_THAT(explained("d50"), AllOf(HasSubstr("grain_diameter\n"), Not(HasSubstr("cohesion"))));
  EXPECT_THAT(explained("outflow"), HasSubstr("[[outlet]]"));
  EXPECT_THAT(explained("scour depth"), HasSubstr("thalweg formulas CASE"));
  EXPECT_THAT(explained("Scour_Depth"), HasSubstr("model.bed_load\n"));
  EXPECT_THAT(explained("slope"), AllOf(HasSubstr("A sloping bed is a shape"), HasSubstr("flow.slope\n")));
  EXPECT_THAT(explained("density"), HasSubstr("see also materials.<sediment>.grain_density"));
  EXPECT_THAT(explained("Papanastasiou"), HasSubstr("materials.<sediment>.regularisation: ")) << "no key is near";
}

TEST(Explain, SendsTheWordsOfTheFieldToKeysThatExist) {
  for (const FieldWord& entry : field_words()) {
    for (const std::string& key : entry.keys)
      EXPECT_THAT(explained(key), HasSubstr(key.substr(key.rfind('.') + 1))) << entry.words.front();
    for (const std::string& word : entry.words)
      EXPECT_EQ(find_field_word(word), &entry) << word << " is in two entries";
  }
}

TEST(Explain, TellsTheSameInJson) {
  const auto spacing = nlohmann::json::parse(explain_json("spacing"));
  ASSERT_EQ(spacing["keys"].size(), 1U);
  EXPECT_EQ(spacing["keys"][0]["key"], "numerics.spacing");
  EXPECT_EQ(spacing["keys"][0]["unit"], "m");
  EXPECT_EQ(nlohmann::json::parse(explain_json("inflow"))["keys"][0]["key"], "inlet.name");
  EXPECT_THROW(explain_json("xyzzy"), InputError);
}

TEST(Explain, SetsTheTwoReadingsOfTheModelSideBySide) {
  const std::string text = explained("sediment");
  EXPECT_THAT(text, HasSubstr("model.sediment\n"));
  EXPECT_THAT(text,
              HasSubstr("  bed load to deposit\n    paper:      none: bed load never consolidates\n    consistent: "));
  EXPECT_EQ(explained("spacing").find("consistent:"), std::string::npos);
}

// The two files are generated; `cmake --build <build> --target docs` writes them anew.
TEST(Documentation, IsWhatTheDeclarationsSay) {
  std::ostringstream markdown;
  write_key_reference(markdown);
  EXPECT_EQ(text_of(source / "docs/case-file.md"), markdown.str()) << "build the target `docs`";
  std::ostringstream schema;
  write_key_schema(schema);
  EXPECT_EQ(text_of(source / "docs/case-file.schema.json"), schema.str()) << "build the target `docs`";
}

TEST(Documentation, OfRefusedPhysicsIsTheTableOfChecks) {
  std::ostringstream markdown;
  write_physics_checks(markdown);
  EXPECT_EQ(text_of(source / "docs/refused-physics.md"), markdown.str()) << "build the target `docs`";
  for (const PhysicsCheck& check : physics_checks()) EXPECT_LE(check.cause.size() + check.cure.size(), 220U);
}

}  // namespace
}  // namespace thalweg
