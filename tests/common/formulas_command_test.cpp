#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "case/reader/case_file.hpp"
#include "common/app/scour/scene.hpp"
#include "common/csv.hpp"
#include "physics/scour/dey_sarkar_wall_jet.hpp"
#include "physics/scour/hec18_pier.hpp"
#include "physics/scour/laursen_live_bed.hpp"

// `thalweg formulas` as a user calls it, and the scenes that it reads (formulas/*.toml).
namespace thalweg {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const fs::path scenes = fs::path(THALWEG_SOURCE_DIR) / "tests/common/formulas";

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

SceneReading reading_of(const std::string& scene, const std::vector<std::string>& overrides = {}) {
  return read_scene(read_case(scenes / (scene + ".toml"), overrides));
}

std::vector<std::string> titles(const SceneReading& reading) {
  std::vector<std::string> found;
  for (const ScourSubject& subject : reading.subjects) found.push_back(subject.title);
  return found;
}

class FormulasCommand : public ::testing::Test {
 protected:
  FormulasCommand() { fs::create_directories(folder); }
  ~FormulasCommand() override { fs::remove_all(folder); }

  int formulas(const std::string& arguments) const {
    const std::string command =
        "cd '" + folder.string() + "' && '" THALWEG_PROGRAM "' formulas " + arguments + " > out.txt 2> err.txt";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  [[nodiscard]] std::string output() const { return text_of(folder / "out.txt"); }
  [[nodiscard]] std::string errors() const { return text_of(folder / "err.txt"); }
  [[nodiscard]] nlohmann::json rows() const { return nlohmann::json::parse(output()).at("rows"); }
  // The rows of a formula's name.
  [[nodiscard]] nlohmann::json row(const std::string& formula) const {
    for (const auto& entry : rows())
      if (entry.at("formula") == formula) return entry;
    return nullptr;
  }
  static std::string scene(const std::string& name) { return "'" + (scenes / (name + ".toml")).string() + "' "; }

  const fs::path folder = fs::path(::testing::TempDir()) /
                          (std::string("formulas ") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST(FormulasScene, SeesPiersAndAContractionInAFlume) {
  const SceneReading reading = reading_of("flume");
  // The twin is like the pile; the sill ends at the bed.
  EXPECT_THAT(titles(reading), ElementsAre("pier, shape \"pile\"", "pier, shape \"block\"", "contraction"));
  EXPECT_EQ(reading.inputs.value("velocity"), 0.3);
  EXPECT_NEAR(reading.inputs.value("depth"), 0.2, 1e-12);
  EXPECT_EQ(reading.inputs.find("depth")->origin, "shape \"water\" over shape \"bed\"");
  EXPECT_EQ(reading.inputs.value("grain"), 0.8e-3);
  EXPECT_NEAR(reading.subjects[0].inputs.value("pier-width"), 0.08, 1e-12);
  EXPECT_EQ(reading.subjects[1].nose, PierNose::square);
  EXPECT_NEAR(reading.subjects[1].inputs.value("pier-width"), 0.1, 1e-12);
  EXPECT_NEAR(reading.subjects[1].inputs.value("pier-length"), 0.3, 1e-12);
  EXPECT_NEAR(reading.subjects[2].inputs.value("width"), 0.8, 1e-12);
  EXPECT_NEAR(reading.subjects[2].inputs.value("contracted-width"), 0.5, 1e-12);  // 0.8 - 0.1 - 0.2
  EXPECT_THAT(reading.notes, IsEmpty());
}

// Prisms along z that touch a side narrow the flume, where they do most; one that stands free may be a pier.
TEST(FormulasScene, SeesSidesThatArePrisms) {
  const SceneReading reading = reading_of("narrows");
  ASSERT_THAT(titles(reading), ElementsAre("contraction"));
  EXPECT_NEAR(reading.subjects[0].inputs.value("width"), 0.6, 1e-6);
  EXPECT_NEAR(reading.subjects[0].inputs.value("contracted-width"), 0.36, 1e-5);  // at the corner of the left side
  ASSERT_EQ(reading.notes.size(), 1U);
  EXPECT_THAT(reading.notes[0].text, HasSubstr("shape \"nose\" is a prism, whose width is not read"));
}

TEST(FormulasScene, SeesNoPierThatEndsInTheBed) {
  const SceneReading reading = reading_of("flume", {"shape.pile.to=[\"1 m\", \"0 m\", \"0.1 m\"]"});
  EXPECT_THAT(titles(reading), ElementsAre("pier, shape \"twin\"", "pier, shape \"block\"", "contraction"));
}

TEST(FormulasScene, SeesAPipeAndItsGap) {
  SceneReading reading = reading_of("pipe");
  ASSERT_THAT(titles(reading), ElementsAre("pipe, shape \"pipe\""));
  EXPECT_NEAR(reading.subjects[0].inputs.value("pipe-diameter"), 0.05, 1e-12);
  EXPECT_NEAR(reading.subjects[0].inputs.value("pipe-gap"), 0, 1e-12);
  reading = reading_of("pipe", {"shape.pipe.center=[\"1 m\", \"0.14 m\"]"});
  EXPECT_NEAR(reading.subjects[0].inputs.value("pipe-gap"), 0.015, 1e-12);
}

TEST(FormulasScene, SeesAWallJetWithItsApronAndTailwater) {
  const SceneReading reading = reading_of("wall_jet");
  ASSERT_THAT(titles(reading), ElementsAre("wall jet of inlet \"slot\""));
  const Inputs& jet = reading.subjects[0].inputs;
  EXPECT_NEAR(jet.value("jet-velocity"), 1.21, 1e-12);
  EXPECT_NEAR(jet.value("jet-opening"), 0.015, 1e-12);
  EXPECT_NEAR(jet.value("apron"), 0.4, 1e-12);
  EXPECT_NEAR(jet.value("discharge"), 1.21 * 0.015, 1e-12);
  EXPECT_NEAR(reading.inputs.value("depth"), 0.163, 1e-12);  // the outlet's level, not that of the water at the start
  EXPECT_FALSE(reading.inputs.has("velocity"));              // that of the jet is not the channel's
}

TEST(FormulasScene, TakesTheLargestValueOfAHydrograph) {
  Case scene = read_case(scenes / "wall_jet.toml");
  Inlet& slot = scene.inlets.at(0);
  slot.velocity = 0;
  slot.times = {0, 1, 2};
  slot.velocities = {0.2, 0.9, 0.5};
  EXPECT_NEAR(read_scene(scene).subjects.at(0).inputs.value("jet-velocity"), 0.9, 1e-12);
}

// A step on a floor without sediment is no pier.
TEST(FormulasScene, SeesNoBoxesWithoutABed) {
  Case scene = read_case(scenes / "flume.toml");
  std::erase_if(scene.shapes, [](const Shape& shape) { return shape.role == ShapeRole::sediment; });
  EXPECT_THAT(titles(read_scene(scene)), ElementsAre("pier, shape \"pile\""));
}

TEST(FormulasScene, SaysThatItReadsNoCone) {
  Case scene = read_case(scenes / "flume.toml");
  for (Shape& shape : scene.shapes)
    if (shape.name == "pile") shape.kind = ShapeKind::cone;
  const SceneReading reading = read_scene(scene);
  ASSERT_EQ(reading.notes.size(), 1U);
  EXPECT_EQ(reading.notes[0].text,
            "shape \"pile\" is a cone, whose width is not read; give --pier-width if it is a pier");
}

// Across the flume, so that the flow has to be the one along y.
TEST(FormulasScene, TakesWidthsAcrossTheFlow) {
  Case scene = read_case(scenes / "flume.toml");
  scene.flow.along = "y";
  const SceneReading reading = read_scene(scene);
  EXPECT_NEAR(reading.subjects.at(1).inputs.value("pier-width"), 0.3, 1e-12);
  EXPECT_NEAR(reading.subjects.at(1).inputs.value("pier-length"), 0.1, 1e-12);
}

// 1.3 m + (2 m/s)^2/(2 9.81 m/s^2) - 0.5 m = 1.0039 m
TEST(FormulasScene, SeesAFallWithItsVelocityHead) {
  const SceneReading reading = reading_of("fall");
  ASSERT_THAT(titles(reading), ElementsAre("fall of inlet \"chute\""));
  EXPECT_NEAR(reading.subjects[0].inputs.value("drop"), 1.0039, 1e-4);
  EXPECT_NEAR(reading.subjects[0].inputs.value("discharge"), 0.1, 1e-12);
  EXPECT_NEAR(reading.inputs.value("depth"), 0.2, 1e-12);
}

TEST(FormulasScene, SaysWhatItCannotRead) {
  const SceneReading reading = read_scene(read_case(fs::path(THALWEG_SOURCE_DIR) / "cases/pier"));
  ASSERT_EQ(reading.notes.size(), 2U);
  EXPECT_EQ(reading.notes[0].text, "the water ends at 0.08 m and at 0.18 m; give --depth");
  EXPECT_THAT(reading.notes[1].text, HasSubstr("shape \"pier\" is a mesh, whose width is not read; give --pier-width"));
  EXPECT_FALSE(reading.inputs.has("depth"));
}

TEST_F(FormulasCommand, PrintsValueRangeInputsAndSource) {
  EXPECT_EQ(formulas(scene("flume")), 0) << errors();
  EXPECT_THAT(output(),
              HasSubstr("pier, shape \"pile\"\n  HEC-18 (CSU)              scour depth            0.125 m\n"));
  EXPECT_THAT(output(), HasSubstr("depth 0.2 m (shape \"water\" over shape \"bed\"), velocity 0.3 m/s ([flow])"));
  EXPECT_THAT(output(), HasSubstr("source: FHWA-HIF-12-003 (HEC-18), 5th ed. 2012, eq. 7.1"));
  EXPECT_THAT(output(), HasSubstr("outside its range: V/Vc 0.683 < 1\n"));
  EXPECT_EQ(errors(), "");
}

TEST_F(FormulasCommand, GivesWhatTheLawsGive) {
  EXPECT_EQ(formulas(scene("flume") + "--json"), 0) << errors();
  EXPECT_NEAR(row("HEC-18 (CSU)").at("value"),
              hec18_pier_scour({.width = 0.08, .length = 0.08, .depth = 0.2, .velocity = 0.3}), 1e-12);
  EXPECT_EQ(formulas(scene("wall_jet") + "--json"), 0) << errors();
  EXPECT_NEAR(row("Dey & Sarkar").at("value"), 0.07488, 1e-5);
  EXPECT_EQ(row("Breusers").at("value"), nullptr);
  EXPECT_EQ(row("Breusers").at("missing"), nlohmann::json({"turbulence"}));
}

// q = U h and u* = 0.1 w: 0.2 m (0.8/0.5)^0.59 - 0.2 m = 0.0639 m, which nothing brings grains for.
TEST_F(FormulasCommand, NamesTheLimitThatIsLeftInJson) {
  EXPECT_EQ(formulas(scene("flume") + "--json"), 0);
  const auto live = row("Laursen, live bed");
  EXPECT_NEAR(live.at("value"), 0.2 * (std::pow(1.6, 0.59) - 1), 1e-9);
  ASSERT_EQ(live.at("outside").size(), 1U);
  EXPECT_EQ(live.at("outside")[0].at("quantity"), "V/Vc");
  EXPECT_EQ(live.at("outside")[0].at("at least"), 1);
}

// The worked example of HEC-18 by options alone, with a square nose to be free of the rule of thumb: 1.1 times 3.009
// m.
TEST_F(FormulasCommand, WorksWithoutACase) {
  EXPECT_EQ(
      formulas("--pier-width '1.22 m' --pier-length 18m --depth '312 cm' --velocity '3.36 m/s' --pier-nose square "
               "--grain 1mm --json"),
      0)
      << errors();
  EXPECT_NEAR(row("HEC-18 (CSU)").at("value"), 1.1 * 3.0087, 2e-4);
  EXPECT_EQ(rows().size(), 2U);  // the time scale is that of a circular pile
}

TEST_F(FormulasCommand, NamesWhatIsNotKnownWithItsCure) {
  EXPECT_EQ(formulas("--pipe-diameter 5cm"), 0);
  EXPECT_THAT(output(), HasSubstr("not known: velocity, depth, grain; give --velocity, --depth, --grain\n"));
  EXPECT_EQ(formulas("--drop 2m --discharge '1 m^2/s' --grain 20mm --depth 1m --json"), 0);
  EXPECT_NEAR(row("Schoklitsch").at("value"), 1.0920, 1e-4);  // 2.0920 m below the tailwater's surface
}

TEST_F(FormulasCommand, LetsAnOptionTakeThePlaceOfTheCase) {
  EXPECT_EQ(formulas(scene("flume") + "--velocity '0.6 m/s' --pier-width 20cm --json"), 0) << errors();
  EXPECT_NEAR(row("HEC-18 (CSU)").at("value"),
              hec18_pier_scour({.width = 0.2, .length = 0.2, .depth = 0.2, .velocity = 0.6}), 1e-12);
  const auto all = rows();
  EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const auto& one) { return one.at("formula") == "HEC-18 (CSU)"; }),
            1);
  EXPECT_EQ(formulas(scene("flume") + "--set flow.velocity='0.6 m/s' --json"), 0) << errors();
  EXPECT_NEAR(row("HEC-18 (CSU)").at("value"),
              hec18_pier_scour({.width = 0.08, .length = 0.08, .depth = 0.2, .velocity = 0.6}), 1e-12);
}

// A velocity by option leaves no discharge and no slope of the case beside it; a jet by options has its own discharge.
TEST_F(FormulasCommand, LetsNothingOfTheCaseContradictAnOption) {
  const auto input = [&](const std::string& formula, const std::string& name) {
    const nlohmann::json entry = row(formula);
    for (const auto& in : entry.at("inputs"))
      if (in.at("name") == name) return in.at("value").get<double>();
    return -1.0;
  };
  EXPECT_EQ(formulas(scene("flume") + "--discharge '0.12 m^2/s' --json"), 0) << errors();
  EXPECT_NEAR(input("HEC-18 (CSU)", "velocity"), 0.6, 1e-12);
  EXPECT_NEAR(input("Laursen, clear water", "discharge"), 0.12, 1e-12);
  EXPECT_EQ(formulas(scene("pipe") + "--velocity '0.87 m/s' --json"), 0) << errors();
  EXPECT_GT(std::abs(input("Fredsoe et al., pipe", "friction-velocity") - std::sqrt(9.81 * 0.2 * 0.001)), 1e-4);
  EXPECT_EQ(formulas(scene("wall_jet") + "--jet-velocity '2 m/s' --turbulence 0.3 --json"), 0) << errors();
  EXPECT_NEAR(input("Breusers", "discharge"), 2 * 0.015, 1e-12);
}

TEST_F(FormulasCommand, TellsNoNoteThatAnOptionHasCured) {
  const std::string pier = "'" THALWEG_SOURCE_DIR "/cases/pier' --pier-width 6cm --velocity '0.4 m/s' ";
  EXPECT_EQ(formulas(pier), 0);
  EXPECT_THAT(output(), HasSubstr("note: the water ends at 0.08 m and at 0.18 m; give --depth\n"));
  EXPECT_EQ(formulas(pier + "--depth 2cm"), 0);
  EXPECT_THAT(output(), Not(HasSubstr("note:")));
  EXPECT_THAT(output(), HasSubstr("outside its range: y/a 0.333 < 0.8"));
}

TEST_F(FormulasCommand, GivesTheDepthAtATimeByBreusers) {
  EXPECT_EQ(formulas("--turbulence 0.1 --velocity '0.5 m/s' --depth 1m --grain 1mm --critical-velocity '0.4 m/s' "
                     "--time '20 d' --json"),
            0)
      << errors();
  ASSERT_EQ(rows().size(), 2U);
  const double t1 = rows()[0].at("value");
  EXPECT_NEAR(t1, 2.5032e7, 1e3);
  EXPECT_NEAR(rows()[1].at("value"), std::pow(20 * 86400 / t1, 0.4), 1e-9);
}

TEST_F(FormulasCommand, WritesTheTableAsCsv) {
  EXPECT_EQ(formulas(scene("flume") + "--csv table.csv"), 0) << errors();
  const CsvTable table = CsvTable::read(folder / "table.csv");
  EXPECT_EQ(table.rows(), 7U);
  EXPECT_EQ(table.texts("formula")[0], "HEC-18 (CSU)");
  EXPECT_NEAR(table.numbers("value", "")[0], 0.125, 1e-3);
  EXPECT_EQ(table.texts("unit")[2], "s");
  EXPECT_THAT(table.texts("outside its range")[2], HasSubstr("theta/theta_cr 0.616 < 1"));
  EXPECT_THAT(output(), HasSubstr("HEC-18"));
}

TEST_F(FormulasCommand, RefusesBadInputInOneLine) {
  const auto said = [&](const std::string& arguments) {
    EXPECT_EQ(formulas(arguments), 2) << arguments;
    EXPECT_EQ(output(), "") << arguments;
    const std::string message = errors();
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << message;
    EXPECT_LE(message.size(), 300U) << message;
    return message;
  };
  EXPECT_EQ(said("--depth 3"), "error: --depth: \"3\" has no unit; add one, such as \"3 m\"\n");
  EXPECT_EQ(said("--depth '3 kg'"),
            "error: --depth: \"kg\" does not measure m; give it in m or a unit that converts to it\n");
  EXPECT_EQ(said("--depth '0 m'"), "error: --depth: 0 m is out of range; give more than 0 m to 1000 m\n");
  EXPECT_EQ(said("--grain '1 nm'"), "error: --grain: 1e-09 m is out of range; give from 1e-06 m to 2 m\n");
  EXPECT_EQ(said("--turbulence much"), "error: --turbulence: \"much\" is not a plain number; write one such as 0.1\n");
  EXPECT_THAT(said("--turbulence nan"), HasSubstr("is not a plain number"));
  EXPECT_THAT(said("--pier-width 1m --pier-nose blunt"), HasSubstr("write circular, round, square or sharp"));
  EXPECT_THAT(said("--set flow.slope=0.1 --pier-width 1m"), HasSubstr("there is no case whose key could be set"));
  EXPECT_THAT(said("nowhere"), HasSubstr("nowhere: there is no such file or folder"));
  EXPECT_THAT(said("--nonsense"), HasSubstr("see thalweg formulas --help"));
  EXPECT_THAT(said(""), HasSubstr("no pier, pipe, contraction, wall jet or fall is seen; give one by --pier-width"));
  EXPECT_THAT(said(scene("flume") + "--set flow.velocity=3"), HasSubstr("has no unit"));
  EXPECT_THAT(said("'" THALWEG_SOURCE_DIR "/cases/pier'"), HasSubstr("shape \"pier\" is a mesh"));
  EXPECT_THAT(said("--depth " + std::string(5000, '9') + "m"), HasSubstr("--depth: "));
}

// Whatever stands in the cases, the command ends with a table or with a line.
TEST_F(FormulasCommand, TakesEveryCaseOfTheRepository) {
  for (const auto& entry : fs::directory_iterator(fs::path(THALWEG_SOURCE_DIR) / "cases")) {
    if (!fs::exists(entry.path() / "case.toml")) continue;
    const int status = formulas("'" + entry.path().string() + "'");
    EXPECT_TRUE(status == 0 || status == 2) << entry.path() << errors();
    EXPECT_EQ(output().empty(), status == 2) << entry.path();
  }
}

TEST_F(FormulasCommand, ListsItsOptions) {
  EXPECT_EQ(formulas("--help"), 0);
  EXPECT_THAT(output(), HasSubstr("--pier-width"));
  for (const QuantityKind& kind : quantity_kinds())
    EXPECT_THAT(output(), HasSubstr(std::string("--") + kind.name + " "));
}

}  // namespace
}  // namespace thalweg
