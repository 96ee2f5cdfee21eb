#include "gencase/filling.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/error.hpp"
#include "gencase/parallel.hpp"

namespace thalweg::gencase {
namespace {

/// The shift [m] at which membership is tested, so that nodes on faces belong to one side.
Vec3 tie_break(const Lattice& lattice) {
  const double nudge = 1e-6 * lattice.spacing;
  return {nudge, lattice.dimension == 2 ? 0 : nudge, nudge};
}

/// Index of the n-th column of a range.
std::int64_t column_of(const Lattice& lattice, const ColumnRange& range, std::int64_t n) {
  const int slow = lattice.axes[0];
  const int middle = lattice.axes[1];
  const std::int64_t width = range.end[middle] - range.begin[middle];
  return (range.begin[slow] + n / width) * lattice.count[middle] + range.begin[middle] + n % width;
}

/// Gives the nodes of one column that lie in shape `s` to it.
void claim_column(const std::vector<PlacedShape>& shapes, std::size_t s, std::span<Label> column, const Line& line,
                  ShapeFill& fill) {
  const PlacedShape& shape = shapes[s];
  const bool clears = shape.shape->role == ShapeRole::empty;
  const auto own = static_cast<Label>(s + 1);
  for_runs(line, shape.body->cut(line), [&](std::int64_t first, std::int64_t last) {
    for (std::int64_t node = first; node <= last; ++node) {
      Label& label = column[static_cast<std::size_t>(node)];
      if (clears) {
        fill.claimed += label != nothing;
        label = nothing;
      } else if (label != nothing && shape.yields_to(shapes[label - 1U])) {
        ++fill.inside_wall;
      } else {
        ++fill.claimed;
        label = own;
      }
    }
  });
}

/// Appends normals and distances of one column's wall nodes to `walls`; nodes that are too deep become `solid_core`.
void settle_column(const std::vector<PlacedShape>& shapes, const std::vector<const SkinSearch*>& skins,
                   const Lattice& lattice, std::int64_t column, std::span<Label> labels,
                   std::vector<WallPoint>& walls) {
  // A wall particle exactly on the skin gets this distance, so that divisions by it stay finite.
  const double least = 1e-6 * lattice.spacing;
  // Lower bound of the node's distance to the skin: the last known distance, less the way from there.
  double farther_than = 0;
  const SkinSearch* skin = nullptr;
  for (std::size_t node = 0; node < labels.size(); ++node, farther_than -= lattice.spacing) {
    Label& label = labels[node];
    if (label == nothing || !shapes[label - 1U].is_wall()) continue;
    const PlacedShape& shape = shapes[label - 1U];
    if (skin != skins[label - 1U]) skin = skins[label - 1U], farther_than = 0;
    // All layers of a container are kept: it was made as thick as wanted, and is thicker at its corners.
    // A node as deep as the wall is thick has none, also where rounding puts it a little nearer to the skin.
    constexpr double rounding = 1e-9;
    const double reach =
        shape.is_container() ? std::numeric_limits<double>::infinity() : shape.thickness * (1 - rounding);
    if (farther_than >= reach) {
      label = solid_core;
      continue;
    }
    const auto index = column * lattice.column_length() + static_cast<std::int64_t>(node);
    const auto nearest = skin->find(lattice.position(lattice.offset(index)), std::numeric_limits<double>::infinity());
    if (nearest) farther_than = nearest->distance;
    if (!nearest || nearest->distance >= reach) {
      label = solid_core;
      continue;
    }
    walls.push_back({nearest->direction.cast<float>(), static_cast<float>(std::max(nearest->distance, least))});
  }
}

}  // namespace

Filling claim_nodes(const std::vector<PlacedShape>& shapes, const Lattice& lattice, Progress& progress) {
  if (shapes.size() >= solid_core) throw InputError("a case cannot have more than 65534 shapes; combine some by union");
  Filling filling{lattice,
                  std::vector<Label>(static_cast<std::size_t>(lattice.nodes()), nothing),
                  std::vector<ShapeFill>(shapes.size()),
                  {},
                  0};
  const Vec3 nudge = tie_break(lattice);
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    const ColumnRange range = columns_within(lattice, shapes[s].body->bounds());
    PerThread<ShapeFill> fills;
    progress.stage("filling " + shapes[s].shape->name, range.columns(lattice));
    for_parts(range.columns(lattice), progress, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t n = begin; n < end; ++n) {
        const std::int64_t column = column_of(lattice, range, n);
        claim_column(shapes, s, filling.column(column), line_of(lattice, column, nudge), fills.local());
      }
    });
    filling.shapes[s] = fills.total([](ShapeFill& sum, const ShapeFill& part) {
      sum.claimed += part.claimed;
      sum.inside_wall += part.inside_wall;
    });
  }
  count_kept(shapes, filling);
  return filling;
}

void count_kept(const std::vector<PlacedShape>& shapes, Filling& filling) {
  for (ShapeFill& fill : filling.shapes) fill.kept = 0;
  filling.particles = 0;
  for (const Label label : filling.label) {
    if (label == nothing || label == solid_core) continue;
    ++filling.shapes[label - 1U].kept;
    if (shapes[label - 1U].shape->role != ShapeRole::empty) ++filling.particles;
  }
}

void settle_walls(const std::vector<PlacedShape>& shapes, const std::vector<const SkinSearch*>& skins, Filling& filling,
                  Progress& progress) {
  const Lattice& lattice = filling.lattice;
  const bool any = std::any_of(shapes.begin(), shapes.end(), [](const PlacedShape& shape) { return shape.is_wall(); });
  if (!any) return;
  // Every slab of columns has its own list, so that the order does not depend on the order of the threads.
  const std::int64_t slabs = lattice.count[lattice.axes[0]];
  const std::int64_t columns_of_slab = lattice.count[lattice.axes[1]];
  std::vector<std::vector<WallPoint>> walls(static_cast<std::size_t>(slabs));
  progress.stage("wall normals", slabs);
  tbb::parallel_for(std::int64_t{0}, slabs, [&](std::int64_t slab) {
    for (std::int64_t column = slab * columns_of_slab; column < (slab + 1) * columns_of_slab; ++column)
      settle_column(shapes, skins, lattice, column, filling.column(column), walls[static_cast<std::size_t>(slab)]);
    progress.add(1);
  });
  std::size_t count = 0;
  for (const auto& slab : walls) count += slab.size();
  filling.walls.reserve(count);
  for (auto& slab : walls) {
    filling.walls.insert(filling.walls.end(), slab.begin(), slab.end());
    slab = {};
  }
  count_kept(shapes, filling);
}

}  // namespace thalweg::gencase
