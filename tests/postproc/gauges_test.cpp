#include "common/extraction/gauges.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "case/reader/case_file.hpp"
#include "common/extraction/subset.hpp"
#include "tests/postproc/synthetic_run.hpp"

namespace thalweg {
namespace {

using manufactured::flat;
using manufactured::Flume;
using testing::ElementsAre;

Case case_with(int dimension, const std::vector<Gauge>& gauges) {
  Case c;
  c.info.dimension = dimension;
  c.domain.from = Vec3(-0.1, -0.1, -0.1);
  c.domain.to = Vec3(1.1, 0.2, 0.5);
  Shape bed;
  bed.role = ShapeRole::sediment;
  c.shapes.push_back(bed);
  c.gauges = gauges;
  return c;
}

Gauge gauge(const char* name, GaugeKind kind, const Vec3& at) { return {name, kind, at, {}, {}}; }

// Water 0.1 m deep over 0.05 m of sediment in the left half of a flume, hydrostatic, moving with (1 + z) m/s along x.
ParticleSet half_full(int dimension) {
  Flume flume;
  flume.dimension = dimension;
  flume.begin();
  flume.add_walls();
  flume.fill(ParticleType::sediment, 0, 0.5, flat, [](double) { return 0.05; });
  flume.fill(
      ParticleType::water, 0, 0.5, [](double) { return 0.05; }, [](double) { return 0.15; },
      [](double, double z) { return static_cast<float>(1 + z); });
  for (const Vec3& at : flume.set.position) flume.set.pressure.push_back(static_cast<float>(9810 * (0.15 - at.z())));
  return flume.set;
}

TEST(Gauges, ReadLevelPressureAndVelocity) {
  for (const int dimension : {2, 3}) {
    const double y = dimension == 2 ? 0 : 0.05;
    const Case c = case_with(
        dimension,
        {gauge("wg", GaugeKind::water_level, {0.2517, y, 0}), gauge("p", GaugeKind::pressure, {0.2517, y, 0.1}),
         gauge("wall", GaugeKind::pressure, {0, y, 0.1}), gauge("u", GaugeKind::velocity, {0.25, y, 0.1})});
    const GaugeRow row = read_gauges(c, half_full(dimension));
    EXPECT_TRUE(row.notes.empty());
    ASSERT_EQ(row.values.size(), gauge_columns(c).size());
    EXPECT_NEAR(row.values[0], 0.15, 0.1 * 0.005);
    EXPECT_NEAR(row.values[1], 0.05, 0.1 * 0.005);
    // The plane is exact for a pressure linear in z, also where walls leave half of the reach: float rounding is left.
    EXPECT_NEAR(row.values[2], 490.5, 0.01);
    EXPECT_NEAR(row.values[3], 490.5, 0.01);
    EXPECT_NEAR(row.values[4], 1.1, 1e-4);
    EXPECT_NEAR(row.values.back(), 0, 1e-6);
  }
}

TEST(Gauges, SayWhereThereIsNothing) {
  const Case c =
      case_with(2, {gauge("wg", GaugeKind::water_level, {0.8, 0, 0}), gauge("p", GaugeKind::pressure, {0.25, 0, 0.3})});
  const GaugeRow row = read_gauges(c, half_full(2));
  EXPECT_THAT(row.notes, ElementsAre("wg: dry", "p: no fluid in reach"));
  EXPECT_EQ(gauge_heading_line(c), "time [s],wg.level [m],wg.bed [m],p.pressure [Pa],note");
  EXPECT_EQ(gauge_line(0.25, row), "0.25,,,,wg: dry; p: no fluid in reach");
}

// 0.1 m of water with 1 to 1.15 m/s, mean 1.1 m/s, over sediment at rest; in 3-D over a width of 0.1 m.
TEST(Gauges, FluxIsTheVolumeThatPasses) {
  for (const int dimension : {2, 3}) {
    Gauge plane{"q", GaugeKind::flux, {}, {0.25, -1, 0}, {0.25, 1, 0.2}};
    const GaugeRow row = read_gauges(case_with(dimension, {plane}), half_full(dimension));
    const double width = dimension == 2 ? 1 : 0.1;
    EXPECT_NEAR(row.values[0], 0.11 * width, 0.01 * 0.11 * width);
    EXPECT_EQ(row.values[1], 0);
    plane.from.z() = plane.to.z() = 0.1;  // nothing rises through a level plane
    plane.to.x() = 0.4;
    EXPECT_NEAR(read_gauges(case_with(dimension, {plane}), half_full(dimension)).values[0], 0, 1e-9);
  }
}

// A solver brings no other particles from its device.
TEST(Gauges, ReadNoParticlesBeyondTheirRegions) {
  for (const int dimension : {2, 3}) {
    const double y = dimension == 2 ? 0 : 0.05;
    const std::vector<Gauge> gauges{gauge("wg", GaugeKind::water_level, {0.2517, y, 0}),
                                    gauge("p", GaugeKind::pressure, {0, y, 0.1}),
                                    gauge("u", GaugeKind::velocity, {0.25, y, 0.1}),
                                    {"q", GaugeKind::flux, {}, {0.3, -1, 0}, {0.3, 1, 0.2}},
                                    {"level q", GaugeKind::flux, {}, {0.1, -1, 0.1}, {0.4, 1, 0.1}}};
    const ParticleSet all = half_full(dimension);
    for (const Gauge& one : gauges) {
      const Case c = case_with(dimension, {one});
      const auto regions = gauge_regions(c, all.info);
      ASSERT_EQ(regions.size(), 1U);
      ParticleSet around = subset(all, [&](const Vec3& at) { return regions[0].contains(at); });
      for (std::size_t i = 0; i < all.size(); ++i) {
        if (regions[0].contains(all.position[i])) around.pressure.push_back(all.pressure[i]);
      }
      EXPECT_GT(around.size(), 0U) << one.name;
      EXPECT_LT(around.size(), all.size() / 2) << one.name;
      EXPECT_EQ(read_gauges(c, around).values, read_gauges(c, all).values) << one.name;
    }
  }
}

// Water 0.1 m deep that rides `gap` [m] above 0.05 m of sediment, in the left half of a flume.
ParticleSet riding(double gap) {
  Flume flume;
  flume.begin();
  flume.add_walls();
  flume.fill(ParticleType::sediment, 0, 0.5, flat, [](double) { return 0.05; });
  flume.fill(
      ParticleType::water, 0, 0.5, [&](double) { return 0.05 + gap; }, [&](double) { return 0.15 + gap; });
  return flume.set;
}

// A wave over a dry bed may ride a spacing or two above it. Its level is the water's; far above it is no level.
TEST(Gauges, LevelIsThatOfWaterOverAGap) {
  const Case c = case_with(2, {gauge("wg", GaugeKind::water_level, {0.25, 0, 0})});
  for (const double gap : {0.005, 0.01}) {
    const GaugeRow row = read_gauges(c, riding(gap));
    EXPECT_NEAR(row.values[0], 0.15 + gap, 0.1 * 0.005) << gap;
    EXPECT_NEAR(row.values[1], 0.05, 0.1 * 0.005) << gap;
  }
  EXPECT_NEAR(read_gauges(c, riding(0.03)).values[0], 0.05, 0.1 * 0.005);
}

// A drop two spacings above a pool is not the water's level, though as near as a riding wave.
TEST(Gauges, LevelIsNotThatOfADropNearby) {
  ParticleSet set = half_full(2);
  for (int n = 0; n < 12; ++n) {
    set.id.push_back(static_cast<std::int64_t>(set.id.size()));
    set.type.push_back(ParticleType::water);
    set.position.emplace_back(0.2425 + 0.005 * (n % 4), 0, 0.1625 + 0.005 * (n / 4));
    set.velocity.emplace_back(0, 0, 0);
    set.density.push_back(1000);
    set.mass.push_back(0.025F);
    set.pressure.push_back(0);
  }
  const Case c = case_with(2, {gauge("wg", GaugeKind::water_level, {0.25, 0, 0})});
  EXPECT_NEAR(read_gauges(c, set).values[0], 0.15, 0.1 * 0.005);
}

// A drop over a pool is not the water's level.
TEST(Gauges, LevelIsThatOfTheBodyOnTheFloor) {
  ParticleSet set = half_full(2);
  for (int n = 0; n < 100; ++n) {
    set.id.push_back(static_cast<std::int64_t>(set.id.size()));
    set.type.push_back(ParticleType::water);
    set.position.emplace_back(0.225 + 0.005 * (n % 10), 0, 0.2 + 0.005 * (n / 10));
    set.velocity.emplace_back(0, 0, 0);
    set.density.push_back(1000);
    set.mass.push_back(0.025F);
    set.pressure.push_back(0);
  }
  const Case c = case_with(2, {gauge("wg", GaugeKind::water_level, {0.25, 0, 0})});
  EXPECT_NEAR(read_gauges(c, set).values[0], 0.15, 0.1 * 0.005);
}

}  // namespace
}  // namespace thalweg
