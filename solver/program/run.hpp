#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "common/error.hpp"
#include "common/ranks.hpp"

namespace thalweg {

/// The options of the command line of thalweg-solver.
struct RunOptions {
  std::filesystem::path folder;
  std::string backend = "auto";
  std::string instruction_set = "auto";
  std::string device_messages = "auto";
  int threads = 0;                // 0: all cores
  bool profile = false;           // wait for the device after every heading of the timing
  std::int64_t benchmark = 0;     // so many steps, of which only summary and timing are written; 0: the run
  std::filesystem::path restart;  // a checkpoint, or "latest"; empty: from particles.vtp
  std::vector<std::string> restart_anyway = {};  // keys that may differ from the checkpoint's (restart_check.hpp)
  bool force = false;                            // replaces the results that the folder holds
  std::string until;                             // with unit; empty: output.end
  std::vector<std::string> overrides;
  Ranks* ranks = nullptr;  // that compute the run together, each in a process of its own; nullptr: this one alone
};

/// Runs the scene of a run folder to its end, writing history, snapshots and checkpoints on the way
/// (docs/file-formats.md). Returns Exit::done, or 128 + n after signal n, with a checkpoint written.
/// Throws InputError, RunError; whatever was written before stays whole. On several ranks the first writes and speaks; if
/// one of the others cannot go on, all end.
Exit run_solver(const RunOptions& options);

}  // namespace thalweg
