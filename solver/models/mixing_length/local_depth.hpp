#pragma once

#include <cmath>

#include "solver/backend/device.hpp"
#include "solver/models/bed/column_lattice.hpp"
#include "solver/models/mixing_length/arrays.hpp"

// Depth of the water around each particle, found where the neighbour lists are made: the volume of water in columns one
// spacing wide, averaged over the wet columns within a support. So it follows steps, slopes and waves, and a pier or the
// shore beside a column takes nothing from it. Volumes are summed as integers, so that the order of particles means
// nothing.
namespace thalweg {

/// Particle pass: shares the volume of water among the columns around it (linearly).
template <int Dim, class AtomicAdd>
struct FillColumnsPass {
  using reads = Reads<field::place, field::matter, field::position>;
  using writes = Writes<>;

  const Record* records;
  const Position* positions;
  ColumnLattice<Dim> columns;
  std::int64_t* filled;
  AtomicAdd atomic_add_to;

  HOST_DEVICE void operator()(Index i) const {
    const Record& r = records[i];
    if (r.volume == 0 || !is_water(r)) return;
    const auto cell = columns.cell_of(positions[i]);
    for (int corner = 0; corner < ColumnLattice<Dim>::corners; ++corner) {
      float share;
      const int column = columns.column_at(cell, corner, share);
      if (column < 0) continue;
      atomic_add_to(filled + column,
                    static_cast<std::int64_t>(static_cast<double>(share * r.volume) * columns.quanta_per_volume));
    }
  }
};

/// Pass over the columns: mean depth [m] of the wet columns within `reach` columns to each side. A column is wet from a
/// quarter of a spacing of water on.
template <int Dim>
struct ColumnDepthPass {
  using reads = Reads<>;
  using writes = Writes<>;

  ColumnLattice<Dim> columns;
  const std::int64_t* filled;
  float* depth;
  int reach;
  double depth_per_quantum;  // [m]

  HOST_DEVICE void operator()(Index column) const {
    int centre[Dim] = {};
    int rest = static_cast<int>(column);
    for (int k = 0; k + 1 < Dim; ++k) {
      centre[k] = rest % columns.nodes[k];
      rest /= columns.nodes[k];
    }
    const double wet = 0.25 / columns.inverse_spacing;
    double sum = 0;
    int number = 0;
    const int reach_y = Dim == 3 ? reach : 0;
    for (int y = -reach_y; y <= reach_y; ++y) {
      const int ny = Dim == 3 ? columns.inside(1, centre[1] + y) : 0;
      for (int x = -reach; x <= reach; ++x) {
        const int nx = columns.inside(0, centre[0] + x);
        if (nx < 0 || ny < 0) continue;
        const double here = static_cast<double>(filled[ny * columns.nodes[0] + nx]) * depth_per_quantum;
        if (!(here > wet)) continue;
        sum += here;
        ++number;
      }
    }
    depth[column] = number > 0 ? static_cast<float>(sum / number) : 0;
  }
};

/// Volumes and depths of the columns.
template <class Device>
struct LocalDepthWork {
  typename Device::template Buffer<std::int64_t> filled;  // [quanta of volume]
  typename Device::template Buffer<float> depth;          // [m]
};

/// Finds the depth of the water at all particles.
template <int Dim, class Device>
void find_local_depths(Device& on, Particles<Device>& p, const Scene<Dim>& scene, LocalDepthWork<Device>& work) {
  const ColumnLattice<Dim> columns(scene);
  const auto all = static_cast<std::size_t>(columns.columns());
  work.filled.resize(all);
  work.depth.resize(all);
  on.fill(work.filled, all, std::int64_t{0});
  const auto add = [] HOST_DEVICE(std::int64_t * to, std::int64_t amount) { Device::atomic_add(to, amount); };
  const Position* positions = p.position.data();
  on.for_each(p.fluid_count,
              FillColumnsPass<Dim, decltype(add)>{p.record.data(), positions, columns, work.filled.data(), add});
  on.share_sums(work.filled);
  const float* depth = work.depth.data();
  const double depth_per_quantum = 1 / (columns.quanta_per_volume * std::pow(scene.spacing, Dim - 1));
  const int reach = static_cast<int>(std::ceil(2 * scene.smoothing_length / scene.spacing));
  on.for_each(static_cast<Index>(all),
              ColumnDepthPass<Dim>{columns, work.filled.data(), work.depth.data(), reach, depth_per_quantum});
  Eddies* eddies = p.eddies.data();
  on.for_each(p.fluid_count, declare<Reads<field::position>, Writes<field::eddies>>([=] HOST_DEVICE(Index i) {
                const int column = columns.nearest_column(positions[i]);
                eddies[i].depth = column < 0 ? 0 : depth[column];
              }));
}

}  // namespace thalweg
