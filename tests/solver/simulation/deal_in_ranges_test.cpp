#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>

#include "common/error.hpp"
#include "solver/simulation/twin_search.hpp"
#include "tests/solver/simulation/scenes_on_ranks.hpp"

// Several ranks start from particles of which none has more than a range and its share.
namespace thalweg::test {
namespace {

/// Starts of one scene on three ranks, dealt out from `start`.
ParticleSet state_behind_a_step(const Case& of, const ParticleSet& start, bool in_ranges, std::uint64_t& largest) {
  ParticleSet state;
  ThreadRanks(3).run([&](Ranks& mine) {
    StartOptions options{"openmp", "auto", 1};
    options.ranks = &mine;
    SetSource source(start);
    const ParticleSet nothing;
    std::unique_ptr<Simulation> share =
        in_ranges ? start_simulation(of, mine.rank() == 0 ? StartSource{&source, "p.vtp"} : StartSource{}, options)
                  : start_simulation(of, mine.rank() == 0 ? start : nothing, options);
    if (mine.rank() != 0) return follow(*share, mine);
    largest = source.largest;
    const auto leader = lead(std::move(share), mine);
    leader->set_time(start.info.time);
    leader->advance(1);
    state = leader->full_state();
  });
  return state;
}

/// A scene of several ranges is dealt out alike, as filled and as a checkpoint has it.
void expect_same_deal(const char* name, const std::vector<std::string>& overrides) {
  CaseRun run("dealt_in_ranges");
  run.fill(name, overrides);
  const Case of = run.scene();
  ParticleSet start = run.start();
  ASSERT_GT(start.size(), 4 * particles_at_once) << "too few particles for several ranges";
  for (int n = 0; n < 2; ++n) {
    std::uint64_t largest = 0;
    ParticleSet at_once = state_behind_a_step(of, start, false, largest);
    expect_same(at_once, state_behind_a_step(of, start, true, largest));
    EXPECT_EQ(largest, particles_at_once);
    at_once.info = start.info;
    start = std::move(at_once);
  }
}

TEST(DealInRanges, IsTheDealOfAllAtOnce) { expect_same_deal("louvain", {"numerics.spacing=1.4 mm"}); }

// The mass and the plan of the water, and the surfaces of the walls, are those of the whole scene.
TEST(DealInRanges, KnowsTheWaterOfADrivenFlowAndTheSurfacesOfItsWalls) {
  expect_same_deal("channel", {"numerics.spacing=0.25 mm"});
}

TEST(DealInRanges, KnowsTheSurfacesOfWallsThatMove) {
  expect_same_deal("gate", {"numerics.spacing=1 mm", "model.wall_friction=smooth"});
}

/// The fault that three ranks find in particles which come in ranges of seven.
std::string fault_in(const ParticleSet& all, bool mixed) {
  std::string fault;
  ThreadRanks(3).run([&](Ranks& mine) {
    TwinSearch search(mine, mixed);
    for (std::size_t from = 0; from < all.size(); from += 7) {
      search.add(mine.rank() == 0 ? slice(all, from, std::min(all.size(), from + 7)) : ParticleSet());
    }
    const std::string found = search.fault("p.vtp");
    if (mine.rank() == 0) fault = found;
  });
  return fault;
}

ParticleSet row_of_water() {
  ParticleSet set;
  for (int i = 0; i < 100; ++i) {
    set.id.push_back(i);
    set.type.push_back(ParticleType::water);
    set.position.emplace_back(0.01 * i, 0, -0.0);
  }
  return set;
}

TEST(TwinSearchTest, FindsTheLeastIdThatTwoHave) {
  ParticleSet set = row_of_water();
  EXPECT_EQ(fault_in(set, false), "");
  set.id[80] = 60;
  set.id[3] = 55;
  EXPECT_EQ(fault_in(set, false), "p.vtp: two particles have the id 55; give each its own");
  set.id[99] = -2;
  EXPECT_EQ(fault_in(set, false), "p.vtp: a particle has the id -2; number from 0");
}

TEST(TwinSearchTest, FindsTwoInOnePlace) {
  ParticleSet set = row_of_water();
  set.position[70] = {0.05, 0, 0};  // 0 and -0 are one place
  set.position[90] = {0.5, 0, 0};
  EXPECT_EQ(fault_in(set, false),
            "p.vtp: particle 70 at x = 0.05 m, z = 0 m: it lies in the place of particle 5; correct it, or fill the "
            "scene with gencase");
  set.type[70] = set.type[90] = ParticleType::sediment;
  EXPECT_NE(fault_in(set, false), "");
  EXPECT_EQ(fault_in(set, true), "") << "grains and pore water share places";
}

TEST(TwinSearchTest, LetsWallsShareAPlace) {
  ParticleSet set = row_of_water();
  set.position[70] = set.position[5];
  set.type[5] = ParticleType::wall;
  EXPECT_NE(fault_in(set, false), "");
  set.type[70] = ParticleType::moving_wall;
  EXPECT_EQ(fault_in(set, false), "");
}

// The first rank tells what is wrong, and none goes on.
TEST(DealInRanges, EndsOnAllRanksWhereParticlesAreWrong) {
  CaseRun run("dealt_wrong");
  run.fill("louvain", {"numerics.spacing=20 mm"});
  const auto refused = [&](const ParticleSet& start, std::uint64_t unreadable_from) {
    std::array<std::string, 2> said;
    ThreadRanks(2).run([&](Ranks& mine) {
      StartOptions options{"openmp", "auto", 1};
      options.ranks = &mine;
      SetSource source(start);
      source.unreadable_from = unreadable_from;
      try {
        start_simulation(run.scene(), mine.rank() == 0 ? StartSource{&source, "p.vtp"} : StartSource{}, options);
      } catch (const InputError& error) {
        said[static_cast<std::size_t>(mine.rank())] = error.what();
      }
    });
    EXPECT_EQ(said[1], "the first rank cannot start this run");
    return said[0];
  };
  ParticleSet twins = run.start();
  twins.id[7] = twins.id[5];
  EXPECT_EQ(refused(twins, twins.size()),
            "p.vtp: two particles have the id " + std::to_string(twins.id[5]) + "; give each its own");
  EXPECT_EQ(refused(run.start(), 0), "p.vtp: cannot be read");
}

}  // namespace
}  // namespace thalweg::test
