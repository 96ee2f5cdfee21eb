#pragma once

#include "case/case.hpp"
#include "postproc/bed_map.hpp"
#include "postproc/extraction_run.hpp"

namespace thalweg {

/// The bed of a run at its last snapshot beside that of its first, and the stress on it.
struct RunBedMap {
  BedMap map;                  // without places if the run has no bed
  double grain_weight = 0;     // [Pa] stress at a Shields number of 1; 0 in dry scenes, and with several sediments
  double critical_stress = 0;  // [Pa] at which a flat bed of the grains begins to move; 0 as above
};

/// Made of the heights that the pass over the snapshots has found, which are measured again where an earlier pass had
/// left its results. Throws InputError if a snapshot cannot be read.
RunBedMap make_run_bed_map(const Case& resolved, const RunFolder& run, const ExtractionRun& extraction);

}  // namespace thalweg
