#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/error.hpp"
#include "common/io/particle_file.hpp"
#include "common/io/ranged_particle_file.hpp"
#include "common/io/ranged_particle_reader.hpp"

// A particle file that is written range by range has the bytes of one that is written at once.
namespace thalweg {
namespace {

ParticleSet mixed_particles(std::size_t n) {
  ParticleSet set;
  set.info = {"flume", "0.1.0-7-gabc", "0123456789abcdef", 3, 0.01, 0.015, 0.25, 42};
  set.info.lattice_node = Vec3(1.0 / 3, 0, -0.5);
  std::mt19937 random(3);
  std::normal_distribution<double> any(0, 10);
  const auto number = [&] { return static_cast<float>(any(random)); };
  for (std::size_t i = 0; i < n; ++i) {
    set.id.push_back((std::int64_t{1} << 40) - static_cast<std::int64_t>(i));
    set.type.push_back(static_cast<ParticleType>(i / 7 % 4));
    set.state.push_back(static_cast<SedimentState>(i / 5 % 4));
    set.position.emplace_back(any(random), any(random), any(random));
    set.velocity.emplace_back(number(), number(), number());
    set.density.push_back(1000 + number());
    set.pressure.push_back(number());
    set.mass.push_back(0.5F + static_cast<float>(i % 3));
    set.normal.emplace_back(0.F, 0.F, i % 2 == 0 ? 1.F : 0.F);
    set.scalars["WallDistance"].push_back(number());
    for (int c = 0; c < 2; ++c) set.scalars["Pairs"].push_back(number());
    set.doubles["Volume"].push_back(any(random));
  }
  return set;
}

/// Particles [from, to) of a set.
ParticleSet range_of(const ParticleSet& all, std::size_t from, std::size_t to) {
  const auto part = [&](const auto& array) {
    const std::size_t each = array.size() / all.size();
    return std::remove_cvref_t<decltype(array)>(array.begin() + static_cast<std::ptrdiff_t>(from * each),
                                                array.begin() + static_cast<std::ptrdiff_t>(to * each));
  };
  ParticleSet range;
  range.id = part(all.id);
  range.type = part(all.type);
  range.state = part(all.state);
  range.position = part(all.position);
  range.velocity = part(all.velocity);
  range.density = part(all.density);
  range.pressure = part(all.pressure);
  range.mass = part(all.mass);
  range.normal = part(all.normal);
  for (const auto& [name, array] : all.scalars) range.scalars[name] = part(array);
  for (const auto& [name, array] : all.doubles) range.doubles[name] = part(array);
  return range;
}

class RangedParticleFileTest : public testing::Test {
 protected:
  RangedParticleFileTest() { std::filesystem::create_directories(folder_); }
  ~RangedParticleFileTest() override { std::filesystem::remove_all(folder_); }

