#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "common/error.hpp"
#include "common/io/particle_file.hpp"
#include "common/io/series.hpp"

namespace thalweg {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// The text of a particle file with one of its arrays under another name.
std::string renamed(std::string text, const std::string& array, const std::string& to) {
  const std::string attribute = "Name=\"" + array + '"';
  return text.replace(text.find(attribute), attribute.size(), "Name=\"" + to + '"');
}

class InTemporaryFolder : public ::testing::Test {
 protected:
  InTemporaryFolder() { std::filesystem::create_directories(folder); }
  ~InTemporaryFolder() override { std::filesystem::remove_all(folder); }
  std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) / ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

using Series = InTemporaryFolder;

// Values that lose something under any rounding or conversion: thirds, denormals, a negative zero, ids beyond 2^53.
ParticleSet awkward_particles(std::size_t n) {
  ParticleSet set;
  set.info = {"flume", "0.1.0-7-gabc", "0123456789abcdef", 3, 1.0 / 3.0 * 1e-2, 0.0075, 0.1, 123456789012345};
  set.info.lattice_node = Vec3(1.0 / 3.0, -0.0, 1e-300);
  for (std::size_t i = 0; i < n; ++i) {
    const auto k = static_cast<float>(i);
    set.id.push_back((std::int64_t{1} << 53) + 1 + static_cast<std::int64_t>(i));
    set.type.push_back(static_cast<ParticleType>(i % 4));
    set.state.push_back(static_cast<SedimentState>((i / 4) % 4));
    set.position.emplace_back(1.0 / (3.0 + static_cast<double>(i)), -0.0, std::numeric_limits<double>::denorm_min());
    set.velocity.emplace_back(k / 3, -k / 7, std::numeric_limits<float>::denorm_min());
    set.density.push_back(1000.F + k / 3);
    set.pressure.push_back(-k / 9);
    set.mass.push_back(0.025F + k * 1e-7F);
    set.viscosity.push_back(k / 11);
    set.normal.emplace_back(0.F, k / 13, -1.F);
    set.scalars["ShieldsNumber"].push_back(k / 17);
    for (int c = 0; c < 3; ++c) set.scalars["Shift"].push_back(k / 19 + static_cast<float>(c));
    set.doubles["Time"].push_back(static_cast<double>(i) / 23);
    for (int c = 0; c < 3; ++c) set.doubles["Velocity64"].push_back(static_cast<double>(i) / 29 - c);
  }
  return set;
}

class ParticleFile : public InTemporaryFolder {
 protected:
  /// Without its seal, as a file that another program has changed.
  std::string written_text() const {
    write_particles(folder / "written.vtp", awkward_particles(4), PositionPrecision::double_precision);
    std::ostringstream text;
    text << std::ifstream(folder / "written.vtp").rdbuf();
    return text.str().substr(0, text.str().find("<!-- crc32"));
  }
  void write_text(const std::string& name, const std::string& text) const { std::ofstream(folder / name) << text; }
};

template <class T>
void expect_same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  ASSERT_EQ(a.size(), b.size());
  if (!a.empty()) {
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(T)), 0);
  }
}

void expect_same(const ParticleSet& a, const ParticleSet& b) {
  EXPECT_EQ(a.info.case_name, b.info.case_name);
  EXPECT_EQ(a.info.code_version, b.info.code_version);
  EXPECT_EQ(a.info.case_hash, b.info.case_hash);
  EXPECT_EQ(a.info.dimension, b.info.dimension);
  EXPECT_EQ(a.info.spacing, b.info.spacing);
  EXPECT_EQ(a.info.smoothing_length, b.info.smoothing_length);
  EXPECT_EQ(a.info.time, b.info.time);
  EXPECT_EQ(a.info.step, b.info.step);
  EXPECT_EQ(a.info.lattice_node, b.info.lattice_node);
  expect_same_bits(a.id, b.id);
  expect_same_bits(a.type, b.type);
  expect_same_bits(a.state, b.state);
  expect_same_bits(a.position, b.position);
  expect_same_bits(a.velocity, b.velocity);
  expect_same_bits(a.density, b.density);
  expect_same_bits(a.pressure, b.pressure);
  expect_same_bits(a.mass, b.mass);
  expect_same_bits(a.viscosity, b.viscosity);
  expect_same_bits(a.normal, b.normal);
  ASSERT_EQ(a.scalars.size(), b.scalars.size());
  for (const auto& [name, values] : a.scalars) expect_same_bits(values, b.scalars.at(name));
  ASSERT_EQ(a.doubles.size(), b.doubles.size());
  for (const auto& [name, values] : a.doubles) expect_same_bits(values, b.doubles.at(name));
}

