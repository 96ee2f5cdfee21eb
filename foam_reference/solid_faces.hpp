#pragma once

#include <cstddef>
#include <vector>

#include "foam_reference/case_files.hpp"

namespace thalweg::foam {

/// Faces of the block's outer face beside an opening that a solid wall closes: it stands behind the plane in which the
/// block ends, as a gate does over its slot. Without them such a face lets water out.
struct SolidFaces {
  std::size_t solids = 0;  // index of the wall's patch, of solid_roughnesses
  Bounds bounds;           // [m] of whole cells, with a hundredth of a cell along the plane's axis to both sides
};

/// Those faces, in rows of equal cells joined to boxes.
std::vector<SolidFaces> solid_faces(const FoamCase& foam_case);

}  // namespace thalweg::foam
