#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <numbers>

#include "tests/case/case_files.hpp"

namespace thalweg {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(ReadCase, FillsWhatTheFileSays) {
  const Case read = read_case(source / "cases/louvain");
  EXPECT_EQ(read.info.name, "louvain");
  EXPECT_EQ(read.info.dimension, 2);
  EXPECT_EQ(read.domain.from, Vec3(-1.1, 0, -0.1));
  EXPECT_EQ(read.domain.gravity, Vec3(0, 0, -9.81));
  ASSERT_EQ(read.shapes.size(), 3U);
  EXPECT_EQ(read.shapes[0].side, WallSide::outside);
  EXPECT_THAT(read.shapes[0].open, ElementsAre("+z"));
  EXPECT_EQ(read.shapes[1].role, ShapeRole::sediment);
  EXPECT_EQ(read.shapes[1].material, "pvc") << "the only sediment is named where the case leaves it out";
  EXPECT_EQ(read.shapes[2].to, Vec3(0, 0, 0.16));
  EXPECT_GT(read.shapes[2].line, read.shapes[1].line);
  EXPECT_TRUE(read.has_sediment());
  EXPECT_DOUBLE_EQ(read.sediment().friction_angle, 38 * std::numbers::pi / 180);
  EXPECT_DOUBLE_EQ(read.sediment().grain_diameter, 0.0035);
  EXPECT_EQ(read.sediment().pore_density, 1000);
  EXPECT_DOUBLE_EQ(read.numerics.spacing, 0.005);
  EXPECT_EQ(read.numerics.sound_speed_factor, 10) << "default";
  EXPECT_DOUBLE_EQ(read.smoothing_length(), 0.0075);
  EXPECT_THAT(read.compare.times, ElementsAre(0.25, 0.5, 0.75, 1.0));
  EXPECT_EQ(read.folder, fs::absolute(source / "cases/louvain").lexically_normal());
}

TEST(ReadCase, TakesTheNameFromTheFolder) {
  const fs::path folder = own_folder();
  fs::create_directories(folder / "scour pit");
  fs::create_directories(folder / "scour-pit");
  std::string text = text_of(good_case);
  text.erase(text.find("name = \"flume\"\n"), 15);
  std::ofstream(folder / "scour pit/case.toml") << text;
  EXPECT_THAT(message_of(folder / "scour pit"), HasSubstr("case.toml:1: case.name = \"scour pit\" cannot name files"));
  std::ofstream(folder / "scour-pit/case.toml") << text;
  EXPECT_EQ(read_case(folder / "scour-pit").info.name, "scour-pit");
  fs::remove_all(folder);
}

TEST(ReadCase, ReadsThreeDimensions) {
  const Case read = read_case(source / "tests/case/good_case_3d.toml");
  EXPECT_EQ(read.shapes[1].from, Vec3(0, 0.1, -0.1));
  EXPECT_EQ(read.shapes[2].kind, ShapeKind::combine_difference);
  EXPECT_THAT(read.domain.periodic, ElementsAre("y"));
}

TEST(ReadCase, SaysWhereItLooked) {
  EXPECT_EQ(message_of("no/such/folder"),
            "no/such/folder: there is no such file or folder; name a folder with case.toml, or the file");
  EXPECT_EQ(message_of(source / "docs"),
            (source / "docs").string() + ": the folder holds no case.toml; name a folder with case.toml, or the file");
}

TEST(Overrides, TakeTextsNumbersAndToml) {
  const Case read = read_case(good_case, {"numerics.spacing=4 mm", "output.end=\"2 s\"", "materials.pvc.porosity=0.4",
                                          "shape.tank.to=[\"0.1 m\", \"0.2 m\"]", "model.yield_fit=outer",
                                          "materials.water.density=998 kg/m^3", "foam.cell=2 cm"});
  EXPECT_DOUBLE_EQ(read.numerics.spacing, 0.004);
  EXPECT_EQ(read.output.end, 2);
  EXPECT_EQ(read.sediment().porosity, 0.4);
  EXPECT_EQ(read.shapes[2].to, Vec3(0.1, 0, 0.2));
  EXPECT_EQ(read.model.yield_fit, YieldFit::outer);
  EXPECT_EQ(read.water.density, 998);
  EXPECT_EQ(read.foam.cell, 0.02);
}

TEST(Overrides, NameThemselvesInMessages) {
  const auto message = [](const char* text) { return message_of(good_case, {text}); };
  EXPECT_EQ(message("numerics.spacng=4 mm"), "--set numerics.spacng=4 mm: unknown key; did you mean numerics.spacing?");
  EXPECT_EQ(message("numerics.spacing=4"),
            "--set numerics.spacing=4: numerics.spacing = 4 has no unit; write it as a text, such as \"4 m\"");
  EXPECT_EQ(message("numerics.spacing=4 kg"),
            "--set numerics.spacing=4 kg: numerics.spacing: \"kg\" does not measure m; give it in m or a unit that "
            "converts to it");
  EXPECT_EQ(message("model.sediment=off"),
            "--set model.sediment=off: there is a sediment shape, and model.sediment is off; write sediment = "
            "\"viscoplastic\" in [model]");
  EXPECT_EQ(message("shape.tonk.to=[\"0 m\", \"0 m\"]"),
            "--set shape.tonk.to=[\"0 m\", \"0 m\"]: there is no shape \"tonk\"; the shapes are walls, bed, tank");
  EXPECT_EQ(message("materials.sand.porosity=0.4"),
            "--set materials.sand.porosity=0.4: there is no material \"sand\"; the materials are pvc");
  EXPECT_EQ(
      message("spacing=4 mm"),
      "--set spacing=4 mm: not a key; write table.key=value, or TABLE.NAME.key=value where TABLE is one of shape, "
      "motion, inlet, outlet, gauge, line, materials; `thalweg explain` lists the keys");
  EXPECT_EQ(message("numerics.spacing"), "--set numerics.spacing: has no value; write --set table.key=value");
  EXPECT_EQ(message("compare.times=[\"1 s\""),
            "--set compare.times=[\"1 s\": the value is not TOML: Error while parsing array: encountered end-of-file; "
            "correct it");
  EXPECT_THAT(message("numeric.spacing=4 mm"), HasSubstr("unknown table numeric; did you mean numerics?"));
}

class ResolvedCase : public ::testing::TestWithParam<const char*> {};

TEST_P(ResolvedCase, ReadsBackEqual) {
  const Case original = read_case(source / GetParam(), {"numerics.cfl=0.1234567890123456789"});
  const fs::path folder = own_folder();
  const fs::path file = folder / "case.resolved.toml";
  write_case(file, original);
  const Case again = read_case(file);
  EXPECT_EQ(hash_of(again), hash_of(original));
  EXPECT_EQ(again.folder, original.folder);
  EXPECT_EQ(again.file, file);
  EXPECT_EQ(again.numerics.cfl, original.numerics.cfl);
  EXPECT_EQ(again.shapes.size(), original.shapes.size());

  const fs::path second = folder / "again.resolved.toml";
  write_case(second, again);
  EXPECT_EQ(text_of(second), text_of(file));
  fs::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(Cases, ResolvedCase,
                         ::testing::Values("cases/louvain", "tests/case/good_case.toml", "tests/case/good_case_3d.toml",
                                           "tests/case/good_case_moving.toml"));

TEST(HashOf, FollowsValuesOnly) {
  const std::string hash = hash_of(read_case(good_case));
  EXPECT_EQ(hash.size(), 16U);
  EXPECT_EQ(hash_of(read_case(good_case, {"numerics.spacing=0.5 cm"})), hash);
  EXPECT_NE(hash_of(read_case(good_case, {"numerics.spacing=0.51 cm"})), hash);
}

TEST(HashOf, FollowsTheFilesThatShapesName) {
  const fs::path folder = own_folder();
  std::string text = text_of(good_case);
  text += "\n[[shape]]\nname = \"pier\"\nkind = \"mesh\"\nrole = \"wall\"\nfile = \"pier.stl\"\n";
  std::ofstream(folder / "case.toml") << text;
  std::ofstream(folder / "pier.stl") << "solid one";
  const std::string one = hash_of(read_case(folder));
  write_case(folder / "case.resolved.toml", read_case(folder));
  std::ofstream(folder / "pier.stl") << "solid two";
  EXPECT_NE(hash_of(read_case(folder)), one) << "the mesh has changed";
  EXPECT_EQ(hash_of(read_case(folder / "case.resolved.toml")), one) << "what was filled has not";
  fs::remove(folder / "pier.stl");
  EXPECT_EQ(hash_of(read_case(folder / "case.resolved.toml")), one);
  fs::remove_all(folder);
}

TEST(Motion, ReadsItsTableFromAFile) {
  const fs::path folder = own_folder();
  std::string text = text_of(source / "tests/case/good_case_moving.toml");
  const std::string table = "times = [\"0 s\", \"0.5 s\", \"1 s\"]\nangles = [\"0 deg\", \"10 deg\", \"-10 deg\"]\n";
  text.replace(text.find(table), table.size(), "file = \"swing.csv\"\n");
  std::ofstream(folder / "case.toml") << text;
  const auto write = [&](const char* rows) { std::ofstream(folder / "swing.csv") << rows; };
  write("time [s],angle [deg]\n0,0\n0.5,90\n1,-90\n");
  const Case read = read_case(folder);
  const Motion& swing = read.motions.at(2);
  EXPECT_EQ(swing.name, "swing");
  EXPECT_THAT(swing.times, ElementsAre(0, 0.5, 1));
  EXPECT_DOUBLE_EQ(swing.angles.at(2), -std::numbers::pi / 2);

  const auto message = [&] { return message_of(folder).substr(folder.string().size() + 1); };
  write("time [s],angle [deg]\n0,0\n0.5,90\n0.5,-90\n");
  EXPECT_EQ(message(), "swing.csv:4: the time is not after that of the row before; sort the rows");
  write("time [s],angle [deg]\n0,0\n0.5,\n");
  EXPECT_EQ(message(), "swing.csv:3: the row lacks a number or its time is negative; give both");
  write("time [s],angle [deg]\n0,0\n");
  EXPECT_EQ(message(), "swing.csv:1: the table has less than two rows; add some");
  write("time [s],angle [turns]\n0,0\n1,1\n");
  EXPECT_EQ(message(),
            "swing.csv:1: the column \"angle [turns]\" is not in rad; head it \"angle [rad]\" and give its values in "
            "that unit");
  fs::remove_all(folder);
}

TEST(Sediment, MustBeOne) {
  Case empty;
  EXPECT_FALSE(empty.has_sediment());
  EXPECT_THROW((void)empty.sediment(), InputError);
  empty.sediments["a"];
  empty.sediments["b"];
  EXPECT_THROW((void)empty.sediment(), InputError);
}

TEST(Implementation, SetsDefaultsThatTheCaseMayStillChange) {
  const Case ours = read_case(good_case);
  EXPECT_EQ(ours.model.yield_fit, YieldFit::sine);
  EXPECT_EQ(ours.model.bed_shear, BedShear::log_law);
  const Case printed = read_case(good_case, {"model.implementation=paper"});
  EXPECT_EQ(printed.model.yield_fit, YieldFit::paper);
  EXPECT_EQ(printed.model.bed_shear, BedShear::paper);
  EXPECT_DOUBLE_EQ(printed.sediment().consistency, 1.54);
  EXPECT_DOUBLE_EQ(printed.sediment().flow_index, 1.8);
  EXPECT_EQ(printed.model.effective_pressure, EffectivePressure::total);
  EXPECT_EQ(printed.sediment().bed_density(), printed.sediment().grain_density);
  EXPECT_LT(ours.sediment().bed_density(), ours.sediment().grain_density);
  const Case mixed =
      read_case(good_case, {"model.implementation=paper", "model.yield_fit=outer", "materials.pvc.flow_index=1"});
  EXPECT_EQ(mixed.model.yield_fit, YieldFit::outer);
  EXPECT_DOUBLE_EQ(mixed.sediment().flow_index, 1);
  EXPECT_EQ(mixed.model.bed_shear, BedShear::paper);
}

TEST(Accuracy, SetsDefaultsThatTheCaseMayStillChange) {
  const Numerics usual = read_case(good_case, {"numerics.accuracy=standard"}).numerics;
  EXPECT_EQ(usual.cfl, Numerics{}.cfl);
  EXPECT_EQ(usual.sound_speed_factor, Numerics{}.sound_speed_factor);
  const Numerics draft = read_case(good_case, {"numerics.accuracy=draft"}).numerics;
  EXPECT_EQ(draft.accuracy, Accuracy::draft);
  EXPECT_GT(draft.cfl, usual.cfl);
  EXPECT_LT(draft.sound_speed_factor, usual.sound_speed_factor);
  const Numerics mixed = read_case(good_case, {"numerics.accuracy=draft", "numerics.cfl=0.1"}).numerics;
  EXPECT_EQ(mixed.cfl, 0.1);
  EXPECT_EQ(mixed.sound_speed_factor, draft.sound_speed_factor);
  const Numerics fine = read_case(good_case, {"numerics.accuracy=fine"}).numerics;
  EXPECT_GT(fine.sound_speed_factor, usual.sound_speed_factor);
}

/// A case of water alone in the plane, whose numerics are the defaults.
constexpr const char* plane_water = THALWEG_SOURCE_DIR "/bench/speed_vs_error/scenes/standing_wave";

TEST(CaseFile, SwitchesTheArtificialViscosityOfWideKernelsOnly) {
  const Numerics usual = read_case(plane_water, {}).numerics;
  EXPECT_EQ(usual.smoothing_ratio, 2);
  EXPECT_EQ(usual.artificial_viscosity, 0.1);
  // Without the switch all of 0.1 would act: a standing wave would lose 30 % a period.
  EXPECT_EQ(read_case(plane_water, {"numerics.smoothing_ratio=1.5"}).numerics.artificial_viscosity, 0.02);
  EXPECT_EQ(read_case(plane_water, {"numerics.smoothing_ratio=2.2"}).numerics.artificial_viscosity, 0.1);
}

TEST(Accuracy, ComesTooLateForAResolvedCase) {
  const fs::path file = own_folder() / "case.resolved.toml";
  write_case(file, read_case(good_case, {"numerics.accuracy=draft"}));
  EXPECT_EQ(read_case(file).numerics.sound_speed_factor, numerics_at(Accuracy::draft).sound_speed_factor);
  EXPECT_THAT(message_of(file, {"numerics.accuracy=fine"}),
              HasSubstr("numerics.accuracy sets defaults, and a resolved case has none left; fill the scene again"));
  fs::remove_all(file.parent_path());
}

}  // namespace
}  // namespace thalweg
