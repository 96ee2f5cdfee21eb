#pragma once

#include <cstddef>
#include <vector>

#include "case/case.hpp"

namespace thalweg {

/// The times at which snapshots are written, ascending and distinct: the start, multiples of output.interval,
/// output.times, compare.times, the end.
std::vector<double> snapshot_times(const Case& of);

/// Dues at times of a bed that is a surface: snapshots at compare.bed_times, the end at surface_bed.end.
class BedSchedule {
 public:
  explicit BedSchedule(const Case& of);

  /// Leaves out what was due up to a time of the bed [s], where a run begins or goes on.
  void begin(double bed_time) { (void)passes(bed_time); }
  /// True if the bed has come to a time at which something is due since the last call.
  [[nodiscard]] bool passes(double bed_time);
  [[nodiscard]] bool is_at_end(double bed_time) const { return end_ > 0 && bed_time >= end_; }

 private:
  std::vector<double> times_;  // [s] ascending
  std::size_t next_ = 0;
  double end_;  // [s]; 0: none
};

}  // namespace thalweg
