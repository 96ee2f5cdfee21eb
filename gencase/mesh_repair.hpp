#pragma once

#include <string>
#include <vector>

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// How far a repair may go [m].
struct RepairLimits {
  double weld = 0;  // points this near become one
  double hole = 0;  // holes with a diagonal up to this are filled
};

struct Repaired {
  Triangles surface;
  std::vector<std::string> changes;  // what was done, one clause each; empty: nothing
};

/// Welds points, drops faces without area and faces that occur twice, turns faces alike, stitches, fills small holes
/// and unites bodies that reach into each other. What it cannot cure is left for find_defects to tell.
Repaired repair(const Triangles& surface, const RepairLimits& limits);

/// Turns every face over.
Triangles turned(Triangles surface);

}  // namespace thalweg::gencase
