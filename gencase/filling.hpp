#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gencase/lattice.hpp"
#include "gencase/progress.hpp"
#include "gencase/shapes.hpp"

namespace thalweg::gencase {

/// Owner of a lattice node: nothing, a shape (its index in the list plus one), or the core of a solid, which is too
/// deep below the skin for a particle.
using Label = std::uint16_t;
inline constexpr Label nothing = 0;
inline constexpr Label solid_core = 0xFFFF;

/// Numbers of nodes of one shape.
struct ShapeFill {
  std::int64_t claimed = 0;      // that it got when it was filled
  std::int64_t inside_wall = 0;  // that lie in it and stay with an earlier wall
  std::int64_t kept = 0;         // that are its particles in the end
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
  std::vector<WallPoint> walls;   // per wall particle, in the order of the nodes
  std::int64_t particles = 0;

  [[nodiscard]] std::span<Label> column(std::int64_t index) {
    return {label.data() + index * lattice.column_length(), static_cast<std::size_t>(lattice.column_length())};
  }
};

/// Gives the nodes of the lattice to the shapes, in the order of the case: later shapes replace earlier ones, "empty"
/// shapes clear nodes, and fluids never enter walls. Membership is tested a millionth of the spacing above the node in
/// every direction, so that a node on the common face of two shapes belongs to exactly one of them.
Filling claim_nodes(const std::vector<PlacedShape>& shapes, const Lattice& lattice, Progress& progress);

/// Counts the particles of every shape again.
void count_kept(const std::vector<PlacedShape>& shapes, Filling& filling);

/// Finds normal and distance of every wall node, makes nodes deeper than their wall's thickness `solid_core`, and
/// counts the particles again. `skins` has one entry for each shape; those of shapes that are no walls are not used.
void settle_walls(const std::vector<PlacedShape>& shapes, const std::vector<const SkinSearch*>& skins, Filling& filling,
                  Progress& progress);

}  // namespace thalweg::gencase
