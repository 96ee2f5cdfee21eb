#pragma once

#include "solver/backend/device.hpp"
#include "solver/models/bed/column_lattice.hpp"
#include "solver/state/particles.hpp"

namespace thalweg {

/// Volume of sediment above each node of a lattice of columns one spacing apart. Volumes are summed as integers, so
/// that the result does not depend on the order of the particles.
template <class Device>
struct ColumnWeight {
  typename Device::template Buffer<std::int64_t> deposited;  // per node, in volume quanta
  typename Device::template Buffer<float> height_above;      // per node [m]
  typename Device::template Buffer<float> surface;           // per column: height of the bed's surface over node 0 [m]
  typename Device::template Buffer<float> slope;             // per column: tangent of the surface's steepest slope
  typename Device::template Buffer<std::uint8_t> wetted;     // per column: any fluid here
};

/// A column without a bed to speak of: less than one spacing of sediment.
inline constexpr float no_surface = -1;

/// Particle pass: shares each sediment particle's volume among the nodes around it (linearly), marks wetted columns.
template <int Dim, class AtomicAdd>
struct DepositPass {
  using reads = Reads<field::place, field::matter, field::position>;
  using writes = Writes<>;

  const Record* records;
  const Position* positions;
  ColumnLattice<Dim> columns;
  std::int64_t* deposited;
  std::uint8_t* wetted;
  AtomicAdd atomic_add_to;

  HOST_DEVICE void operator()(Index i) const {
    const Record& r = records[i];
    if (r.volume == 0) return;
    float share[Dim];
    int node[Dim];
    for (int k = 0; k < Dim; ++k) node[k] = columns.below(k, positions[i].x[axis<Dim>(k)], share[k]);
    const int levels = columns.levels();
    for (int corner = 0; corner < (1 << Dim); ++corner) {
      float weight = 1;
      int column = 0;
      bool in = true;
      for (int k = Dim - 2; k >= 0; --k) {
        const int step = (corner >> k) & 1;
        weight *= step != 0 ? share[k] : 1 - share[k];
        const int n = columns.inside(k, node[k] + step);
        in = in && n >= 0;
        column = column * columns.nodes[k] + n;
      }
      if (!in) continue;
      const int up = (corner >> (Dim - 1)) & 1;
      const int level = node[Dim - 1] + up;
      if (weight >= 0.5F) wetted[column] = 1;
      if (!is_sediment(r) || level < 0 || level >= levels) continue;
      weight *= up != 0 ? share[Dim - 1] : 1 - share[Dim - 1];
      atomic_add_to(deposited + static_cast<std::int64_t>(column) * levels + level,
                    static_cast<std::int64_t>(static_cast<double>(weight * r.volume) * columns.quanta_per_volume));
    }
  }
};

/// Pass over the columns: height of sediment above each node, its own half included, and the bed's surface: where one
/// spacing of sediment lies above, so that flying grains are not taken for it. Sediment that hovers over a gap, a node
/// with less than a tenth of a full one, is no load on what lies below.
template <int Dim>
struct HeightAbovePass {
  using reads = Reads<>;
  using writes = Writes<>;

  ColumnLattice<Dim> columns;
  const std::int64_t* deposited;
  float* height_above;
  float* surface;
  float height_per_quantum;  // [m]
  float spacing;             // [m]

  HOST_DEVICE void operator()(Index column) const {
    const int levels = columns.levels();
    const std::int64_t base = static_cast<std::int64_t>(column) * levels;
    std::int64_t above = 0;
    float next = 0;
    surface[column] = no_surface;
    for (int level = levels - 1; level >= 0; --level) {
      const std::int64_t own = deposited[base + level];
      if (static_cast<float>(own) * height_per_quantum < 0.1F * spacing) above = 0, next = 0;
      const float height = static_cast<float>(2 * above + own) * (0.5F * height_per_quantum);
      if (next < spacing && height >= spacing) {
        surface[column] = (static_cast<float>(level) + (height - spacing) / (height - next)) * spacing;
      }
      height_above[base + level] = next = height;
      above += own;
    }
  }
};

}  // namespace thalweg
