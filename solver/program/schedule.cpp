#include "solver/program/schedule.hpp"

#include <algorithm>
#include <cmath>

namespace thalweg {

std::vector<double> snapshot_times(const Case& of) {
  const double end = of.output.end;
  std::vector<double> times{0, end};
  if (of.output.interval > 0) {
    for (long k = 1; static_cast<double>(k) * of.output.interval < end; ++k) {
      times.push_back(static_cast<double>(k) * of.output.interval);
    }
  }
  times.insert(times.end(), of.output.times.begin(), of.output.times.end());
  times.insert(times.end(), of.compare.times.begin(), of.compare.times.end());
  std::sort(times.begin(), times.end());
  // 0.25 s written in two ways is one time: nearer than a millionth of the run is the same.
  const double same = 1e-6 * end;
  times.erase(std::unique(times.begin(), times.end(), [=](double a, double b) { return std::abs(a - b) <= same; }),
              times.end());
  times.erase(std::remove_if(times.begin(), times.end(), [=](double t) { return t > end + same; }), times.end());
  return times;
}

BedSchedule::BedSchedule(const Case& of) : times_(of.compare.bed_times), end_(of.surface_bed.end) {
  if (end_ > 0) times_.push_back(end_);
  std::sort(times_.begin(), times_.end());
}

bool BedSchedule::passes(double bed_time) {
  const std::size_t before = next_;
  while (next_ < times_.size() && times_[next_] <= bed_time) ++next_;
  return next_ > before;
}

}  // namespace thalweg
