#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "tests/solver/scenes.hpp"

namespace thalweg {
namespace {

using test::LatticeSetup;
using test::Loaded;

template <class On>
class Neighbours : public testing::Test {};
TYPED_TEST_SUITE(Neighbours, test::Backends, test::BackendNames);

/// Every pair closer than `distance` is in the list of the first one's cluster, exactly once; walls list no walls.
template <int Dim, class On>
void expect_complete(const Loaded<Dim, On>& l, double distance) {
  const test::Seen seen = test::look(l);
  const auto begin = test::copy_of(l.on, l.p.list_begin);
  const auto entries = test::copy_of(l.on, l.p.list_entries);
  const ClusterList list = l.p.list();
  const auto distance2 = [&](Index a, Index b) {
    double r2 = 0;
    for (int k = 0; k < Dim; ++k) {
      const int c = axis<Dim>(k);
      double d = seen.position[a].x[c] - seen.position[b].x[c];
      const double period = l.scene.lattice.range[k];
      if (l.scene.lattice.periodic[k]) d -= period * std::round(d / period);
      r2 += d * d;
    }
    return r2;
  };
  for (Index c = 0; c < list.clusters; ++c) {
    std::multiset<Index> listed(entries.begin() + begin[c], entries.begin() + begin[c + 1]);
    listed.erase(list.none);
    for (const Index j : listed) ASSERT_EQ(listed.count(j), 1U) << "cluster " << c << " lists " << j << " twice";
    for (Index i = list.first(c); i < list.last(c); ++i) {
      for (Index j = 0; j < seen.count; ++j) {
        const bool wanted = c < list.fluid_clusters || j < list.fluid_count;
        if (wanted && distance2(i, j) < distance * distance * (1 - 1e-5)) {
          ASSERT_EQ(listed.count(j), 1U) << "particle " << i << " misses neighbour " << j;
        }
      }
    }
  }
}
template <int Dim, class On>
void expect_complete(const Loaded<Dim, On>& l) {
  expect_complete(l, l.scene.list_reach);
}

/// The curve through 2^bits cells a side takes every cell once, and from each goes on through one of its faces.
template <int Dim>
void expect_unbroken(int bits) {
  const std::uint32_t side = 1U << bits;
  std::map<std::uint64_t, Vec<Dim, std::uint32_t>> along;
  for (std::uint32_t n = 0; n < 1U << (bits * Dim); ++n) {
    Vec<Dim, std::uint32_t> cell{};
    for (int k = 0; k < Dim; ++k) cell[k] = (n >> (k * bits)) % side;
    along[hilbert_code<Dim>(cell, bits)] = cell;
  }
  ASSERT_EQ(along.size(), 1U << (bits * Dim));
  ASSERT_EQ(along.rbegin()->first, (1U << (bits * Dim)) - 1);
  for (auto to = std::next(along.begin()), from = along.begin(); to != along.end(); from = to++) {
    int steps = 0;
    for (int k = 0; k < Dim; ++k)
      steps += std::abs(static_cast<int>(to->second[k]) - static_cast<int>(from->second[k]));
    ASSERT_EQ(steps, 1) << "after cell " << from->first;
  }
}

TEST(HilbertCurve, TakesEveryCellOnceAndIsUnbroken) {
  expect_unbroken<2>(3);
  expect_unbroken<2>(6);
  expect_unbroken<3>(4);
}

TEST(HilbertKey, PartsAnEighthOfALongDomainFromTheNext) {
  // 94 cells along x and 5 along z: the particles of an eighth follow each other, whatever lies beside them.
  const bool not_periodic[2] = {false, false};
  const Lattice<2> lattice({0, 0}, {9.4, 0.5}, not_periodic, 0.1);
  std::vector<Record> records;
  std::vector<int> eighth_of;
  for (int i = 0; i < 94; ++i) {
    for (int k = 0; k < 5; ++k) {
      Record record;
      record.place[0] = lattice.place(0, 0.1 * i + 0.05);
      record.place[2] = lattice.place(1, 0.1 * k + 0.05);
      records.push_back(record);
      eighth_of.push_back(i * 8 / 94);
    }
  }
  const neighbours::HilbertKey<2> key(records.data(), lattice);
  std::map<std::uint64_t, int> order;
  for (Index i = 0; i < records.size(); ++i) order[key(i)] = eighth_of[i];
  ASSERT_EQ(order.size(), records.size()) << "no two cells have the same place";
  int changes = 0;
  for (auto to = std::next(order.begin()), from = order.begin(); to != order.end(); from = to++) {
    changes += to->second == from->second ? 0 : 1;
  }
  EXPECT_EQ(changes, 7);
}

ParticleType floor_below(const Vec3& x) { return x.z() < 0.035 ? ParticleType::wall : ParticleType::water; }

TYPED_TEST(Neighbours, AreCompleteInThePlane) {
  LatticeSetup<2> setup;
  expect_complete(test::load<TypeParam>(test::make_scene_of(setup),
                                        test::fill_lattice(test::make_scene_of(setup), floor_below, 0.3)));
}

TYPED_TEST(Neighbours, AreCompleteInSpace) {
  LatticeSetup<3> setup;
  setup.length = 0.1;
  expect_complete(test::load<TypeParam>(test::make_scene_of(setup),
                                        test::fill_lattice(test::make_scene_of(setup), floor_below, 0.3)));
}

TYPED_TEST(Neighbours, WrapAroundPeriods) {
  LatticeSetup<2> plane;
  plane.periodic = true;
  expect_complete(test::load<TypeParam>(test::make_scene_of(plane),
                                        test::fill_lattice(test::make_scene_of(plane), test::all_water, 0.3)));
  LatticeSetup<3> space;
  space.periodic = true;
  space.length = 0.08;  // barely more than twice the reach: two cells around
  expect_complete(test::load<TypeParam>(test::make_scene_of(space),
                                        test::fill_lattice(test::make_scene_of(space), test::all_water, 0.3)));
}

TYPED_TEST(Neighbours, AreCompleteForScatteredGrains) {
  // Few particles far apart: four in a row of the space-filling order span the domain.
  LatticeSetup<2> setup;
  const auto scene = test::make_scene_of(setup);
  ParticleSet all = test::fill_lattice(scene, test::all_water, 0.4);
  ParticleSet few;
  for (std::size_t i = 0; i < all.size(); i += 17) {
    few.id.push_back(all.id[i]);
    few.type.push_back(all.type[i]);
    few.position.push_back(all.position[i]);
    few.density.push_back(all.density[i]);
    few.mass.push_back(all.mass[i]);
  }
  expect_complete(test::load<TypeParam>(scene, few));
}

TYPED_TEST(Neighbours, OneParticleHasItselfAlone) {
  LatticeSetup<2> setup;
  const auto scene = test::make_scene_of(setup);
  ParticleSet one;
  one.id = {42};
  one.type = {ParticleType::water};
  one.position = {Vec3(0.1, 0, 0.1)};
  one.density = {1000};
  one.mass = {0.1F};
  const auto l = test::load<TypeParam>(scene, one);
  EXPECT_EQ(test::copy_of(l.on, l.p.list_begin)[1], list_padding);
  const auto entries = test::copy_of(l.on, l.p.list_entries);
  EXPECT_EQ(entries[0], 0U);
  EXPECT_EQ(entries[1], 1U);  // padding
}

/// Moves fluid particles by moved(where) [m]; returns how far they have drifted, over half the skin.
template <int Dim, class On, class Moved>
double drift_after(Loaded<Dim, On>& l, const Moved& moved) {
  test::change(l, [&](test::Seen& seen) {
    for (Index i = 0; i < seen.fluid_count; ++i) {
      const Vec3 by = moved(Vec3(seen.position[i].x[0], seen.position[i].x[1], seen.position[i].x[2]));
      for (int k = 0; k < Dim; ++k) {
        const int c = axis<Dim>(k);
        seen.position[i].x[c] += by[c];
        seen.record[i].place[c] = l.scene.lattice.place(k, seen.position[i].x[c]);
      }
    }
  });
  test::TestStep standing(l, 0);
  neighbours::find_squared_drift(l.on, l.p, l.scene, standing.state());
  const double slack = (l.scene.list_reach - 2 * l.scene.smoothing_length) / 2;
  return std::sqrt(l.on.read(standing.state()).squared_drift) / slack;
}

/// The number of times that lists are made anew at the start of a step: 0 or 1.
template <class On>
std::int64_t lists_made(Loaded<2, On>& l) {
  Workspace<On> work;
  refresh_neighbours(l.on, l.p, l.scene, work);
  return work.list_rebuilds;
}

/// A scene in the plane, full of water, 45 cells of lists wide, and half its skin.
struct WidePlane {
  LatticeSetup<2> setup;
  Scene<2> scene;
  double slack;
  WidePlane() {
    setup.length = 0.75;
    scene = test::make_scene_of(setup);
    slack = (scene.list_reach - 2 * scene.smoothing_length) / 2;
  }
};

TYPED_TEST(Neighbours, ServeUntilOneParticleHasCrossedTheSkin) {
  const WidePlane plane;
  auto l = test::load<TypeParam>(plane.scene, test::fill_lattice(plane.scene, test::all_water));
  const auto one_by = [&](double dx) {
    return drift_after(l, [&](const Vec3& x) { return Vec3(x.x() < 0.01 && x.z() < 0.01 ? dx : 0, 0, 0); });
  };
  EXPECT_NEAR(one_by(1.9 * plane.slack), 0.95, 1e-3);
  EXPECT_EQ(lists_made(l), 0);
  EXPECT_NEAR(one_by(0.2 * plane.slack), 1.05, 1e-3);
  EXPECT_EQ(lists_made(l), 1);
  expect_complete(l);
}

TYPED_TEST(Neighbours, ServeUntilNeighboursHavePartedByTheSkin) {
  const WidePlane plane;
  auto l = test::load<TypeParam>(plane.scene, test::fill_lattice(plane.scene, test::all_water));
  const auto halves_apart_by = [&](double dx) {
    return drift_after(l, [&](const Vec3& x) { return Vec3(x.z() < 0.375 ? dx / 2 : -dx / 2, 0, 0); });
  };
  EXPECT_NEAR(halves_apart_by(1.9 * plane.slack), 0.95, 1e-3);
  EXPECT_EQ(lists_made(l), 0);
  EXPECT_NEAR(halves_apart_by(0.2 * plane.slack), 1.05, 1e-3);
  EXPECT_EQ(lists_made(l), 1);
}

TYPED_TEST(Neighbours, ServeLongerWhereNeighboursMoveAlike) {
  // Stretched by 3.8 times half the skin from side to side, but by a quarter of that within a neighbourhood.
  const WidePlane plane;
  auto l = test::load<TypeParam>(plane.scene, test::fill_lattice(plane.scene, test::all_water));
  const double drift =
      drift_after(l, [&](const Vec3& x) { return Vec3(1.9 * plane.slack * (0.999 - 2 * x.x() / 0.75), 0, 0); });
  EXPECT_NEAR(drift, 0.95, 0.02);
}

/// Moves the fluid at random, together and each by itself, until the lists just serve: they hold all in the support.
template <int Dim, class On>
void expect_to_serve(LatticeSetup<Dim> setup, double together) {
  const auto scene = test::make_scene_of(setup);
  auto l = test::load<On>(scene, test::fill_lattice(scene, floor_below, 0.3));
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(-1, 1);
  const double slack = (scene.list_reach - 2 * scene.smoothing_length) / 2;
  double drift = 0;
  while (drift < 0.9) {
    const double drift_of_one = drift_after(l, [&](const Vec3& x) {
      const Vec3 flow(std::cos(20 * x.z()), 0, std::sin(20 * x.x()));
      return Vec3(0.1 * slack * (together * flow + Vec3(any(random), Dim == 3 ? any(random) : 0, any(random))));
    });
    drift = drift_of_one;
    if (drift < 1) expect_complete(l, 2 * scene.smoothing_length);
  }
}

TYPED_TEST(Neighbours, HoldTheSupportAsLongAsTheyServe) {
  for (const double together : {0.0, 3.0}) {
    LatticeSetup<2> plane;
    plane.length = 0.3;
    plane.skin = 0.3;
    expect_to_serve<2, TypeParam>(plane, together);
    plane.periodic = true;  // seven cells around: the last block is narrow
    expect_to_serve<2, TypeParam>(plane, together);
    LatticeSetup<3> space;
    space.length = 0.1;
    space.skin = 0.3;
    expect_to_serve<3, TypeParam>(space, together);
  }
}

TYPED_TEST(Neighbours, NeedTheOrderOfTheirReach) {
  LatticeSetup<2> setup;
  const auto scene = test::make_scene_of(setup);
  auto l = test::load<TypeParam>(scene, test::fill_lattice(scene, floor_below, 0.2));
  EXPECT_TRUE(neighbours::are_in_order(l.on, l.p, scene));
  setup.skin = 0.3;
  const auto wider = test::make_scene_of(setup);
  EXPECT_FALSE(neighbours::are_in_order(l.on, l.p, wider));
  // A checkpoint of the narrower reach goes on with the wider one.
  HostBuffer<double> listed;
  for (const Place& at : test::copy_of(l.on, l.p.listed_at)) listed.insert(listed.end(), at.c, at.c + 3);
  l.scene = wider;
  restore_lists(l.on, l.p, wider, {listed.begin(), listed.end()});
  EXPECT_EQ(lists_made(l), 1);
  expect_complete(l);
}

TYPED_TEST(Neighbours, DropExcludedParticlesAndReportThem) {
  LatticeSetup<2> setup;
  const auto scene = test::make_scene_of(setup);
  auto l = test::load<TypeParam>(scene, test::fill_lattice(scene, floor_below));
  const Index before = l.p.count;
  const std::int64_t lost = test::look(l).id[3];
  test::change(l, [](test::Seen& seen) { seen.position[3].x[0] = -0.001; });
  test::TestStep standing(l, 0);
  drift(l.on, l.p, scene, standing.state(), 1);
  Workspace<TypeParam> work;
  const auto excluded = refresh_neighbours(l.on, l.p, scene, work);
  ASSERT_EQ(excluded.size(), 1U);
  EXPECT_EQ(excluded[0].id, lost);
  EXPECT_EQ(l.p.count, before - 1);
  const auto id = test::look(l).id;
  EXPECT_EQ(std::count(id.begin(), id.end(), lost), 0);
  expect_complete(l);
}

}  // namespace
}  // namespace thalweg