  static std::string text_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
  }
  void write_in_ranges(const ParticleSet& all, std::vector<std::size_t> ends) const {
    RangedParticleFile file(folder_ / "ranges.vtp");
    ends.push_back(all.size());
    std::size_t from = 0;
    for (const std::size_t to : ends) {
      file.add(range_of(all, from, to));
      from = to;
    }
    file.finish({all.info});
  }
  void expect_same(const ParticleSet& all, const std::vector<std::size_t>& ends) const {
    write_particles(folder_ / "whole.vtp", all, PositionPrecision::double_precision);
    write_in_ranges(all, ends);
    expect_same_files();
  }
  /// As ranks do it: everyone packs what lies between two ends, in steps, and the last one is the first to hand it over.
  void expect_same_packed(const ParticleSet& all, const std::vector<std::size_t>& ends, std::size_t step) const {
    const PositionPrecision single = PositionPrecision::single_precision;
    const std::map<std::string, std::string> texts{{"Case", "[case]\n"}};
    write_particles(folder_ / "whole.vtp", all, single, texts);
    {
      RangedParticleFile file(folder_ / "ranges.vtp");
      for (std::size_t part = ends.size(); part-- > 1;) {
        ParticlePacker packer(ends[part - 1], single);
        for (std::size_t from = ends[part - 1]; from < ends[part]; from += step) {
          file.add(packer.add(range_of(all, from, std::min(ends[part], from + step))));
        }
        file.add(packer.end());
      }
      file.finish({all.info, all.facts, texts, single});
    }
    expect_same_files();
  }
  void expect_same_files() const {
    const std::string whole = text_of(folder_ / "whole.vtp");
    const std::string ranges = text_of(folder_ / "ranges.vtp");
    ASSERT_EQ(ranges.size(), whole.size());
    const auto differs = std::mismatch(whole.begin(), whole.end(), ranges.begin()).first - whole.begin();
    EXPECT_TRUE(ranges == whole) << "from byte " << differs << " on";
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 2) << "a temporary file is left";
  }

  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(RangedParticleFileTest, HasTheBytesOfOneThatIsWrittenAtOnce) {
  expect_same(mixed_particles(20000), {1, 1, 3, 4099, 12288, 19999});
  expect_same(mixed_particles(20000), {});
}

// Arrays of whole blocks: 4096 numbers of 8 bytes are 32 KiB.
TEST_F(RangedParticleFileTest, EndsWithAWholeBlock) { expect_same(mixed_particles(8192), {4096}); }

TEST_F(RangedParticleFileTest, HasAMassOnceThatAllParticlesHave) {
  ParticleSet all = mixed_particles(3000);
  std::fill(all.mass.begin(), all.mass.end(), 0.25F);
  expect_same(all, {1000, 2000});
  EXPECT_EQ(read_particles(folder_ / "ranges.vtp").mass, all.mass);
}

TEST_F(RangedParticleFileTest, HasNoArraysThatTheSetHasNot) {
  ParticleSet all = mixed_particles(500);
  all.state.clear();
  all.normal.clear();
  all.scalars.clear();
  expect_same(all, {100});
}

TEST_F(RangedParticleFileTest, HasTheBytesOfOneThatIsWrittenAtOnceWherePartsArePackedByThemselves) {
  ParticleSet all = mixed_particles(20000);
  all.facts["Population"] = {20000, 0.5, 0, 1e-9};
  expect_same_packed(all, {0, 5000, 5000, 5001, 5003, 12288, 20000}, 1000);
  expect_same_packed(all, {0, 1, 20000}, 20000);
}

// A run that has diverged.
TEST_F(RangedParticleFileTest, HasNumbersThatAreNoneOrInfinite) {
  ParticleSet all = mixed_particles(9000);
  for (const std::size_t i : {0U, 1U, 4500U, 8999U}) {
    all.velocity[i].x() = NAN;
    all.pressure[i] = NAN;
    all.density[i] = i % 2 == 0 ? INFINITY : -INFINITY;
    all.position[i].x() = NAN;
  }
  expect_same_packed(all, {0, 1, 4096, 9000}, 2000);
  std::fill(all.pressure.begin(), all.pressure.end(), NAN);
  expect_same_packed(all, {0, 1, 4096, 9000}, 2000);
}

TEST_F(RangedParticleFileTest, RefusesAFileThatLacksAPart) {
  const ParticleSet all = mixed_particles(100);
  RangedParticleFile file(folder_ / "ranges.vtp");
  for (const std::size_t from : {0U, 60U}) {
    ParticlePacker packer(from, PositionPrecision::double_precision);
    file.add(packer.add(range_of(all, from, from + 40)));
    file.add(packer.end());
  }
  EXPECT_THROW(file.finish({all.info}), std::logic_error);
}

/// Every array and fact of two sets is equal.
void expect_equal(const ParticleSet& a, const ParticleSet& b) {
  EXPECT_EQ(a.info.case_hash, b.info.case_hash);
  EXPECT_EQ(a.info.time, b.info.time);
  EXPECT_EQ(a.info.lattice_node, b.info.lattice_node);
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.type, b.type);
  EXPECT_EQ(a.state, b.state);
  EXPECT_TRUE(a.position == b.position);
  EXPECT_TRUE(a.velocity == b.velocity);
  EXPECT_EQ(a.density, b.density);
  EXPECT_EQ(a.pressure, b.pressure);
  EXPECT_EQ(a.mass, b.mass);
  EXPECT_TRUE(a.normal == b.normal);
  EXPECT_EQ(a.scalars, b.scalars);
  EXPECT_EQ(a.doubles, b.doubles);
  EXPECT_EQ(a.facts, b.facts);
}

