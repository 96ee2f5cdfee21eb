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
#include <functional>
#include <numeric>
#include <tuple>

#include "gencase/booleans.hpp"
#include "gencase/mesh_bodies.hpp"
#include "gencase/mesh_borders.hpp"
#include "gencase/mesh_defects.hpp"
#include "gencase/mesh_sheets.hpp"
#include "gencase/polyhedron.hpp"
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

double diagonal_of(const Mesh& mesh, Mesh::Halfedge_index border) {
  CGAL::Bbox_3 box;
  for (const auto halfedge : CGAL::halfedges_around_face(border, mesh)) box += mesh.point(mesh.target(halfedge)).bbox();
  return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

/// True if every face of the part beside a border lies on the border: a loose sheet, which filling would make a body
/// without volume.
bool is_loose_sheet(const Mesh& mesh, Mesh::Halfedge_index border) {
  std::vector<Mesh::Face_index> part;
  pmp::connected_component(mesh.face(mesh.opposite(border)), mesh, std::back_inserter(part));
  return part.size() <= CGAL::halfedges_around_face(border, mesh).size();
}

std::size_t fill_holes(Mesh& mesh, double largest) {
  std::vector<Mesh::Halfedge_index> borders;
  pmp::extract_boundary_cycles(mesh, std::back_inserter(borders));
  std::size_t filled = 0;
  for (const auto border : borders) {
    if (diagonal_of(mesh, border) > largest || is_loose_sheet(mesh, border)) continue;
    std::vector<Mesh::Face_index> patch;
    pmp::triangulate_hole(mesh, border, std::back_inserter(patch));
    filled += !patch.empty();
  }
  return filled;
}

/// Unites the overlapping closed bodies of a surface, then takes its cavities out of them; nothing if they cannot be
/// united.
std::optional<Triangles> unite_bodies(const Triangles& judged) {
  std::vector<Triangles> bodies = bodies_of(judged);
  std::stable_partition(bodies.begin(), bodies.end(), [](const Triangles& body) { return volume(body) >= 0; });
  Triangles result;
  try {
    for (Triangles& body : bodies)
      result = volume(body) >= 0 ? combine(result, body, Boolean::unite)
                                 : combine(result, turned(std::move(body)), Boolean::subtract);
  } catch (const NoManifold&) {
    return std::nullopt;
  }
  return result;
}

/// Notes a kind of change and how often it was made.
using Note = std::function<void(std::size_t count, const char* one, const char* many)>;

std::pair<Points, Polygons> soup_of(const Triangles& surface) {
  std::pair<Points, Polygons> soup;
  for (const Vec3& p : surface.points) soup.first.emplace_back(p.x(), p.y(), p.z());
  for (const auto& [a, b, c] : surface.corners) soup.second.push_back({a, b, c});
  return soup;
}

Triangles surface_of(const Points& points, const Polygons& polygons) {
  Triangles surface;
  for (const auto& p : points) surface.points.emplace_back(p.x(), p.y(), p.z());
  for (const auto& p : polygons)
    surface.corners.push_back(
        {static_cast<std::uint32_t>(p[0]), static_cast<std::uint32_t>(p[1]), static_cast<std::uint32_t>(p[2])});
  return surface;
}

/// Makes a mesh of a surface, stitches it, fills its holes and drops what remains loose; nothing if sheets of the
/// surface cannot be told apart.
std::optional<Triangles> closed_mesh(const Triangles& surface, double hole, const Note& note) {
  auto [points, polygons] = soup_of(without_loose_points(surface));
  pmp::orient_polygon_soup(points, polygons);  // parts the sheets that part_sheets() could not
  if (!pmp::is_polygon_soup_a_polygon_mesh(polygons)) return std::nullopt;
  Mesh mesh;
  pmp::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  note(pmp::stitch_borders(mesh), "pair of edges stitched", "pairs of edges stitched");
  const std::size_t with_degenerate = mesh.number_of_faces();
  pmp::remove_degenerate_faces(mesh);
  note(with_degenerate - std::min<std::size_t>(with_degenerate, mesh.number_of_faces()), "face without area removed",
       "faces without area removed");
  note(fill_holes(mesh, hole), "hole filled", "holes filled");
  Triangles result = triangles_of(mesh);
  note(drop_loose_faces(result), "loose face dropped", "loose faces dropped");
  return result;
}

bool is_closed(const Triangles& surface) {
  const std::vector<EdgeFaces> edges = edges_with_faces(surface);
  return std::all_of(edges.begin(), edges.end(), [](const EdgeFaces& edge) { return edge.uses.size() == 2; });
}

bool crosses_itself(const Triangles& surface) {
  auto [points, polygons] = soup_of(surface);
  if (!pmp::is_polygon_soup_a_polygon_mesh(polygons)) return true;
  Mesh mesh;
  pmp::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  return pmp::does_self_intersect(mesh);
}

}  // namespace

Repaired repair(const Triangles& surface, const RepairLimits& limits) {
  Repaired result;
  const Note note = [&](std::size_t count, const char* one, const char* many) {
    if (count > 0) result.changes.push_back(counted(count, one, many));
  };
  auto [points, polygons] = soup_of(surface);
  note(weld(points, polygons, limits.weld), "point welded", "points welded");
  Triangles mended = surface_of(points, polygons);
  note(cancel_back_to_back(mended), "face between two bodies dropped", "faces between two bodies dropped");
  std::tie(points, polygons) = soup_of(mended);
  const std::size_t faces = polygons.size();
  pmp::repair_polygon_soup(points, polygons);
  note(faces - std::min(faces, polygons.size()), "superfluous face dropped", "superfluous faces dropped");
  std::erase_if(polygons, [](const auto& polygon) { return polygon.size() != 3; });
  mended = surface_of(points, polygons);
  note(close_slits(mended, limits.slit), "edge of slits closed", "edges of slits closed");
  part_sheets(mended);
  note(turn_alike(mended), "face turned", "faces turned");
  const std::optional<Triangles> closed = closed_mesh(mended, limits.hole, note);
  result.surface = closed.value_or(mended);
  if (!closed || !is_closed(result.surface)) return result;
  Judged judged = judge_bodies(result.surface);
  result.surface = std::move(judged.surface);
  result.judgement = std::move(judged.changes);
  if (!crosses_itself(result.surface)) return result;
  if (auto united = unite_bodies(result.surface)) {
    result.changes.emplace_back("overlapping bodies united");
    result.surface = std::move(*united);
  }
  return result;
}

Triangles turned(Triangles surface) {
  for (auto& [a, b, c] : surface.corners) std::swap(b, c);
  return surface;
}

}  // namespace thalweg::gencase
