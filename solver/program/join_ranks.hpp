#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/ranks.hpp"

namespace thalweg {

/// The ranks of this run, if mpirun or srun has started several of this program; nullptr if it runs alone. Throws RunError
/// where this installation has no MPI.
std::unique_ptr<Ranks> join_ranks();

/// Runs this program on so many ranks, with these arguments, by mpirun. Returns the first rank's exit status. Throws
/// InputError where there is no mpirun.
int run_on_ranks(int ranks, const std::vector<std::string>& arguments);

/// On the first rank, at its end: tells run_on_ranks() the status, if that waits for it. Returns the status to end with: any
/// but 0 makes mpirun take its time to end the others, which end by themselves.
int tell_status(int status);

}  // namespace thalweg
