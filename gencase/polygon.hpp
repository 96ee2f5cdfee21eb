#pragma once

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// An edge of a region of the plane y = 0 with the region on its left, seen with x to the right and z upward [m].
struct Edge {
  Eigen::Vector2d from;  // x, z
  Eigen::Vector2d to;
};

/// The part of the plane y = 0 within closed loops of edges, given in any order.
RegionPointer make_polygon(std::vector<Edge> edges);

/// The edges of a simple polygon, turned so that its inside lies on their left.
std::vector<Edge> edges_of(const std::vector<Eigen::Vector2d>& polygon);

/// True if no two edges of the polygon cross or touch, other than neighbours in their common corner.
bool is_simple(const std::vector<Eigen::Vector2d>& polygon);

/// A simple polygon with its corners in counter-clockwise order.
std::vector<Eigen::Vector2d> counter_clockwise(std::vector<Eigen::Vector2d> polygon);

/// The cut of a closed surface by the plane y = 0.
std::vector<Edge> slice(const Triangles& surface);

}  // namespace thalweg::gencase
