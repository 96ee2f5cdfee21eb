#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/ranks.hpp"

namespace thalweg {

/// The ranks of this run, if mpirun or srun has started several of this program; nullptr if it runs alone. Throws RunError
/// where this installation has no MPI.
std::unique_ptr<Ranks> join_ranks();

/// Replaces this program by mpirun with `ranks` of them, with these arguments; does not return. Throws InputError where
/// there is no mpirun.
[[noreturn]] void become_ranks(int ranks, const std::vector<std::string>& arguments);

}  // namespace thalweg
