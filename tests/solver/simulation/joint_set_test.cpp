#include <cstdint>
#include <vector>

#include "solver/simulation/particle_messages.hpp"
#include "tests/solver/simulation/scenes_on_ranks.hpp"
#include "tests/solver/watched_ranks.hpp"

// The first rank puts the sets of all together, and has no more than one of the others' beside the whole.
namespace thalweg::test {
namespace {

/// Particles with these ids, the first `fluid` of which are fluid; -1: in no order, all of them.
ParticleSet set_of(const std::vector<std::int64_t>& ids, int fluid) {
  ParticleSet set;
  set.id = ids;
  for (const std::int64_t id : ids) {
    const auto x = static_cast<double>(id);
    set.type.push_back(ParticleType::water);
    set.position.emplace_back(x, 0, -x);
    set.scalars["One"].push_back(static_cast<float>(id));
    set.doubles["Two"].insert(set.doubles["Two"].end(), {x, x + 0.5});
  }
  set.facts[own_fluid_fact] = {static_cast<double>(fluid)};
  set.facts["Known"] = {ids.empty() ? 0 : static_cast<double>(ids.front())};
  return set;
}

TEST(JointSetTest, HasTheFluidOfAllBeforeTheWallsOfAll) {
  // The second rank has nobody, and nobody is in order on the third.
  const std::vector<ParticleSet> sets{set_of({1, 2, 8}, 2), set_of({}, 0), set_of({3, 4}, -1), set_of({5, 9}, 1)};
  std::vector<SetSizes> sizes;
  for (const ParticleSet& set : sets) sizes.push_back(sizes_of(set));
  JointSet joint(sizes);
  for (const std::size_t rank : {2U, 0U, 3U, 1U}) joint.add(rank, to_message(sets[rank]));
  const ParticleSet all = joint.take();
  EXPECT_EQ(all.id, (std::vector<std::int64_t>{1, 2, 3, 4, 5, 8, 9}));
  ASSERT_EQ(all.position.size(), 7U);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto x = static_cast<double>(all.id[i]);
    EXPECT_EQ(all.position[i], Vec3(x, 0, -x));
    EXPECT_EQ(all.scalars.at("One")[i], static_cast<float>(all.id[i]));
    EXPECT_EQ(all.doubles.at("Two")[2 * i + 1], x + 0.5);
  }
  EXPECT_TRUE(all.density.empty());
  EXPECT_EQ(all.facts, (decltype(all.facts){{"Known", {1}}}));
}

TEST(JointSetTest, IsMadeOfOneMessageAtATime) {
  CaseRun run("joint");
  run.fill("dam_break", {"numerics.spacing=2.5 mm"});
  ThreadRanks(4).run([&](Ranks& mine) {
    WatchedRanks watched(mine);
    StartOptions options{"openmp", "auto", 1};
    options.ranks = &watched;
    const ParticleSet nothing;
    auto share = start_simulation(run.scene(), mine.rank() == 0 ? run.start() : nothing, options);
    if (mine.rank() != 0) return follow(*share, watched);
    const auto leader = lead(std::move(share), watched);
    leader->advance(1);
    watched.forget();
    leader->full_state();
    EXPECT_EQ(watched.in_all, 3);
    EXPECT_EQ(watched.most, 1) << "several ranks' particles at once";
  });
}

}  // namespace
}  // namespace thalweg::test
