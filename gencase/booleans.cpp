#include "gencase/booleans.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>

#include "gencase/joined_sets.hpp"
#include "gencase/triangle_mesh.hpp"

namespace thalweg::gencase {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh to_mesh(const Triangles& surface) {
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for (const Vec3& p : surface.points) vertices.push_back(mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z())));
  for (const auto& [a, b, c] : surface.corners)
    if (mesh.add_face(vertices[a], vertices[b], vertices[c]) == Mesh::null_face())
      throw NoManifold("the surface touches itself in an edge");
  return mesh;
}

/// Makes one point of the ends of edges that rounding to double made equal, and drops the faces without area beside
/// them.
Triangles without_short_edges(Triangles surface) {
  JoinedSets points(surface.points.size());
  for (const auto& [a, b, c] : surface.corners)
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      if (surface.points[from] == surface.points[to]) points.join(from, to);
  for (auto& corners : surface.corners)
    for (std::uint32_t& corner : corners) corner = static_cast<std::uint32_t>(points.root(corner));
  std::erase_if(surface.corners, [](const auto& c) { return c[0] == c[1] || c[1] == c[2] || c[2] == c[0]; });
  return without_loose_points(std::move(surface));
}

}  // namespace

Triangles combine(const Triangles& a, const Triangles& b, Boolean how) {
  if (a.corners.empty()) return how == Boolean::unite ? b : a;
  if (b.corners.empty()) return how == Boolean::intersect ? b : a;
  Mesh first = to_mesh(a);
  Mesh second = to_mesh(b);
  Mesh result;
  bool valid = false;
  const auto checked = CGAL::parameters::throw_on_self_intersection(true);
  try {
    switch (how) {
      case Boolean::unite:
        valid = pmp::corefine_and_compute_union(first, second, result, checked);
        break;
      case Boolean::subtract:
        valid = pmp::corefine_and_compute_difference(first, second, result, checked);
        break;
      case Boolean::intersect:
        valid = pmp::corefine_and_compute_intersection(first, second, result, checked);
        break;
    }
  } catch (const pmp::Corefinement::Self_intersection_exception&) {
    throw NoManifold("one of the surfaces intersects itself where they meet");
  }
  if (!valid) throw NoManifold("the surfaces touch in an edge or a corner, where the result would have no inside");
  return without_short_edges(triangles_of(result));
}

}  // namespace thalweg::gencase
