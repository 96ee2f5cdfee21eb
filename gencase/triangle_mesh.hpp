#pragma once

#include <CGAL/Surface_mesh.h>
#include <CGAL/number_utils.h>

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

}  // namespace thalweg::gencase
