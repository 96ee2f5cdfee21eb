#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "tests/solver/scenes.hpp"

namespace thalweg {
namespace {

using test::LatticeSetup;
using test::Loaded;

template <class On>
class Neighbours : public testing::Test {};
TYPED_TEST_SUITE(Neighbours, test::Backends, test::BackendNames);

/// Every pair closer than the reach is in the list of the first one's cluster, exactly once; walls list no walls.
template <int Dim, class On>
void expect_complete(const Loaded<Dim, On>& l) {
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
  const double reach2 = l.scene.list_reach * l.scene.list_reach;
  for (Index c = 0; c < list.clusters; ++c) {
    std::multiset<Index> listed(entries.begin() + begin[c], entries.begin() + begin[c + 1]);
    listed.erase(list.count);
    for (const Index j : listed) ASSERT_EQ(listed.count(j), 1U) << "cluster " << c << " lists " << j << " twice";
    for (Index i = list.first(c); i < list.last(c); ++i) {
      for (Index j = 0; j < seen.count; ++j) {
        const bool wanted = c < list.fluid_clusters || j < list.fluid_count;
        if (wanted && distance2(i, j) < reach2 * (1 - 1e-5)) {
          ASSERT_EQ(listed.count(j), 1U) << "particle " << i << " misses neighbour " << j;
        }
      }
    }
  }
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

/// Moves particle 5 by dx [m] along x; returns how often lists are then made anew at the start of a step: never or once.
template <class On>
std::int64_t lists_made_after_moving(test::Loaded<2, On>& l, double dx) {
  test::change(l, [&](test::Seen& seen) {
    seen.position[5].x[0] += dx;
    seen.record[5].place[0] = l.scene.lattice.place(0, seen.position[5].x[0]);
  });
  Workspace<On> work;
  refresh_neighbours(l.on, l.p, l.scene, work);
  return work.list_rebuilds;
}

TYPED_TEST(Neighbours, ServeUntilTheSkinIsUsedUp) {
  LatticeSetup<2> setup;
  const auto scene = test::make_scene_of(setup);
  auto l = test::load<TypeParam>(scene, test::fill_lattice(scene, test::all_water, 0.2));
  const double slack = (scene.list_reach - 2 * scene.smoothing_length) / 2;
  EXPECT_EQ(lists_made_after_moving(l, 0.9 * slack), 0);
  EXPECT_EQ(lists_made_after_moving(l, 0.2 * slack), 1);
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
