#pragma once

#include <vector>

#include "case/case.hpp"
#include "common/extraction/profile_extraction.hpp"

namespace thalweg {

/// The things to measure in every snapshot of a run.
struct MeasureSettings {
  Case resolved;
  ExtractionSettings profile;      // along x, in 3-D in the middle of the domain
  std::vector<ProfileLine> lines;  // of the case, then further ones
  bool surfaces = true;
};

/// The speed below which sediment counts as resting [m/s] (where the solver gives State, of deposits only): a twentieth
/// of sqrt(g d50), the speed scale of a grain. It is about 9 mm/s for the Louvain grains. Creep and noise of particles
/// at rest are slower (about 1 mm/s); motion that a camera sees is faster.
double rest_speed_of(const Case& resolved);

/// Settings for the case's domain, lines and gauges, with further lines.
MeasureSettings settings_of(const Case& resolved, const std::vector<ProfileLine>& further_lines, bool surfaces);

}  // namespace thalweg
