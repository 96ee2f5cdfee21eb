#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/io/particle_file.hpp"
#include "common/io/ranged_particle_file.hpp"
#include "solver/simulation/packed_share.hpp"
#include "solver/simulation/particle_messages.hpp"
#include "tests/solver/simulation/scenes_on_ranks.hpp"
#include "tests/solver/watched_ranks.hpp"

// Files that several ranks write together: the bytes of one rank's, a range at a time.
namespace thalweg::test {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

StartOptions on(Ranks& ranks) {
  StartOptions options{"openmp", "auto", 1};
  options.ranks = &ranks;
  return options;
}

/// Runs what(simulation) on the first of so many ranks, behind some steps.
template <class What>
void lead_on(int ranks, const CaseRun& run, int steps, const What& what) {
  ThreadRanks(ranks).run([&](Ranks& mine) {
    WatchedRanks watched(mine);
    const ParticleSet nothing;
    auto share = start_simulation(run.scene(), mine.rank() == 0 ? run.start() : nothing, on(watched));
    if (mine.rank() != 0) return follow(*share, watched);
    const auto leader = lead(std::move(share), watched);
    for (int n = 0; n < steps; ++n) leader->advance(1);
    what(*leader, watched);
  });
}

class PackedShareTest : public testing::Test {
 protected:
  PackedShareTest() { fs::create_directories(folder_); }
  ~PackedShareTest() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string packed(Simulation& simulation, FileContents of, const ParticleFileInfo& info) const {
    RangedParticleFile file(folder_ / "packed.vtp");
    const auto frame = simulation.pack(of, info.spacing, [&](const PackedRange& range) { file.add(range); });
    if (!frame) throw std::logic_error("nothing was packed");
    file.finish({info, frame->facts, {}, frame->precision});
    return text_of(folder_ / "packed.vtp");
  }
  [[nodiscard]] std::string at_once(ParticleSet set, const ParticleFileInfo& info, PositionPrecision precision) const {
    set.info = info;
    write_particles(folder_ / "whole.vtp", set, precision);
    return text_of(folder_ / "whole.vtp");
  }

  fs::path folder_ = fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(PackedShareTest, WritesTheFilesOfOneRankOnAnyNumber) {
  CaseRun run("packed_files");
  run.fill("louvain", {"numerics.spacing=10 mm"});
  const ParticleFileInfo info = run.start().info;
  for (const int steps : {0, 3}) {
    OneRank alone;
    const auto one = lead(start_simulation(run.scene(), run.start(), on(alone)), alone);
    for (int n = 0; n < steps; ++n) one->advance(1);
    const std::string snapshot = at_once(one->snapshot(), info, PositionPrecision::single_precision);
    for (const int ranks : {1, 2, 3, 5}) {
      lead_on(ranks, run, steps, [&](Simulation& simulation, WatchedRanks&) {
        EXPECT_TRUE(packed(simulation, FileContents::snapshot, info) == snapshot) << ranks << " ranks, " << steps;
        if (steps == 0) return;  // there are no lists yet
        const std::string state = at_once(one->full_state(), info, PositionPrecision::double_precision);
        EXPECT_TRUE(packed(simulation, FileContents::full_state, info) == state) << ranks << " ranks, " << steps;
      });
    }
  }
}

// As in a scene so far away that single precision cannot tell a hundredth of its spacing.
TEST_F(PackedShareTest, KeepsDoublePrecisionFarFromTheOrigin) {
  CaseRun run("packed_far");
  run.fill("louvain", {"numerics.spacing=10 mm"});
  const ParticleFileInfo info = run.start().info;
  lead_on(2, run, 0, [&](Simulation& simulation, WatchedRanks&) {
    const auto precision = [&](double spacing) {
      return simulation.pack(FileContents::snapshot, spacing, [](const PackedRange&) {})->precision;
    };
    EXPECT_EQ(precision(info.spacing), PositionPrecision::single_precision);
    EXPECT_EQ(precision(1e-7 * info.spacing), PositionPrecision::double_precision);
  });
}

TEST_F(PackedShareTest, BringsARangeAtATimeToTheFirstRank) {
  CaseRun run("packed_ranges");
  run.fill("dam_break", {"numerics.spacing=0.3 mm"});
  const std::size_t all = run.start().size();
  ASSERT_GT(all, 6 * PackedShare::at_once) << "too few particles for several ranges of each rank";
  lead_on(2, run, 1, [&](Simulation& simulation, WatchedRanks& watched) {
    const std::size_t whole = to_message(simulation.full_state()).size();
    watched.forget();
    std::uint64_t largest = 0;
    std::uint64_t handed_over = 0;
    simulation.pack(FileContents::full_state, 0, [&](const PackedRange& range) {
      largest = std::max(largest, range.particles);
      handed_over += range.particles;
    });
    EXPECT_EQ(handed_over, all);
    EXPECT_LE(largest, PackedShare::at_once);
    EXPECT_EQ(watched.most, 1) << "several ranks' particles at once";
    // No more than a range as it is in memory, though the blocks were not compressed.
    EXPECT_LE(watched.largest_message, whole / all * PackedShare::at_once * 5 / 4);
  });
}

// The disk is full: the others wait for what comes next, which may be another file.
TEST_F(PackedShareTest, GoesOnWhereARangeIsNotTaken) {
  CaseRun run("packed_refused");
  run.fill("louvain", {"numerics.spacing=10 mm"});
  const ParticleFileInfo info = run.start().info;
  lead_on(3, run, 1, [&](Simulation& simulation, WatchedRanks&) {
    const auto refuse = [](const PackedRange&) { throw std::runtime_error("the disk is full"); };
    EXPECT_THROW(simulation.pack(FileContents::full_state, info.spacing, refuse), std::runtime_error);
    simulation.advance(1);
    const std::string snapshot = at_once(simulation.snapshot(), info, PositionPrecision::single_precision);
    EXPECT_TRUE(packed(simulation, FileContents::snapshot, info) == snapshot);
  });
}

}  // namespace
}  // namespace thalweg::test
