#pragma once

#include <cmath>

#include "solver/backend/members.hpp"
#include "solver/models/bed/column_lattice.hpp"
#include "solver/models/wall_stress/arrays.hpp"

// The surfaces of walls and beds on the lattice of columns (models/bed/column_lattice.hpp): next to a node lies a piece
// of a plane, the mean of the wall elements and of the bed's surface particles there. Sums are whole numbers, so that
// the order of particles means nothing.
namespace thalweg {

/// Sums of the pieces next to one node, in millionths (2^-20).
template <int Dim>
struct SurfaceNode {
  std::int64_t number;       // of pieces
  std::int64_t level;        // of the plane along the normal, from the node [spacings]
  std::int64_t normal[Dim];  // unit vectors into the water
};
inline constexpr double surface_quanta = 1048576;

/// Marks a node that knows no surface yet.
inline constexpr Index no_surface_node = ~Index{0};

/// The nodes with their surfaces, and the distance from a place to one of them.
template <int Dim>
struct SurfaceLattice {
  ColumnLattice<Dim> columns;
  Vec<Dim, double> period{};  // [m], 0 in directions without
  const SurfaceNode<Dim>* nodes = nullptr;
  double spacing = 0;

  SurfaceLattice(const Scene<Dim>& scene, const SurfaceNode<Dim>* of)
      : columns(scene), nodes(of), spacing(scene.spacing) {
    for (int k = 0; k < Dim; ++k) period[k] = scene.lattice.periodic[k] ? scene.lattice.range[k] : 0;
  }

  [[nodiscard]] HOST_DEVICE std::int64_t size() const {
    return static_cast<std::int64_t>(columns.columns()) * columns.levels();
  }
  /// Numbers along the axes of a node: the height is the fastest.
  HOST_DEVICE void indices(Index node, int (&at)[Dim]) const {
    at[Dim - 1] = static_cast<int>(node % static_cast<Index>(columns.levels()));
    Index rest = node / static_cast<Index>(columns.levels());
    for (int k = 0; k + 1 < Dim; ++k) {
      at[k] = static_cast<int>(rest % static_cast<Index>(columns.nodes[k]));
      rest /= static_cast<Index>(columns.nodes[k]);
    }
  }
  [[nodiscard]] HOST_DEVICE Index node(const int (&at)[Dim]) const {
    std::int64_t column = 0;
    for (int k = Dim - 2; k >= 0; --k) column = column * columns.nodes[k] + at[k];
    return static_cast<Index>(column * columns.levels() + at[Dim - 1]);
  }
  [[nodiscard]] HOST_DEVICE Vec<Dim, double> place(Index node) const {
    int at[Dim];
    indices(node, at);
    Vec<Dim, double> x{};
    for (int k = 0; k < Dim; ++k) x[k] = columns.from[k] + at[k] * spacing;
    return x;
  }

  /// Distance [m] from a place to the surface next to a node. The surface is a disc with the radius of half a spacing
  /// (0.71 in space, so that discs one spacing apart leave no gap). Infinite if there is none, and for places more than
  /// two radii behind it: what is there belongs to another side of the wall.
  [[nodiscard]] HOST_DEVICE float distance(const Vec<Dim, double>& to, Index from) const {
    if (from == no_surface_node || nodes[from].number == 0) return INFINITY;
    const SurfaceNode<Dim>& surface = nodes[from];
    const Vec<Dim, double> origin = place(from);
    float normal2 = 0;
    for (int k = 0; k < Dim; ++k) {
      const auto n = static_cast<float>(surface.normal[k]);
      normal2 += n * n;
    }
    const auto number = static_cast<float>(surface.number);
    if (!(normal2 > 0.01F * number * number)) return INFINITY;  // the two sides of a thin plate
    const float inverse = 1 / sqrtf(normal2);
    float along = 0;
    float square = 0;
    for (int k = 0; k < Dim; ++k) {
      double r = to[k] - origin[k];
      if (period[k] > 0) r -= period[k] * floor(r / period[k] + 0.5);
      along += static_cast<float>(r) * static_cast<float>(surface.normal[k]) * inverse;
      square += static_cast<float>(r * r);
    }
    const auto dp = static_cast<float>(spacing);
    const float radius = Dim == 2 ? 0.5F * dp : 0.7071F * dp;
    const float above = along - static_cast<float>(surface.level) / number * dp;
    if (above < -2 * radius) return INFINITY;
    const float across2 = square - along * along;
    const float across = sqrtf(across2 > 0 ? across2 : 0) - radius;
    const float height = above > 0 ? above : 0;
    return across > 0 ? sqrtf(height * height + across * across) : height;
  }
};

/// Adds a piece of a surface, of a particle at x with the normal n and the depth below the surface [m], to its node.
template <int Dim, class AtomicAdd>
HOST_DEVICE inline void add_surface(const ColumnLattice<Dim>& columns, const Position& x, const float* normal,
                                    float depth, SurfaceNode<Dim>* nodes, const AtomicAdd& add) {
  const std::int64_t node = columns.nearest(x);
  if (node < 0) return;
  double level = double(depth) * columns.inverse_spacing;
  for (int k = 0; k < Dim; ++k) {
    const double at = (x.x[axis<Dim>(k)] - columns.from[k]) * columns.inverse_spacing;
    level += double(normal[axis<Dim>(k)]) * (at - floor(at + 0.5));
    add(&nodes[node].normal[k], static_cast<std::int64_t>(double(normal[axis<Dim>(k)]) * surface_quanta));
  }
  add(&nodes[node].number, static_cast<std::int64_t>(surface_quanta));
  add(&nodes[node].level, static_cast<std::int64_t>(level * surface_quanta));
}

/// Pass over the walls' particles: their elements.
template <int Dim, class AtomicAdd>
struct AddWallsPass {
  using reads = Reads<field::place, field::position, field::wall_element, field::wall_normal>;
  using writes = Writes<>;

