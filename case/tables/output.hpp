#pragma once

#include <vector>

#include "case/tables/table.hpp"

namespace thalweg {

/// [output]: end of the run, and the times at which files are written.
struct Output {
  static constexpr TableHeading heading{"output", "What is written, and when."};

  /// Every snapshot ends a time step and is a file: more of them are a slip of the unit.
  static constexpr int most_snapshots = 1'000'000;

  double end = required;             // [s]
  double interval = 0;               // [s]
  std::vector<double> times;         // [s]
  double history_interval = 0;       // [s]
  double gauge_interval = 0;         // [s]
  double checkpoint_interval = 120;  // [s] of wall-clock time
  double disk_limit = 0;             // [byte]

  template <class V>
  void describe(V& v) {
    v.quantity("end", end, "s", 0, 1e9, "Physical time at which the run ends.");
    v.quantity("interval", interval, "s", 0, 1e9, "Time between snapshots; 0: only at `times`, the start and the end.");
    v.quantities("times", times, "s", 0, 1e9, "Further times at which a snapshot is written, hit exactly.");
    v.quantity("history_interval", history_interval, "s", 0, 1e9,
               "Time between rows of history.csv; 0: a hundredth of the run.");
    v.quantity("gauge_interval", gauge_interval, "s", 0, 1e9,
               "Time between rows of gauges.csv; 0: a thousandth of the run.");
    v.quantity(
        "checkpoint_interval", checkpoint_interval, "s", 0, 1e9,
        "Wall-clock time between checkpoints, from which an interrupted run continues; 0: one after every step.");
    v.quantity("disk_limit", disk_limit, "byte", 0, 1e18,
               "Disk space that snapshots and checkpoints may take, such as \"20 GB\": a run that is estimated to take "
               "more does not begin; 0: whatever there is.");
  }

  void check(const Case& whole, const CheckContext& at) const;
};

}  // namespace thalweg
