#pragma once

#include <string>
#include <vector>

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// Largest changes that a repair may make [m].
struct RepairLimits {
  double weld = 0;  // points nearer to each other than this become one
  double slit = 0;  // slits between open edges that are not wider than this are closed
  double hole = 0;  // holes whose diagonal is not longer than this are filled
};

/// A surface after its repair.
struct Repaired {
  Triangles surface;
  std::vector<std::string> changes;    // one clause for each kind of change; empty if nothing was changed
  std::vector<std::string> judgement;  // what judge_bodies() changed, as "is inside out and was turned"
};

/// Welds points, drops faces without area and faces that occur twice, closes slits, turns faces alike, stitches, fills
/// small holes, drops loose faces and unites bodies that overlap. Defects that it cannot cure remain; find_defects
/// finds them.
Repaired repair(const Triangles& surface, const RepairLimits& limits);

/// The surface with every face turned over.
Triangles turned(Triangles surface);

}  // namespace thalweg::gencase
