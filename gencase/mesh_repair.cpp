#include "gencase/mesh_repair.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "common/units.hpp"
#include "gencase/booleans.hpp"
#include "gencase/triangle_mesh.hpp"

namespace thalweg::gencase {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Points = std::vector<Kernel::Point_3>;
using Polygons = std::vector<std::vector<std::size_t>>;

/// Joins points nearer than `tolerance` [m], each to the first one found along x. Returns the number of points joined
/// to others.
std::size_t weld(Points& points, Polygons& polygons, double tolerance) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return points[a].x() < points[b].x(); });
  std::vector<std::size_t> joined(points.size());
  std::iota(joined.begin(), joined.end(), std::size_t{0});
  std::size_t count = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i; j-- > 0;) {
      if (points[order[i]].x() - points[order[j]].x() > tolerance) break;
      if (joined[order[j]] != order[j] ||
          CGAL::squared_distance(points[order[i]], points[order[j]]) > tolerance * tolerance)
        continue;
      joined[order[i]] = order[j];
      ++count;
      break;
    }
  }
  for (auto& polygon : polygons)
    for (std::size_t& corner : polygon) corner = joined[corner];
  return count;
}

/// Number of faces that were turned over.
std::size_t count_turned(const std::vector<std::array<Kernel::Point_3, 3>>& before, const Points& points,
                         const Polygons& polygons) {
  std::set<std::array<Kernel::Point_3, 3>> known;
  const auto canonical = [](std::array<Kernel::Point_3, 3> face) {
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    return face;
  };
  for (const auto& face : before) known.insert(canonical(face));
  std::size_t count = 0;
  for (const auto& polygon : polygons)
    count += !known.contains(canonical({points[polygon[0]], points[polygon[1]], points[polygon[2]]}));
  return std::min(count, polygons.size() - count);
}

double diagonal_of(const Mesh& mesh, Mesh::Halfedge_index border) {
  CGAL::Bbox_3 box;
  for (const auto halfedge : CGAL::halfedges_around_face(border, mesh)) box += mesh.point(mesh.target(halfedge)).bbox();
  return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

std::size_t fill_holes(Mesh& mesh, double largest) {
  std::vector<Mesh::Halfedge_index> borders;
  pmp::extract_boundary_cycles(mesh, std::back_inserter(borders));
  std::size_t filled = 0;
  for (const auto border : borders) {
    if (diagonal_of(mesh, border) > largest) continue;
    std::vector<Mesh::Face_index> patch;
    pmp::triangulate_hole(mesh, border, std::back_inserter(patch));
    filled += !patch.empty();
  }
  return filled;
}

/// Unites the overlapping closed bodies of a mesh; nothing if they cannot be united.
std::optional<Triangles> unite_bodies(const Mesh& mesh) {
  std::vector<Mesh> bodies;
  pmp::split_connected_components(mesh, bodies);
  Triangles result;
  try {
    for (Mesh& body : bodies) {
      if (!pmp::is_outward_oriented(body)) pmp::reverse_face_orientations(body);
      result = combine(result, triangles_of(body), Boolean::unite);
    }
  } catch (const NoManifold&) {
    return std::nullopt;
  }
  return result;
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

}  // namespace

Repaired repair(const Triangles& surface, const RepairLimits& limits) {
  Repaired result;
  const auto note = [&](std::size_t count, const char* one, const char* many) {
    if (count > 0) result.changes.push_back(counted(count, one, many));
  };
  Points points;
  Polygons polygons;
  for (const Vec3& p : surface.points) points.emplace_back(p.x(), p.y(), p.z());
  for (const auto& [a, b, c] : surface.corners) polygons.push_back({a, b, c});

  note(weld(points, polygons, limits.weld), "point welded", "points welded");
  const std::size_t faces = polygons.size();
  pmp::repair_polygon_soup(points, polygons);
  note(faces - std::min(faces, polygons.size()), "superfluous face dropped", "superfluous faces dropped");
  std::erase_if(polygons, [](const auto& polygon) { return polygon.size() != 3; });

  std::vector<std::array<Kernel::Point_3, 3>> before;
  for (const auto& polygon : polygons) before.push_back({points[polygon[0]], points[polygon[1]], points[polygon[2]]});
  pmp::orient_polygon_soup(points, polygons);
  note(count_turned(before, points, polygons), "face turned", "faces turned");

  Mesh mesh;
  if (!pmp::is_polygon_soup_a_polygon_mesh(polygons)) {
    result.surface = surface;
    return result;
  }
  pmp::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  note(pmp::stitch_borders(mesh), "pair of edges stitched", "pairs of edges stitched");
  const std::size_t with_degenerate = mesh.number_of_faces();
  pmp::remove_degenerate_faces(mesh);
  note(with_degenerate - std::min<std::size_t>(with_degenerate, mesh.number_of_faces()), "face without area removed",
       "faces without area removed");
  note(fill_holes(mesh, limits.hole), "hole filled", "holes filled");
  if (CGAL::is_closed(mesh)) {
    if (!pmp::does_self_intersect(mesh)) {
      pmp::orient_to_bound_a_volume(mesh);
    } else if (auto united = unite_bodies(mesh)) {
      result.changes.emplace_back("overlapping bodies united");
      result.surface = std::move(*united);
      return result;
    }
  }
  result.surface = triangles_of(mesh);
  return result;
}

Triangles turned(Triangles surface) {
  for (auto& [a, b, c] : surface.corners) std::swap(b, c);
  return surface;
}

}  // namespace thalweg::gencase
