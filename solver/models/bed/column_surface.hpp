#pragma once

#include "solver/models/bed/column_weight.hpp"

// The bed's surface over each column, and the height of bed above each node. Bodies are bed to what lies below them: a
// pipe in a bed carries the bed above it, so that the sediment under it has the effective pressure of its depth. Under a
// body that nothing lies on, a pipe half in the bed or the foot of a gate, the surface is that of the bed beside it.
namespace thalweg {

/// One column, from its node 0 up.
struct ColumnWalk {
  const std::int64_t* deposited;
  const std::uint8_t* content;
  float height_per_quantum;  // [m]
  float spacing;             // [m]

  [[nodiscard]] HOST_DEVICE ColumnWalk at(std::int64_t node) const {
    return {deposited + node, content + node, height_per_quantum, spacing};
  }
  /// True if a node lies in a body: next to a wall, or in the hollow between walls that has no particles.
  HOST_DEVICE bool in_body(int level, bool below_body) const {
    if (content[level] == column_node::wall) return true;
    if (!below_body || content[level] != column_node::empty) return false;
    while (level > 0 && content[level] == column_node::empty) --level;
    return content[level] == column_node::wall;
  }
  /// True if a node has less than a tenth of the sediment that fills it: what hovers above is no load on what lies below.
  HOST_DEVICE bool is_gap(int level) const {
    return static_cast<float>(deposited[level]) * height_per_quantum < 0.1F * spacing;
  }
  /// The sediment that fills a node.
  [[nodiscard]] HOST_DEVICE std::int64_t full() const {
    return static_cast<std::int64_t>(spacing / height_per_quantum);
  }
  /// The part of a node [0, 1] that lies below the top of a bed, which is a spacing above its surface [m].
  [[nodiscard]] HOST_DEVICE float part_of_bed(float surface, int level) const {
    const float part = surface / spacing + 1 - (static_cast<float>(level) - 0.5F);
    return part < 0 ? 0 : part > 1 ? 1 : part;
  }
};

/// Pass over the columns: the bed's surface, one spacing of bed below its top, so that flying grains are not taken for
/// it; and if sediment lies right below a body that has no sediment on it.
template <int Dim>
struct ColumnSurfacePass {
  using reads = Reads<>;
  using writes = Writes<>;

  ColumnLattice<Dim> columns;
  ColumnWalk first;  // of column 0
  float* surface;
  std::uint8_t* covered;

  HOST_DEVICE void operator()(Index column) const {
    const int levels = columns.levels();
    const ColumnWalk walk = first.at(static_cast<std::int64_t>(column) * levels);
    const float spacing = walk.spacing;
    std::int64_t above = 0;
    float next = 0;
    bool below_body = false;
    bool below_cover = false;
    surface[column] = no_surface;
    covered[column] = 0;
    for (int level = levels - 1; level >= 0; --level) {
      below_body = walk.in_body(level, below_body);
      if (below_body && above == 0) {
        below_cover = true;
        continue;
      }
      if (!below_body && walk.is_gap(level)) {
        above = 0, next = 0;
        below_cover = false;
        continue;
      }
      if (below_cover) covered[column] = 1;
      const std::int64_t own = below_body ? walk.full() : walk.deposited[level];
      const float height = static_cast<float>(2 * above + own) * (0.5F * walk.height_per_quantum);
      if (next < spacing && height >= spacing) {
        surface[column] = (static_cast<float>(level) + (height - spacing) / (height - next)) * spacing;
      }
      next = height;
      above += own;
    }
  }
};

/// Pass over the columns below a cover: the surface from the next columns without one, in each direction of the lattice,
/// weighted by one over their distance. Where there are none it stays.
template <int Dim>
struct CoveredSurfacePass {
  using reads = Reads<>;
  using writes = Writes<>;

  ColumnLattice<Dim> columns;
  const std::uint8_t* covered;
  float* surface;

  HOST_DEVICE void operator()(Index column) const {
    if (covered[column] == 0) return;
    const int own[2] = {static_cast<int>(column) % columns.nodes[0], static_cast<int>(column) / columns.nodes[0]};
    float sum = 0;
    float weights = 0;
    for (int k = 0; k + 1 < Dim; ++k) {
      for (int way = -1; way <= 1; way += 2) {
        for (int step = 1; step < columns.nodes[k]; ++step) {
          const int node = columns.inside(k, own[k] + way * step);
          if (node < 0) break;
          const int other = k == 0 ? own[1] * columns.nodes[0] + node : node * columns.nodes[0] + own[0];
          if (covered[other] != 0 || surface[other] == no_surface) continue;
          const float weight = 1 / static_cast<float>(step);
          sum += weight * surface[other];
          weights += weight;
          break;
        }
      }
    }
    if (weights > 0) surface[column] = sum / weights;
  }
};

/// Pass over the columns: height of bed above each node, its own half included; of bodies with nothing on them the part
/// below the bed's surface.
template <int Dim>
struct HeightAbovePass {
  using reads = Reads<>;
  using writes = Writes<>;

  ColumnLattice<Dim> columns;
  ColumnWalk first;  // of column 0
  const float* surface;
  const std::uint8_t* covered;
  float* height_above;

  HOST_DEVICE void operator()(Index column) const {
    const int levels = columns.levels();
    const std::int64_t base = static_cast<std::int64_t>(column) * levels;
    const ColumnWalk walk = first.at(base);
    std::int64_t above = 0;
    bool below_body = false;
    for (int level = levels - 1; level >= 0; --level) {
      below_body = walk.in_body(level, below_body);
      std::int64_t own = walk.deposited[level];
      if (below_body) {
        const float part = above > 0 ? 1 : covered[column] != 0 ? walk.part_of_bed(surface[column], level) : 0;
        own = static_cast<std::int64_t>(part * static_cast<float>(walk.full()));
      } else if (walk.is_gap(level)) {
        above = 0;
      }
      height_above[base + level] = static_cast<float>(2 * above + own) * (0.5F * walk.height_per_quantum);
      above += own;
    }
  }
};

}  // namespace thalweg