std::string message_of(const std::filesystem::path& file) {
  try {
    read_particles(file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

// A restart may only equal a straight run when the checkpoint keeps every bit.
TEST_F(ParticleFile, KeepsEveryBit) {
  const ParticleSet written = awkward_particles(1000);
  write_particles(folder / "p.vtp", written, PositionPrecision::double_precision);
  expect_same(written, read_particles(folder / "p.vtp"));
}

TEST_F(ParticleFile, KeepsOneParticle) {
  const ParticleSet written = awkward_particles(1);
  write_particles(folder / "p.vtp", written, PositionPrecision::double_precision);
  expect_same(written, read_particles(folder / "p.vtp"));
}

TEST_F(ParticleFile, KeepsASetWithoutOptionalArrays) {
  ParticleSet written = awkward_particles(10);
  written.state.clear();
  written.velocity.clear();
  written.viscosity.clear();
  written.normal.clear();
  written.scalars.clear();
  written.doubles.clear();
  written.mass.clear();
  write_particles(folder / "p.vtp", written, PositionPrecision::double_precision);
  expect_same(written, read_particles(folder / "p.vtp"));
}

TEST_F(ParticleFile, KeepsTheEmptySet) {
  ParticleSet written = awkward_particles(0);
  write_particles(folder / "p.vtp", written, PositionPrecision::double_precision);
  expect_same(written, read_particles(folder / "p.vtp"));
}

TEST_F(ParticleFile, StoresAConstantMassOnce) {
  ParticleSet written = awkward_particles(500);
  const auto with_varied_mass = folder / "varied.vtp";
  write_particles(with_varied_mass, written, PositionPrecision::double_precision);
  written.mass.assign(written.size(), 0.025F);
  const auto with_constant_mass = folder / "constant.vtp";
  write_particles(with_constant_mass, written, PositionPrecision::double_precision);
  expect_same(written, read_particles(with_constant_mass));
  EXPECT_LT(file_size(with_constant_mass), file_size(with_varied_mass));
}

TEST_F(ParticleFile, RoundsSnapshotPositionsToFloat) {
  const ParticleSet written = awkward_particles(20);
  write_particles(folder / "p.vtp", written, PositionPrecision::single_precision);
  const ParticleSet read = read_particles(folder / "p.vtp");
  for (std::size_t i = 0; i < written.size(); ++i) {
    EXPECT_EQ(read.position[i].x(), static_cast<double>(static_cast<float>(written.position[i].x())));
  }
  expect_same_bits(read.velocity, written.velocity);
}

TEST_F(ParticleFile, ReadsTheFactsAlone) {
  const ParticleSet written = awkward_particles(50);
  write_particles(folder / "p.vtp", written, PositionPrecision::double_precision);
  const ParticleFileInfo info = read_particle_info(folder / "p.vtp");
  EXPECT_EQ(info.case_name, "flume");
  EXPECT_EQ(info.step, written.info.step);
  EXPECT_EQ(info.time, 0.1);
}

// Files of earlier versions and of other programs name no node of the lattice.
TEST_F(ParticleFile, NeedsNoLatticeNode) {
  ParticleSet written = awkward_particles(5);
  written.info.lattice_node.reset();
  write_particles(folder / "p.vtp", written, PositionPrecision::double_precision);
  expect_same(written, read_particles(folder / "p.vtp"));
}

TEST_F(ParticleFile, RefusesALatticeNodeThatIsNoPoint) {
  const std::string text = written_text();
  write_text("number.vtp", renamed(renamed(text, "LatticeNode", "Other"), "Spacing", "LatticeNode"));
  EXPECT_THAT(message_of(folder / "number.vtp"),
              HasSubstr("LatticeNode in its field data is no point; give one entry"));
}

TEST_F(ParticleFile, NeedsIdsAndTypes) {
  for (const std::string name : {"Id", "Type"}) {
    write_text("other.vtp", renamed(written_text(), name, "Other"));
    EXPECT_THAT(message_of(folder / "other.vtp"),
                HasSubstr("has no point array " + name + "; particle files need Id and Type"));
  }
}

TEST_F(ParticleFile, WorksInFoldersWithSpacesAndLeavesNothingElseBehind) {
  write_particles(folder / "a b" / "p q.vtp", awkward_particles(5), PositionPrecision::double_precision);
  EXPECT_EQ(read_particles(folder / "a b" / "p q.vtp").size(), 5U);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "a b"), {}), 1);
}

// One bit that VTK would read without a word: of a number's text, or of the uncompressed header of an array.
TEST_F(ParticleFile, RefusesAFileThatItsSealDoesNotFit) {
  const auto file = folder / "p.vtp";
  write_particles(file, awkward_particles(100), PositionPrecision::double_precision);
  ASSERT_EQ(read_particles(file).size(), 100U);
  std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
  stream.seekp(static_cast<std::streamoff>(file_size(file) / 2));
  const int byte = stream.peek();
  stream.put(static_cast<char>(byte ^ 1));
  stream.close();
  EXPECT_THAT(message_of(file), HasSubstr("p.vtp: is damaged: its checksum does not fit its contents"));
}

