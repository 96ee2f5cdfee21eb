#include "gencase/mesh_defects.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Cartesian_converter.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <boost/variant/get.hpp>
#include <cmath>
#include <map>
#include <variant>

#include "common/units.hpp"

namespace thalweg::gencase {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// The case T of a variant, or nullptr: CGAL's are of the standard library from version 6 on, before of Boost.
template <class T, class... Cases>
const T* case_of(const std::variant<Cases...>& variant) {
  return std::get_if<T>(&variant);
}
template <class T, class Variant>
const T* case_of(const Variant& variant) {
  return boost::get<T>(&variant);
}

enum Kind { open_edge = 1, crowded_edge = 2, opposed_edge = 3, degenerate_face = 4, intersecting_face = 5 };

Kernel::Point_3 to_cgal(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// Number of faces that use an edge from its lower to its higher corner, and in the other direction.
struct EdgeUse {
  int forth = 0;
  int back = 0;
};
using Edges = std::map<std::pair<std::uint32_t, std::uint32_t>, EdgeUse>;

Edges edges_of(const Triangles& surface) {
  Edges edges;
  for (const auto& corners : surface.corners)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = corners[k];
      const std::uint32_t b = corners[(k + 1) % 3];
      if (a < b)
        ++edges[{a, b}].forth;
      else
        ++edges[{b, a}].back;
    }
  return edges;
}

/// Chains open edges into loops and adds each loop as a hole.
void collect_holes(const Triangles& surface, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& open,
                   MeshDefects& defects) {
  std::multimap<std::uint32_t, std::uint32_t> next;
  for (const auto& [a, b] : open) {
    next.emplace(a, b);
    next.emplace(b, a);
  }
  while (!next.empty()) {
    std::vector<Vec3> loop;
    double length = 0;
    const std::uint32_t start = next.begin()->first;
    std::uint32_t at = start;
    loop.push_back(surface.points[at]);
    for (auto step = next.find(at); step != next.end(); step = next.find(at)) {
      const std::uint32_t to = step->second;
      next.erase(step);
      const auto [begin, end] = next.equal_range(to);
      for (auto back = begin; back != end; ++back)
        if (back->second == at) {
          next.erase(back);
          break;
        }
      length += (surface.points[to] - surface.points[at]).norm();
      at = to;
      loop.push_back(surface.points[at]);
      if (at == start) break;
    }
    ++defects.holes;
    defects.hole_length += length;
    defects.longest_hole = std::max(defects.longest_hole, length);
    defects.places.lines.push_back(std::move(loop));
    defects.places.numbers.push_back(open_edge);
  }
}

void add_face(const Triangles& surface, std::size_t face, Kind kind, MeshDefects& defects) {
  const auto& [a, b, c] = surface.corners[face];
  defects.places.lines.push_back({surface.points[a], surface.points[b], surface.points[c], surface.points[a]});
  defects.places.numbers.push_back(kind);
}

/// True if two faces that meet do not merely touch: each has corners on both sides of the other, or they share an area
/// of one plane.
bool overlap(const Triangles& surface, std::size_t f, std::size_t g) {
  const auto triangle = [&](std::size_t face) {
    const auto& [a, b, c] = surface.corners[face];
    return Kernel::Triangle_3(to_cgal(surface.points[a]), to_cgal(surface.points[b]), to_cgal(surface.points[c]));
  };
  const auto a = triangle(f);
  const auto b = triangle(g);
  const auto both_sides = [](const Kernel::Triangle_3& corners, const Kernel::Triangle_3& plane) {
    std::array<int, 3> counts{};  // below, on, above
    for (int k = 0; k < 3; ++k) ++counts.at(1 + CGAL::orientation(plane[0], plane[1], plane[2], corners[k]));
    return std::pair(counts[0] > 0 && counts[2] > 0, counts[1] == 3);
  };
  const auto [a_through_b, one_plane] = both_sides(a, b);
  if (!one_plane) return a_through_b && both_sides(b, a).first;
  if (a.is_degenerate() || b.is_degenerate()) return true;
  // With rounded points the intersection can end in none of its cases, and CGAL then reads past the end of a list.
  const CGAL::Cartesian_converter<Kernel, Exact> exact;
  const auto shared = CGAL::intersection(exact(a), exact(b));
  return shared && case_of<Exact::Point_3>(*shared) == nullptr && case_of<Exact::Segment_3>(*shared) == nullptr;
}

void find_intersections(const Triangles& surface, MeshDefects& defects) {
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for (const Vec3& p : surface.points) vertices.push_back(mesh.add_vertex(to_cgal(p)));
  for (std::size_t face = 0; face < surface.corners.size(); ++face) {
    const auto& [a, b, c] = surface.corners[face];
    if (mesh.add_face(vertices[a], vertices[b], vertices[c]) == Mesh::null_face()) {
      ++defects.crowded_edges;  // two parts of the surface share a corner only
      add_face(surface, face, crowded_edge, defects);
    }
  }
  if (defects.crowded_edges > 0) return;
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  pmp::self_intersections(mesh, std::back_inserter(pairs));
  std::erase_if(pairs, [&](const auto& pair) { return !overlap(surface, pair.first.idx(), pair.second.idx()); });
  if (pairs.empty()) return;
  const auto body = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:body", 0).first;
  pmp::connected_components(mesh, body);
  defects.intersections = pairs.size();
  for (const auto& [a, b] : pairs) {
    defects.between_bodies += body[a] != body[b];
    add_face(surface, a.idx(), intersecting_face, defects);
    add_face(surface, b.idx(), intersecting_face, defects);
  }
}

}  // namespace

