#pragma once

#include <string>
#include <string_view>

// The version of the programs, told in one place. `build_version()` and `build_commit()` come from a file that every build writes
// anew from git and that is linked into the programs alone, so that a commit makes no test link again.
namespace thalweg {

const char* build_version();  // "0.2.0", or "0.2.0+14.g1a2b3c4d5" between two tags
const char* build_commit();   // "1a2b3c4d5 of 2026-11-27", or "unknown"

/// The version that files and messages carry.
std::string version();

/// The version without what follows a +: two builds of one release read each other's checkpoints.
std::string release_of(std::string_view version);

/// The answer to --version: a line "PROGRAM VERSION", then commit, compiler, the cores that are installed, OpenFOAM, MPI.
std::string version_text(const std::string& program);

}  // namespace thalweg
