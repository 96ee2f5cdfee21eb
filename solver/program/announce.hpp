#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "common/particles.hpp"

// Lines of the log at the start of a run: everything that is not as usual.
namespace thalweg {

/// Tells which choices of the case are not the defaults, and what goes beyond the source paper, so that nobody takes a
/// result for the paper's model.
void announce_choices(const Case& of);

/// A sentence for every length of the grains that is more than the spacing, where bed load follows a law: grains wider than
/// a particle (the drift is at most the water's speed), and a roughness that reaches over the water next to the bed.
std::vector<std::string> warnings_of_coarse_grains(const Case& of);

/// Warns if walls move faster than the case expects: the sound speed follows from the expected speed.
void warn_of_fast_walls(const Case& of, double wall_speed);

}  // namespace thalweg
