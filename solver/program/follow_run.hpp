#pragma once

#include <memory>

#include "solver/program/read_run.hpp"
#include "solver/program/run.hpp"
#include "solver/simulation/simulation.hpp"
#include "solver/simulation/start.hpp"

// A run on several ranks: the first one runs the program, the others follow it.
namespace thalweg {

/// On the first rank: tells the others whether the run begins, which they wait for. Without ranks nothing happens.
class Invitation {
 public:
  explicit Invitation(Ranks* ranks) : ranks_(ranks) {}
  ~Invitation() {
    if (!sent_) send(false);
  }
  Invitation(const Invitation&) = delete;
  Invitation& operator=(const Invitation&) = delete;

  /// The run begins: all has been read and checked.
  void send() { send(true); }

 private:
  void send(bool begins);

  Ranks* ranks_;
  bool sent_ = false;
};

StartOptions start_options(const RunOptions& options);

/// The simulation of a run, on this rank alone or on all of them.
std::unique_ptr<Simulation> start(const RunStart& from, const RunOptions& options);

/// On any other rank: takes part in the run until it ends, without a word.
Exit follow_run(const RunOptions& options);

}  // namespace thalweg