TEST_F(ParticleFile, RefusesATruncatedFile) {
  const auto file = folder / "p.vtp";
  write_particles(file, awkward_particles(1000), PositionPrecision::double_precision);
  const auto whole = file_size(file);
  for (const double share : {0.0, 0.01, 0.05, 0.3, 0.6, 0.95}) {
    const auto cut = folder / "cut.vtp";
    std::filesystem::copy_file(file, cut, std::filesystem::copy_options::overwrite_existing);
    resize_file(cut, static_cast<std::uintmax_t>(share * static_cast<double>(whole)));
    EXPECT_THAT(message_of(cut), ::testing::ContainsRegex("cut.vtp:[0-9]+: is not complete XML ")) << "at " << share;
  }
}

TEST_F(ParticleFile, NamesWhatIsWrongWithAFile) {
  EXPECT_THAT(message_of(folder / "absent.vtp"), HasSubstr("absent.vtp: there is no such file; "));
  std::ofstream(folder / "text.vtp") << "x,y,z\n1,2,3\n";
  EXPECT_THAT(message_of(folder / "text.vtp"), HasSubstr("text.vtp:1: is not complete XML (syntax error); "));

  ParticleSet odd = awkward_particles(3);
  odd.type[1] = static_cast<ParticleType>(9);
  write_particles(folder / "odd.vtp", odd, PositionPrecision::double_precision);
  EXPECT_THAT(message_of(folder / "odd.vtp"), HasSubstr("array Type holds 9 at particle 1; it must be 0 to 3"));

  odd.type[1] = ParticleType::water;
  odd.position[2].x() = std::nan("");
  write_particles(folder / "nan.vtp", odd, PositionPrecision::double_precision);
  EXPECT_THAT(message_of(folder / "nan.vtp"), HasSubstr("the position of particle 2 is not finite"));
}

TEST_F(ParticleFile, RefusesToWriteArraysThatDoNotFit) {
  ParticleSet odd = awkward_particles(4);
  odd.density.pop_back();
  EXPECT_THROW(write_particles(folder / "p.vtp", odd, PositionPrecision::double_precision), RunError);
  odd = awkward_particles(4);
  odd.scalars["Velocity"] = std::vector<float>(4);
  EXPECT_THROW(write_particles(folder / "p.vtp", odd, PositionPrecision::double_precision), RunError);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST_F(ParticleFile, SaysWhyItCannotWrite) {
  std::ofstream(folder / "file") << "not a folder";
  try {
    write_particles(folder / "file" / "p.vtp", awkward_particles(2), PositionPrecision::double_precision);
    FAIL() << "wrote below a file";
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(), HasSubstr("p.vtp: cannot be written: Not a directory"));
  }
}

TEST_F(Series, ComesBackInOrderOfTime) {
  write_series(folder / "s.pvd", {{0.125, "snapshots/s00001.vtp"}, {0.0, "snapshots/a & b.vtp"}, {1.0 / 3, "c.vtp"}});
  const std::vector<SeriesEntry> entries = read_series(folder / "s.pvd");
  ASSERT_EQ(entries.size(), 3U);
  EXPECT_EQ(entries[0].time, 0.0);
  EXPECT_EQ(entries[0].file, "snapshots/a & b.vtp");
  EXPECT_EQ(entries[1].file, "snapshots/s00001.vtp");
  EXPECT_EQ(entries[2].time, 1.0 / 3);
}

TEST_F(Series, MayBeEmptyButNotCutOff) {
  write_series(folder / "s.pvd", {});
  EXPECT_TRUE(read_series(folder / "s.pvd").empty());
  EXPECT_THROW(read_series(folder / "absent.pvd"), InputError);
  write_series(folder / "s.pvd", {{0, "a.vtp"}, {1, "b.vtp"}});
  resize_file(folder / "s.pvd", file_size(folder / "s.pvd") - 20);
  EXPECT_THROW(read_series(folder / "s.pvd"), InputError);
}

TEST(CountByType, CountsAndWeighsEachPhase) {
  ParticleSet set;
  set.id = {1, 2, 3};
  set.type = {ParticleType::water, ParticleType::sediment, ParticleType::water};
  set.mass = {1, 2, 4};
  EXPECT_THAT(count_by_type(set), ElementsAre(0, 0, 2, 1));
  EXPECT_THAT(mass_by_type(set), ElementsAre(0, 0, 5, 2));
}

}  // namespace
}  // namespace thalweg
