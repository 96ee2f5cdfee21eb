#pragma once

#include <string>
#include <vector>

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// Largest changes that a repair may make [m].
struct RepairLimits {
  double weld = 0;  // points nearer to each other than this become one
  double hole = 0;  // holes whose diagonal is not longer than this are filled
};

/// A surface after its repair.
struct Repaired {
  Triangles surface;
  std::vector<std::string> changes;  // one clause for each kind of change; empty if nothing was changed
};

/// Welds points, drops faces without area and faces that occur twice, turns faces alike, stitches, fills small holes
/// and unites bodies that overlap. Defects that it cannot cure remain; find_defects finds them.
Repaired repair(const Triangles& surface, const RepairLimits& limits);

/// The surface with every face turned over.
Triangles turned(Triangles surface);

}  // namespace thalweg::gencase