std::string counted(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string MeshDefects::text() const {
  std::vector<std::string> parts;
  const auto length = [](double metres) { return format_quantity(metres, "m"); };
  if (holes == 1) parts.push_back(fmt::format("a hole with {} of open edges", length(hole_length)));
  if (holes > 1)
    parts.push_back(fmt::format("{} holes with {} of open edges (the longest {})", holes, length(hole_length),
                                length(longest_hole)));
  if (crowded_edges > 0)
    parts.push_back(counted(crowded_edges, "edge or corner where more than two sheets of the surface meet",
                            "edges or corners where more than two sheets of the surface meet"));
  if (opposed_edges > 0)
    parts.push_back(counted(opposed_edges, "edge between faces that are turned against each other",
                            "edges between faces that are turned against each other"));
  if (degenerate > 0) parts.push_back(counted(degenerate, "face without area", "faces without area"));
  if (intersections > 0)
    parts.push_back(
        counted(intersections, "pair of faces that intersect each other", "pairs of faces that intersect each other"));
  return fmt::format("{}", fmt::join(parts, ", "));
}

MeshDefects find_defects(const Triangles& surface, SurfaceUse use) {
  MeshDefects defects;
  defects.places.number_name = "Defect";
  for (std::size_t face = 0; face < surface.corners.size(); ++face) {
    const auto& [a, b, c] = surface.corners[face];
    if (!CGAL::collinear(to_cgal(surface.points[a]), to_cgal(surface.points[b]), to_cgal(surface.points[c]))) continue;
    ++defects.degenerate;
    add_face(surface, face, degenerate_face, defects);
  }
  if (use == SurfaceUse::plate) return defects;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> open;
  for (const auto& [edge, faces_of] : edges_of(surface)) {
    if (edge.first == edge.second) continue;  // of a face without area
    const int faces = faces_of.forth + faces_of.back;
    if (faces == 1 && use == SurfaceUse::body) open.push_back(edge);
    const bool crowded = faces > 2;
    const bool opposed = faces == 2 && faces_of.forth != faces_of.back;
    if (!crowded && !opposed) continue;
    ++(crowded ? defects.crowded_edges : defects.opposed_edges);
    defects.places.lines.push_back({surface.points[edge.first], surface.points[edge.second]});
    defects.places.numbers.push_back(crowded ? crowded_edge : opposed_edge);
  }
  collect_holes(surface, open, defects);
  if (!defects.any()) find_intersections(surface, defects);
  return defects;
}

Thickness thickness_of(const Triangles& surface, double limit) {
  using Facets = std::vector<Kernel::Triangle_3>;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Facets::const_iterator>;
  Facets facets;
  for (const auto& [a, b, c] : surface.corners)
    facets.emplace_back(to_cgal(surface.points[a]), to_cgal(surface.points[b]), to_cgal(surface.points[c]));
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree(facets.begin(), facets.end());
  const auto normal_of = [](const Kernel::Triangle_3& facet) {
    const auto n = CGAL::cross_product(facet[1] - facet[0], facet[2] - facet[0]);
    return Vec3(n.x(), n.y(), n.z()).normalized();
  };
  constexpr std::size_t faces_looked_at = 5000;
  const std::size_t stride = std::max<std::size_t>(1, facets.size() / faces_looked_at);
  Thickness result{HUGE_VAL, 0, Vec3::Zero()};
  double area = 0;
  double thin_area = 0;
  for (std::size_t face = 0; face < facets.size(); face += stride) {
    const Kernel::Triangle_3& facet = facets[face];
    const Vec3 normal = normal_of(facet);
    const Kernel::Point_3 middle = CGAL::centroid(facet);
    const double own_area = std::sqrt(facet.squared_area());
    area += own_area;
    const Kernel::Ray_3 inward(middle, Kernel::Vector_3(-normal.x(), -normal.y(), -normal.z()));
    const auto hit =
        tree.first_intersection(inward, [&](const Facets::const_iterator& other) { return &*other == &facet; });
    if (!hit) continue;
    const auto* point = case_of<Kernel::Point_3>(hit->first);
    // A face that does not look the other way is the neighbour beyond an edge, not the opposite side.
    if (point == nullptr || normal_of(*hit->second).dot(normal) > -0.7) continue;
    const double thickness = std::sqrt(CGAL::squared_distance(*point, middle));
    if (thickness < limit) thin_area += own_area;
    if (thickness >= result.least) continue;
    result.least = thickness;
    result.where = {middle.x(), middle.y(), middle.z()};
  }
  result.thin_share = area > 0 ? thin_area / area : 0;
  return result;
}

}  // namespace thalweg::gencase
