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
  typename Device::template Buffer<std::uint8_t> under_water;  // per column: any water here
  typename Device::template Buffer<std::uint8_t> content;      // per node: column_node
  typename Device::template Buffer<std::uint8_t> covered;      // per column: sediment right below a body
};

/// The content of a node: of the walls if one is next to it, or else of the fluid.
namespace column_node {
inline constexpr std::uint8_t empty = 0;
inline constexpr std::uint8_t fluid = 1;
inline constexpr std::uint8_t wall = 2;
}  // namespace column_node

/// A column without a bed to speak of: less than one spacing of sediment.
inline constexpr float no_surface = -1;

/// Particle pass: shares each sediment particle's volume among the nodes around it (linearly), marks wetted columns and
/// the nodes next to fluid.
template <int Dim, class AtomicAdd>
struct DepositPass {
  using reads = Reads<field::place, field::matter, field::position>;
  using writes = Writes<>;

  const Record* records;
  const Position* positions;
  ColumnLattice<Dim> columns;
  std::int64_t* deposited;
  std::uint8_t* wetted;
  std::uint8_t* under_water;
  std::uint8_t* content;
  AtomicAdd atomic_add_to;

  HOST_DEVICE void operator()(Index i) const {
    const Record& r = records[i];
    if (r.volume == 0) return;
    const std::int64_t nearest = columns.nearest(positions[i]);
    if (nearest >= 0) content[nearest] = column_node::fluid;
    const auto cell = columns.cell_of(positions[i]);
    const int levels = columns.levels();
    for (int corner = 0; corner < ColumnLattice<Dim>::corners; ++corner) {
      float share;
      const int column = columns.column_at(cell, corner, share);
      if (column < 0) continue;
      if (share >= 0.5F) wetted[column] = 1;
      if (share >= 0.5F && is_water(r)) under_water[column] = 1;
      if (!is_sediment(r)) continue;
      for (int up = 0; up < 2; ++up) {
        const int level = cell.node[Dim - 1] + up;
        if (level < 0 || level >= levels) continue;
        const float weight = share * cell.share(Dim - 1, up);
        atomic_add_to(deposited + static_cast<std::int64_t>(column) * levels + level,
                      static_cast<std::int64_t>(static_cast<double>(weight * r.volume) * columns.quanta_per_volume));
      }
    }
  }
};

/// Pass over the walls: marks the nodes next to them, also where fluid has marked them.
template <int Dim>
struct MarkWallsPass {
  using reads = Reads<field::position>;
  using writes = Writes<>;

  const Position* positions;
  ColumnLattice<Dim> columns;
  std::uint8_t* content;

  HOST_DEVICE void operator()(Index i) const {
    const std::int64_t nearest = columns.nearest(positions[i]);
    if (nearest >= 0) content[nearest] = column_node::wall;
  }
};

}  // namespace thalweg
