#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/solver/case_run.hpp"

namespace thalweg::test {

/// Snapshots of a run from a time [s] on.
inline std::vector<ParticleSet> snapshots_from(const CaseRun& run, double time) {
  std::vector<ParticleSet> snapshots;
  for (const SeriesEntry& e : read_series(run.folder().snapshot_series())) {
    if (e.time >= time) snapshots.push_back(read_particles(run.folder().root / e.file));
  }
  return snapshots;
}

/// Water between two places along the flow, from a floor up to a depth of 0.1 m; what is higher counts with the uppermost row.
struct Reach {
  double from;       // [m]
  double to;         // [m]
  double floor = 0;  // [m]
};

/// Mean speed [m/s] of each row of water, one spacing [m] high.
inline std::vector<double> row_speeds(const std::vector<ParticleSet>& snapshots, double spacing, const Reach& reach) {
  const auto rows = static_cast<std::size_t>(std::lround(0.1 / spacing));
  std::vector<double> sum(rows, 0.0);
  std::vector<double> number(rows, 0.0);
  for (const ParticleSet& p : snapshots) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Vec3& x = p.position[i];
      if (p.type[i] != ParticleType::water || x.x() < reach.from || x.x() > reach.to) continue;
      const auto row = std::min(rows - 1, static_cast<std::size_t>(std::max(0.0, (x.z() - reach.floor) / spacing)));
      sum[row] += double(p.velocity[i].x()), number[row] += 1;
    }
  }
  for (std::size_t row = 0; row < rows; ++row) sum[row] /= std::max(1.0, number[row]);
  return sum;
}

}  // namespace thalweg::test
