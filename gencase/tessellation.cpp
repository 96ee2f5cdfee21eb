#include "gencase/tessellation.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "gencase/surfaces.hpp"

namespace thalweg::gencase {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

/// Number of sides n of a regular polygon in a circle that deviates from it by at most `deviation`:
/// R (1 - cos(pi / n)) <= deviation.
int sides(double radius, double deviation) {
  if (radius <= 0) return 8;
  const double cosine = std::max(1 - deviation / radius, -1.0);
  return static_cast<int>(std::clamp(std::ceil(std::numbers::pi / std::acos(cosine)), 8.0, 2000.0));
}

/// True if a point lies inside a polygon: a ray to +x crosses an odd number of edges.
bool inside(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& p) {
  bool in = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const auto& a = polygon[i];
    const auto& b = polygon[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      in = !in;
  }
  return in;
}

}  // namespace

Triangles tessellate_box(const Vec3& lower, const Vec3& upper) {
  Triangles box;
  for (unsigned corner = 0; corner < 8; ++corner)
    box.points.emplace_back(corner & 1U ? upper.x() : lower.x(), corner & 2U ? upper.y() : lower.y(),
                            corner & 4U ? upper.z() : lower.z());
  box.corners = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return box;
}

Triangles revolve(const Vec3& from, const Vec3& axis, const std::vector<Eigen::Vector2d>& profile, double deviation) {
  double widest = 0;
  for (const auto& place : profile) widest = std::max(widest, place.y());
  const int around = sides(widest, deviation);
  const Vec3 u = across(axis);
  const Vec3 v = axis.cross(u);
  Triangles result;
  std::vector<std::vector<std::uint32_t>> rings;
  const auto add_ring = [&](double along, double away) {
    std::vector<std::uint32_t>& ring = rings.emplace_back();
    for (int k = 0; k < (away > 0 ? around : 1); ++k) {
      const double angle = 2 * std::numbers::pi * k / around;
      ring.push_back(static_cast<std::uint32_t>(result.points.size()));
      result.points.emplace_back(from + along * axis + away * (std::cos(angle) * u + std::sin(angle) * v));
    }
  };
  if (profile.front().y() > 0) add_ring(profile.front().x(), 0);
  for (const auto& place : profile) add_ring(place.x(), place.y());
  if (profile.back().y() > 0) add_ring(profile.back().x(), 0);
  for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
    for (int k = 0; k < around; ++k) {
      const auto at = [&](const std::vector<std::uint32_t>& ring, int i) {
        return ring.size() == 1 ? ring.front() : ring[static_cast<std::size_t>(i % around)];
      };
      const std::uint32_t a = at(rings[r], k);
      const std::uint32_t b = at(rings[r], k + 1);
      const std::uint32_t c = at(rings[r + 1], k + 1);
      const std::uint32_t d = at(rings[r + 1], k);
      if (a != b) result.corners.push_back({a, b, c});
      if (c != d) result.corners.push_back({a, c, d});
    }
  }
  return result;
}

Triangles tessellate_sphere(const Vec3& center, double radius, double deviation) {
  deviation *= 0.5;  // half of it along the meridians, half around the axis
  const int rings = std::max(4, (sides(radius, deviation) + 1) / 2);
  std::vector<Eigen::Vector2d> profile;
  for (int r = 0; r <= rings; ++r) {
    const double angle = std::numbers::pi * r / rings;
    const bool pole = r == 0 || r == rings;
    profile.emplace_back(-radius * std::cos(angle), pole ? 0 : radius * std::sin(angle));
  }
  return revolve(center, Vec3::UnitZ(), profile, deviation);
}

Triangles extrude(const std::vector<Eigen::Vector2d>& polygon, int axis, double low, double high) {
  Triangulation plane;
  std::vector<Triangulation::Vertex_handle> vertices;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto vertex = plane.insert(Kernel::Point_2(polygon[i].x(), polygon[i].y()));
    vertex->info() = static_cast<std::uint32_t>(i);
    vertices.push_back(vertex);
  }
  for (std::size_t i = 0; i < vertices.size(); ++i)
    plane.insert_constraint(vertices[i], vertices[(i + 1) % vertices.size()]);

  const int first = axis == 0 ? 1 : 0;
  const int second = axis == 2 ? 1 : 2;
  const bool mirrored = axis == 1;  // (x, z, y) is a left-handed order
  const auto count = static_cast<std::uint32_t>(polygon.size());
  Triangles result;
  for (const double along : {low, high})
    for (const auto& corner : polygon) {
      Vec3 p;
      p[first] = corner.x();
      p[second] = corner.y();
      p[axis] = along;
      result.points.push_back(p);
    }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (mirrored) std::swap(b, c);
    result.corners.push_back({a, b, c});
  };
  for (auto face = plane.finite_faces_begin(); face != plane.finite_faces_end(); ++face) {
    const std::array index{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
    if (!inside(polygon, (polygon[index[0]] + polygon[index[1]] + polygon[index[2]]) / 3)) continue;
    add(index[0], index[2], index[1]);
    add(index[0] + count, index[1] + count, index[2] + count);
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t j = (i + 1) % count;
    add(i, j, j + count);
    add(i, j + count, i + count);
  }
  return result;
}

}  // namespace thalweg::gencase
