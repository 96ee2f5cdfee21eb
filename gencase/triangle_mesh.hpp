#pragma once

#include <CGAL/Surface_mesh.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// The triangles of a CGAL mesh of any kernel, with coordinates rounded to double. First removes the elements that are
/// marked as deleted from the mesh.
template <class Point>
Triangles triangles_of(CGAL::Surface_mesh<Point>& mesh) {
  mesh.collect_garbage();
  Triangles surface;
  for (const auto vertex : mesh.vertices()) {
    const Point& p = mesh.point(vertex);
    surface.points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }
  for (const auto face : mesh.faces()) {
    std::array<std::uint32_t, 3> corners{};
    std::size_t k = 0;
    for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face))) corners.at(k++) = vertex.idx();
    surface.corners.push_back(corners);
  }
  return surface;
}

/// The surface without the points that no face has. With them CGAL takes a mesh for invalid.
inline Triangles without_loose_points(Triangles surface) {
  constexpr auto loose = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> number(surface.points.size(), loose);
  for (const auto& corners : surface.corners)
    for (const std::uint32_t corner : corners) number[corner] = 0;
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] == loose) continue;
    surface.points[kept] = surface.points[i];
    number[i] = kept++;
  }
  surface.points.resize(kept);
  for (auto& corners : surface.corners)
    for (std::uint32_t& corner : corners) corner = number[corner];
  return surface;
}

}  // namespace thalweg::gencase
