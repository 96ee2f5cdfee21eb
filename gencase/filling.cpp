#include "gencase/filling.hpp"

#include <limits>

#include "common/error.hpp"
#include "gencase/nearest_surface.hpp"

namespace thalweg::gencase {
namespace {

Vec3 tie_break(const Lattice& lattice) {
  const double nudge = 1e-6 * lattice.spacing;
  return {nudge, lattice.dimension == 2 ? 0 : nudge, nudge};
}

}  // namespace

Filling claim_nodes(const std::vector<PlacedShape>& shapes, const Lattice& lattice) {
  if (shapes.size() >= solid_core) throw InputError("a case cannot have more than 65534 shapes; combine some by union");
  Filling filling{lattice,
                  std::vector<Label>(static_cast<std::size_t>(lattice.nodes()), nothing),
                  std::vector<ShapeFill>(shapes.size()),
                  {},
                  0};
  const Vec3 nudge = tie_break(lattice);
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    const PlacedShape& shape = shapes[s];
    ShapeFill& fill = filling.shapes[s];
    const bool clears = shape.shape->role == ShapeRole::empty;
    const auto own = static_cast<Label>(s + 1);
    for_nodes_within(lattice, shape.body->bounds(), [&](std::int64_t node, const Vec3& position) {
      if (!shape.body->contains(position + nudge)) return;
      Label& label = filling.label[static_cast<std::size_t>(node)];
      if (clears) {
        fill.claimed += label != nothing;
        label = nothing;
      } else if (shape.is_fluid() && label != nothing && shapes[label - 1U].is_wall()) {
        ++fill.inside_wall;
      } else {
        ++fill.claimed;
        label = own;
      }
    });
  }
  for (const Label label : filling.label)
    if (label != nothing) {
      ++filling.shapes[label - 1U].kept;
      if (shapes[label - 1U].shape->role != ShapeRole::empty) ++filling.particles;
    }
  return filling;
}

void settle_walls(const std::vector<PlacedShape>& shapes, const FlowRoom& room, Filling& filling) {
  const Lattice& lattice = filling.lattice;
  const NearestSurface nearest(room, lattice.spacing);
  // A wall particle exactly on the skin gets this distance, so that divisions by it stay finite.
  const double least = 1e-6 * lattice.spacing;
  for (std::int64_t node = 0; node < lattice.nodes(); ++node) {
    Label& label = filling.label[static_cast<std::size_t>(node)];
    if (label == nothing || !shapes[label - 1U].is_wall()) continue;
    const PlacedShape& shape = shapes[label - 1U];
    // A container's layers are all kept: they are as deep as asked for by construction, deeper in corners.
    const double reach = shape.is_container() ? std::numeric_limits<double>::infinity() : shape.thickness;
    const auto skin = nearest.find(lattice.position(lattice.offset(node)), reach);
    if (!skin) {
      --filling.shapes[label - 1U].kept;
      --filling.particles;
      label = solid_core;
      continue;
    }
    filling.walls.push_back({skin->direction.cast<float>(), static_cast<float>(std::max(skin->distance, least))});
  }
}

}  // namespace thalweg::gencase
