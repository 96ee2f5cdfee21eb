#pragma once

#include <initializer_list>

#include "tests/solver/case_run.hpp"

// A run with a break has to end as the one without, to the last bit.
namespace thalweg::test {

/// A scene that ran straight through, and one that stopped at a time and went on: their folders and last checkpoints.
struct TwoEnds {
  CaseRun straight_run{"straight"};
  CaseRun broken_run{"broken"};
  ParticleSet straight;
  ParticleSet joined;
};

/// Runs the scene in `path` both ways; call it in ASSERT_NO_FATAL_FAILURE. `until`: time of the break, as "0.2 s".
inline void run_with_a_break(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                             const std::string& until, TwoEnds& ends) {
  CaseRun& straight = ends.straight_run;
  straight.fill_from(path, overrides);
  ASSERT_EQ(run_solver(straight.options()), Exit::done);
  CaseRun& broken = ends.broken_run;
  broken.fill_from(path, overrides);
  RunOptions first = broken.options();
  first.until = until;
  ASSERT_EQ(run_solver(first), Exit::done);
  RunOptions rest = broken.options();
  rest.restart = broken.folder().checkpoint();
  ASSERT_EQ(run_solver(rest), Exit::done);
  ends.straight = read_particles(straight.folder().checkpoint());
  ends.joined = read_particles(broken.folder().checkpoint());
  ASSERT_EQ(ends.straight.id, ends.joined.id);
  for (std::size_t i = 0; i < ends.straight.size(); ++i) {
    ASSERT_EQ(ends.straight.position[i], ends.joined.position[i]) << "particle " << ends.straight.id[i];
    ASSERT_EQ(ends.straight.velocity[i], ends.joined.velocity[i]) << "particle " << ends.straight.id[i];
  }
  EXPECT_EQ(ends.straight.scalars, ends.joined.scalars);
}

/// Expects that all arrays of doubles and these facts of the two checkpoints are the same, and that the facts are there.
inline void expect_equal_ends(const TwoEnds& ends, std::initializer_list<const char*> facts) {
  EXPECT_EQ(ends.straight.doubles, ends.joined.doubles);
  for (const char* fact : facts) {
    ASSERT_TRUE(ends.straight.facts.contains(fact)) << fact;
    EXPECT_EQ(ends.straight.facts.at(fact), ends.joined.facts.at(fact)) << fact;
  }
}

}  // namespace thalweg::test