TEST_F(RangedParticleFileTest, IsReadRangeByRange) {
  for (const bool same_mass : {false, true}) {
    ParticleSet all = mixed_particles(20000);
    all.facts["Population"] = {20000, 0.5, 0, 1e-9};
    if (same_mass) std::fill(all.mass.begin(), all.mass.end(), 0.25F);
    write_particles(folder_ / "whole.vtp", all, PositionPrecision::double_precision, {{"Case", "[case]\n"}});
    auto reader = RangedParticleReader::open(folder_ / "whole.vtp");
    ASSERT_TRUE(reader) << "a file of ours";
    EXPECT_EQ(reader->size(), 20000U);
    EXPECT_EQ(reader->texts().at("Case"), "[case]\n");
    expect_equal(reader->range(0, 20000), all);
    for (const auto& [from, to] : {std::pair(0U, 1U), {1U, 2U}, {4095U, 4097U}, {5000U, 15000U}, {19999U, 20000U}}) {
      ParticleSet expected = range_of(all, from, to);
      expected.info = all.info;
      expected.facts = all.facts;
      expect_equal(reader->range(from, to), expected);
    }
  }
}

// In single precision, too.
TEST_F(RangedParticleFileTest, IsReadAsItWasByVtk) {
  const ParticleSet all = mixed_particles(9000);
  write_particles(folder_ / "ours.vtp", all, PositionPrecision::single_precision);
  const std::string text = text_of(folder_ / "ours.vtp");
  std::ofstream(folder_ / "unsealed.vtp", std::ios::binary) << text.substr(0, text.rfind("<!-- crc32"));
  EXPECT_FALSE(RangedParticleReader::open(folder_ / "unsealed.vtp"));
  expect_equal(read_particles(folder_ / "ours.vtp"), read_particles(folder_ / "unsealed.vtp"));
}

TEST_F(RangedParticleFileTest, TellsWhichParticleOfTheFileIsWrong) {
  ParticleSet all = mixed_particles(9000);
  all.position[8000].y() = INFINITY;
  write_particles(folder_ / "wrong.vtp", all, PositionPrecision::double_precision);
  auto reader = RangedParticleReader::open(folder_ / "wrong.vtp");
  ASSERT_TRUE(reader);
  EXPECT_NO_THROW((void)reader->range(0, 8000));
  EXPECT_THAT([&] { (void)reader->range(7000, 9000); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("the position of particle 8000 is not finite")));
}

TEST_F(RangedParticleFileTest, OfTwoParticles) { expect_same(mixed_particles(2), {1}); }
TEST_F(RangedParticleFileTest, OfOneParticle) { expect_same(mixed_particles(1), {}); }

TEST_F(RangedParticleFileTest, RefusesRangesOfDifferentArrays) {
  const ParticleSet all = mixed_particles(100);
  RangedParticleFile file(folder_ / "ranges.vtp");
  file.add(range_of(all, 0, 50));
  ParticleSet other = range_of(all, 50, 100);
  other.pressure.clear();
  EXPECT_THROW(file.add(other), RunError);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "ranges.vtp"));
}

TEST_F(RangedParticleFileTest, LeavesNothingIfItIsNotFinished) {
  { RangedParticleFile(folder_ / "ranges.vtp").add(mixed_particles(5000)); }
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

}  // namespace
}  // namespace thalweg
