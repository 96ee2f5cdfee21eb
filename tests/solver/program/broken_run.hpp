#pragma once

#include "tests/solver/case_run.hpp"

// A run with a break has to end as the one without, to the last bit.
namespace thalweg::test {

/// The last checkpoints of a scene that ran straight through, and of one that stopped at a time and went on.
struct TwoEnds {
  ParticleSet straight;
  ParticleSet joined;
};

/// Runs the scene in `path` both ways; call it in ASSERT_NO_FATAL_FAILURE. `until`: time of the break, as "0.2 s".
inline void run_with_a_break(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                             const std::string& until, TwoEnds& ends) {
  CaseRun straight("straight");
  straight.fill_from(path, overrides);
  ASSERT_EQ(run_solver(straight.options()), Exit::done);
  CaseRun broken("broken");
  broken.fill_from(path, overrides);
  RunOptions first = broken.options();
  first.until = until;
  ASSERT_EQ(run_solver(first), Exit::done);
  RunOptions rest = broken.options();
  rest.restart = broken.folder().checkpoint();
  ASSERT_EQ(run_solver(rest), Exit::done);
  ends = {read_particles(straight.folder().checkpoint()), read_particles(broken.folder().checkpoint())};
  ASSERT_EQ(ends.straight.id, ends.joined.id);
  for (std::size_t i = 0; i < ends.straight.size(); ++i) {
    ASSERT_EQ(ends.straight.position[i], ends.joined.position[i]) << "particle " << ends.straight.id[i];
    ASSERT_EQ(ends.straight.velocity[i], ends.joined.velocity[i]) << "particle " << ends.straight.id[i];
  }
  EXPECT_EQ(ends.straight.scalars, ends.joined.scalars);
}

}  // namespace thalweg::test