  const Record* records;
  const Position* positions;
  const WallElement* elements;
  const WallNormal* turned;  // nullptr: no wall moves
  ColumnLattice<Dim> columns;
  SurfaceNode<Dim>* nodes;
  AtomicAdd add;
  Index first;  // wall particle

  HOST_DEVICE void operator()(Index n) const {
    const Index i = first + n;
    if (records[i].volume == 0 || !(elements[i].area > 0)) return;
    const float* normal = turned == nullptr ? elements[i].normal : turned[i].of;
    add_surface(columns, positions[i], normal, elements[i].depth, nodes, add);
  }
};

/// Particle pass over the surface of the bed: a sediment particle with water nearer than 1.6 spacings is a piece of the
/// surface, which lies half a spacing above it along the gradient of what is solid. A grain with less than a quarter of
/// its surroundings full flies and is no bed.
template <int Dim, class AtomicAdd>
struct AddBedPass {
  using neighbours = Neighbours<field::place, field::matter>;
  using reads = Reads<field::place, field::matter, field::position>;
  using writes = Writes<>;

  const Record* records;
  const Position* positions;
  ClusterList list;
  Scene<Dim> scene;
  ColumnLattice<Dim> columns;
  SurfaceNode<Dim>* nodes;
  AtomicAdd add;

  HOST_DEVICE void operator()(Index i) const {
    const Record& own = records[i];
    if (!is_sediment(own) || own.kind == kind::suspended || own.volume == 0) return;
    const auto dp = static_cast<float>(scene.spacing);
    const float next = 1.6F * dp;
    const float support = scene.support();
    bool wet = false;
    float solid = 0;
    Vec<Dim, float> outward{};
    const Index cluster = list.cluster_of(i);
    for (Index entry = list.begin[cluster]; entry < list.begin[cluster + 1]; ++entry) {
      const Index j = list.entries[entry];
      if (j == list.none || j == i || records[j].volume == 0) continue;
      const Vec<Dim, float> r = scene.separation(own.place, records[j].place);
      const float r2 = dot(r, r);
      if (!(r2 < support * support)) continue;
      if (is_water(records[j])) {
        wet = wet || r2 < next * next;
        continue;
      }
      const float closeness = scene.kernel.closeness(sqrtf(r2));
      solid += records[j].volume * scene.kernel.value(closeness);
      const float slope = records[j].volume * scene.kernel.gradient(closeness);
      for (int k = 0; k < Dim; ++k) outward[k] -= slope * r[k];
    }
    const float length = sqrtf(dot(outward, outward));
    if (!wet || solid < 0.25F || !(length > 0)) return;
    float normal[3] = {0, 0, 0};
    for (int k = 0; k < Dim; ++k) normal[axis<Dim>(k)] = outward[k] / length;
    add_surface(columns, positions[i], normal, 0.5F * dp, nodes, add);
  }
};

}  // namespace thalweg
