#pragma once

#include <algorithm>
#include <cmath>

#include "solver/state/particles.hpp"
#include "solver/state/scene.hpp"

namespace thalweg {

/// A lattice of vertical columns one spacing apart.
template <int Dim>
struct ColumnLattice {
  Vec<Dim, double> from{};     // [m]
  double inverse_spacing = 0;  // [1/m]
  Vec<Dim, int> nodes{};
  bool periodic[Dim] = {};
  double quanta_per_volume = 0;

  explicit ColumnLattice(const Scene<Dim>& scene) {
    inverse_spacing = 1 / scene.spacing;
    for (int k = 0; k < Dim; ++k) {
      // Nodes where the particles started, so that a column at a wall is covered whole or not at all.
      const double to_node = scene.lattice_node[k] - scene.domain_from[k];
      from[k] = scene.lattice_node[k] - std::ceil(to_node * inverse_spacing) * scene.spacing;
      nodes[k] = static_cast<int>(std::ceil((scene.domain_to[k] - from[k]) * inverse_spacing)) + 2;
      periodic[k] = scene.lattice.periodic[k];
      if (periodic[k])
        nodes[k] = std::max(1, static_cast<int>(std::lround((scene.domain_to[k] - from[k]) * inverse_spacing)));
    }
    quanta_per_volume = 4294967296.0 * std::pow(inverse_spacing, Dim);
  }

  [[nodiscard]] HOST_DEVICE int columns() const {
    int n = 1;
    for (int k = 0; k + 1 < Dim; ++k) n *= nodes[k];
    return n;
  }
  [[nodiscard]] HOST_DEVICE int levels() const { return nodes[Dim - 1]; }

  /// Node below a coordinate, and how far towards the next one it lies [0, 1).
  HOST_DEVICE int below(int k, double x, float& fraction) const {
    const double at = (x - from[k]) * inverse_spacing;
    const double node = floor(at);
    fraction = static_cast<float>(at - node);
    return static_cast<int>(node);
  }
  /// Index of a column direction's node inside the lattice: around a period, or -1 beyond an end.
  HOST_DEVICE int inside(int k, int node) const {
    if (periodic[k]) return (node % nodes[k] + nodes[k]) % nodes[k];
    return node >= 0 && node < nodes[k] ? node : -1;
  }
  /// A place between nodes: the nodes below it, and how far towards the next ones it lies [0, 1).
  struct Cell {
    int node[Dim];
    float fraction[Dim];

    /// Linear share of the lower node along k (step 0) or of the next one (step 1) in what lies at the place.
    [[nodiscard]] HOST_DEVICE float share(int k, int step) const { return step != 0 ? fraction[k] : 1 - fraction[k]; }
  };
  [[nodiscard]] HOST_DEVICE Cell cell_of(const Position& at) const {
    Cell cell;
    for (int k = 0; k < Dim; ++k) cell.node[k] = below(k, at.x[axis<Dim>(k)], cell.fraction[k]);
    return cell;
  }
  /// Number of columns among which a place is shared.
  static constexpr int corners = 1 << (Dim - 1);
  /// Index of the column at a corner of a cell (bit k of `corner`: the next node along k), or -1 beyond the lattice.
  /// `share` becomes the column's linear share [-] in what lies at the place; beyond the lattice it has no meaning.
  HOST_DEVICE int column_at(const Cell& cell, int corner, float& share) const {
    share = 1;
    int column = 0;
    for (int k = Dim - 2; k >= 0; --k) {
      const int step = (corner >> k) & 1;
      share *= cell.share(k, step);
      const int n = inside(k, cell.node[k] + step);
      if (n < 0) return -1;
      column = column * nodes[k] + n;
    }
    return column;
  }
  /// Index of the column closest to a place, or -1 beyond the lattice.
  [[nodiscard]] HOST_DEVICE int nearest_column(const Position& at) const {
    int column = 0;
    for (int k = Dim - 2; k >= 0; --k) {
      float share;
      const int node = below(k, at.x[axis<Dim>(k)], share);
      const int n = inside(k, share < 0.5F ? node : node + 1);
      if (n < 0) return -1;
      column = column * nodes[k] + n;
    }
    return column;
  }
  /// Index of the node closest to a place, or -1 beyond the lattice.
  [[nodiscard]] HOST_DEVICE std::int64_t nearest(const Position& at) const {
    float share;
    const int below_it = below(Dim - 1, at.x[axis<Dim>(Dim - 1)], share);
    const int level = share < 0.5F ? below_it : below_it + 1;
    const int column = nearest_column(at);
    if (column < 0 || level < 0 || level >= levels()) return -1;
    return static_cast<std::int64_t>(column) * levels() + level;
  }
};

/// Number of nodes of a scene's columns.
template <int Dim>
double nodes_of_columns(const Scene<Dim>& scene) {
  const ColumnLattice<Dim> columns(scene);
  return double(columns.columns()) * columns.levels();
}

}  // namespace thalweg
