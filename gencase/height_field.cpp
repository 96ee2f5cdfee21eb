#include "gencase/height_field.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <fmt/format.h>

#include <algorithm>

#include "common/units.hpp"

namespace thalweg::gencase {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase>>;

std::string place(const Vec3& p) {
  return fmt::format("x = {}, y = {}", format_quantity(p.x(), "m"), format_quantity(p.y(), "m"));
}

Kernel::Point_2 from_above(const Vec3& p) { return {p.x(), p.y()}; }

}  // namespace

Triangles triangulated(const std::vector<Vec3>& points) {
  std::vector<std::pair<Kernel::Point_2, std::uint32_t>> places;
  places.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    places.emplace_back(from_above(points[i]), static_cast<std::uint32_t>(i));
  const Triangulation plane(places.begin(), places.end());
  if (plane.dimension() < 2)
    throw NoHeightField("has its points on one line in x and y; leave out y for a surface that does not change across");
  Triangles result;
  result.points = points;
  for (auto face = plane.finite_faces_begin(); face != plane.finite_faces_end(); ++face)
    result.corners.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return result;
}

Triangles closed_downward(const Triangles& top, double base) {
  Triangles body;
  std::size_t downward = 0;
  for (const auto& [a, b, c] : top.corners) {
    const auto turn =
        CGAL::orientation(from_above(top.points[a]), from_above(top.points[b]), from_above(top.points[c]));
    if (turn == CGAL::COLLINEAR)
      throw NoHeightField(
          fmt::format("stands upright at {}; give a surface with one height for every place", place(top.points[a])));
    downward += turn == CGAL::RIGHT_TURN;
  }
  if (downward != 0 && downward != top.corners.size())
    throw NoHeightField("overhangs or is folded; give a surface with one height for every place");
  // Points that no triangle uses stay out.
  constexpr std::uint32_t none = ~std::uint32_t{0};
  std::vector<std::uint32_t> number(top.points.size(), none);
  const auto upper = [&](std::uint32_t old) {
    if (number[old] == none) {
      number[old] = static_cast<std::uint32_t>(body.points.size());
      body.points.push_back(top.points[old]);
      body.points.emplace_back(top.points[old].x(), top.points[old].y(), base);
    }
    return number[old];
  };
  body.points.reserve(2 * top.points.size());
  body.corners.reserve(2 * top.corners.size());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(3 * top.corners.size());
  for (const auto& corners : top.corners) {
    const std::uint32_t a = upper(corners[0]);
    const std::uint32_t b = upper(downward == 0 ? corners[1] : corners[2]);
    const std::uint32_t c = upper(downward == 0 ? corners[2] : corners[1]);
    body.corners.push_back({a, b, c});
    body.corners.push_back({a + 1, c + 1, b + 1});
    edges.insert(edges.end(), {{a, b}, {b, c}, {c, a}});
  }
  std::sort(edges.begin(), edges.end());
  for (const auto& [a, b] : edges) {
    if (std::binary_search(edges.begin(), edges.end(), std::pair(b, a))) continue;
    body.corners.push_back({b, a, a + 1});
    body.corners.push_back({b, a + 1, b + 1});
  }
  return body;
}

}  // namespace thalweg::gencase
