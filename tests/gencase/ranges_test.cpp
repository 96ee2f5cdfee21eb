#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "case/reader/case_file.hpp"
#include "common/error.hpp"
#include "common/particle_arrays.hpp"
#include "gencase/report.hpp"
#include "tests/gencase/scene.hpp"

// A scene that is filled range by range has the particles of one that is filled at once.
namespace thalweg::gencase::test {
namespace {

struct InRanges {
  Generated generated;
  ParticleSet all;
  std::size_t ranges = 0;
  std::size_t largest = 0;
};

template <class T>
void append(std::vector<T>& to, const std::vector<T>& array) {
  to.insert(to.end(), array.begin(), array.end());
}

InRanges fill_in_ranges(const Case& scene, std::int64_t nodes_at_once, double memory_limit = 1e12,
                        bool larger_than_memory = false) {
  InRanges filled;
  GenerateOptions options;
  options.nodes_at_once = nodes_at_once;
  options.memory_limit = memory_limit;
  options.larger_than_memory = larger_than_memory;
  filled.generated = generate_in_ranges(scene, options, [&](const ParticleSet& range) {
    ++filled.ranges;
    filled.largest = std::max(filled.largest, range.size());
    append(filled.all.id, range.id);
    append(filled.all.type, range.type);
    append(filled.all.state, range.state);
    append(filled.all.position, range.position);
    append(filled.all.velocity, range.velocity);
    append(filled.all.density, range.density);
    append(filled.all.pressure, range.pressure);
    append(filled.all.mass, range.mass);
    append(filled.all.normal, range.normal);
    for (const auto& [name, array] : range.scalars) append(filled.all.scalars[name], array);
  });
  return filled;
}

void expect_same(const Case& scene, std::int64_t nodes_at_once, bool comes_at_once = false) {
  const Generated whole = generate(scene);
  const InRanges parts = fill_in_ranges(scene, nodes_at_once);
  EXPECT_EQ(parts.ranges == 1, comes_at_once) << parts.ranges << " ranges";
  EXPECT_EQ(parts.largest < whole.particles.size() / 4, !comes_at_once);
  EXPECT_EQ(parts.all.id, whole.particles.id);
  EXPECT_EQ(parts.all.type, whole.particles.type);
  EXPECT_EQ(parts.all.state, whole.particles.state);
  EXPECT_EQ(parts.all.position, whole.particles.position);
  EXPECT_EQ(parts.all.velocity, whole.particles.velocity);
  EXPECT_EQ(parts.all.density, whole.particles.density);
  EXPECT_EQ(parts.all.pressure, whole.particles.pressure);
  EXPECT_EQ(parts.all.mass, whole.particles.mass);
  EXPECT_EQ(parts.all.normal, whole.particles.normal);
  EXPECT_EQ(parts.all.scalars, whole.particles.scalars);
  EXPECT_EQ(parts.generated.particles.info.lattice_node, whole.particles.info.lattice_node);
  EXPECT_EQ(parts.generated.particles.info.case_hash, whole.particles.info.case_hash);
  EXPECT_EQ(report(parts.generated), report(whole));
}

class RangesOfCase : public testing::TestWithParam<const char*> {};

TEST_P(RangesOfCase, AreItsParticles) { expect_same(read_case(std::string(CASES) + "/" + GetParam()), 100); }

// Walls that move, a bed, a driven flow that starts with a profile, rough walls, grains in the water, a bed that is a surface.
INSTANTIATE_TEST_SUITE_P(, RangesOfCase,
                         testing::Values("dam_break", "gate", "louvain", "channel", "pier_current", "suspension",
                                         "pipeline_hours", "submerged_columns"),
                         [](const auto& of) { return std::string(of.param); });

TEST(RangesTest, ComeAtOnceWhereTheBedIsSplit) {
  expect_same(read_case(std::string(CASES) + "/louvain",
                        {"numerics.spacing=10 mm", "model.sediment=viscoplastic", "model.seepage=mixture"}),
              500, true);
}

TEST(RangesTest, ComeAtOnceWhereParticlesAreMoved) {
  expect_same(read_case(std::string(CASES) + "/pier", {"numerics.spacing=20 mm", "gencase.relaxation=2"}), 500, true);
}

TEST(RangesTest, NeedNoMemoryForTheRun) {
  Case scene = empty_scene(2, 0.01);
  add_tank(scene, Vec3(0, 0, 0), Vec3(4, 0, 1));
  add_box(scene, "water", ShapeRole::water, Vec3(0, 0, 0), Vec3(4, 0, 0.8));
  constexpr double limit = 1e7;
  EXPECT_THAT(refusal(scene, limit), testing::HasSubstr("of memory"));
  const InRanges filled = fill_in_ranges(scene, 500, limit, true);
  EXPECT_EQ(filled.all.size(), generate(scene).particles.size());
  EXPECT_THROW(fill_in_ranges(scene, 500, 1e4, true), InputError) << "the lattice itself";
}

}  // namespace
}  // namespace thalweg::gencase::test
