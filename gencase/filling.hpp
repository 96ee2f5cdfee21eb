#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gencase/lattice.hpp"
#include "gencase/progress.hpp"
#include "gencase/shapes.hpp"

namespace thalweg::gencase {

/// What stands at a lattice node: nothing, the place of a shape in the list plus one, or the core of a solid, too deep
/// below its skin for a particle.
using Label = std::uint16_t;
inline constexpr Label nothing = 0;
inline constexpr Label solid_core = 0xFFFF;

/// What became of one shape's nodes.
struct ShapeFill {
  std::int64_t claimed = 0;      // nodes it got when its turn came
  std::int64_t inside_wall = 0;  // nodes a fluid asked for that an earlier wall keeps
  std::int64_t kept = 0;         // nodes that are its particles in the end
};

/// Unit vector into the flow and distance [m] to the flow of one wall particle.
struct WallPoint {
  Eigen::Vector3f normal;
  float distance;
};

/// A filled lattice.
struct Filling {
  Lattice lattice;
  std::vector<Label> label;       // per node, Lattice::flat order
  std::vector<ShapeFill> shapes;  // per placed shape
  std::vector<WallPoint> walls;   // per wall particle, in the order of its node
  std::int64_t particles = 0;

  [[nodiscard]] std::span<Label> column(std::int64_t index) {
    return {label.data() + index * lattice.column_length(), static_cast<std::size_t>(lattice.column_length())};
  }
};

/// Lays the shapes over the lattice in their order: later shapes take the place of earlier ones, "empty" ones clear
/// nodes, and fluids never enter walls. A node belongs to a shape when the point a millionth of the spacing above it in
/// every direction does, so that a node on the common face of two shapes belongs to exactly one of them.
Filling claim_nodes(const std::vector<PlacedShape>& shapes, const Lattice& lattice, Progress& progress);

/// Counts the particles of every shape again.
void count_kept(const std::vector<PlacedShape>& shapes, Filling& filling);

/// Finds normal and distance of every wall node, drops the nodes of solids deeper than their wall's thickness, and
/// counts what is left. `skins` has for every shape the search of its skin; that of others is never asked for.
void settle_walls(const std::vector<PlacedShape>& shapes, const std::vector<const SkinSearch*>& skins, Filling& filling,
                  Progress& progress);

}  // namespace thalweg::gencase
