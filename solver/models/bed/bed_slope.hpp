#pragma once

#include "solver/models/bed/column_weight.hpp"

namespace thalweg {

/// Pass over the columns: tangent of the slope of the plane that fits the bed's surface best within a support to either
/// side, weighted towards the middle; 0 where too few columns have a bed.
template <int Dim>
struct ColumnSlopePass {
  using reads = Reads<>;
  using writes = Writes<>;

  ColumnLattice<Dim> columns;
  const float* surface;
  float* slope;
  float spacing;  // [m]
  int reach;      // [spacings]

  HOST_DEVICE void operator()(Index column) const {
    const int own[2] = {static_cast<int>(column) % columns.nodes[0], static_cast<int>(column) / columns.nodes[0]};
    const int rows = Dim == 3 ? reach : 0;
    float w = 0, wx = 0, wy = 0, wz = 0, wxx = 0, wxy = 0, wyy = 0, wxz = 0, wyz = 0;
    for (int dy = -rows; dy <= rows; ++dy) {
      for (int dx = -reach; dx <= reach; ++dx) {
        int other = columns.inside(0, own[0] + dx);
        if constexpr (Dim == 3) {
          const int row = columns.inside(1, own[1] + dy);
          other = other < 0 || row < 0 ? -1 : row * columns.nodes[0] + other;
        }
        if (other < 0 || surface[other] == no_surface) continue;
        const float x = static_cast<float>(dx) * spacing;
        const float y = static_cast<float>(dy) * spacing;
        const float z = surface[other];
        const float one = static_cast<float>(reach + 1);
        const float weight = (1 - fabsf(static_cast<float>(dx)) / one) * (1 - fabsf(static_cast<float>(dy)) / one);
        w += weight, wx += weight * x, wy += weight * y, wz += weight * z;
        wxx += weight * x * x, wxy += weight * x * y, wyy += weight * y * y;
        wxz += weight * x * z, wyz += weight * y * z;
      }
    }
    slope[column] = 0;
    if (w == 0) return;
    const float cxx = wxx - wx * wx / w, cxz = wxz - wx * wz / w;
    const float least = 0.5F * w * spacing * spacing;  // the spread of three columns in a row
    if constexpr (Dim == 2) {
      if (cxx > least) slope[column] = fabsf(cxz / cxx);
    } else {
      const float cyy = wyy - wy * wy / w, cxy = wxy - wx * wy / w, cyz = wyz - wy * wz / w;
      const float det = cxx * cyy - cxy * cxy;
      if (det < least * least) return;
      const float sx = (cxz * cyy - cyz * cxy) / det;
      const float sy = (cyz * cxx - cxz * cxy) / det;
      slope[column] = sqrtf(sx * sx + sy * sy);
    }
  }
};

}  // namespace thalweg
