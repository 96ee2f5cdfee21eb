#include "gencase/polygon.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>

#include <algorithm>
#include <cmath>

#include "gencase/surfaces.hpp"

namespace thalweg::gencase {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalPolygon = CGAL::Polygon_2<Kernel>;

CgalPolygon to_cgal(const std::vector<Eigen::Vector2d>& polygon) {
  CgalPolygon result;
  for (const auto& p : polygon) result.push_back(Kernel::Point_2(p.x(), p.y()));
  return result;
}

Vec3 in_space(const Eigen::Vector2d& p) { return {p.x(), 0, p.y()}; }

class Polygon : public Region {
 public:
  explicit Polygon(std::vector<Edge> edges) : edges_(std::move(edges)) {
    bounds_ = {in_space(edges_.front().from), in_space(edges_.front().from)};
    for (const Edge& edge : edges_) {
      bounds_.lower = bounds_.lower.cwiseMin(in_space(edge.from));
      bounds_.upper = bounds_.upper.cwiseMax(in_space(edge.from));
      const Eigen::Vector2d along = (edge.to - edge.from).normalized();
      lines_.emplace_back(in_space(edge.from), Vec3(along.y(), 0, -along.x()));
    }
  }
  [[nodiscard]] bool contains(const Vec3& p) const override {
    Line line;
    line.origin = p;
    return covers(cut(line), p.z());
  }
  [[nodiscard]] Bounds bounds() const override { return bounds_; }
  [[nodiscard]] std::optional<double> measure() const override {
    double twice = 0;
    const Eigen::Vector2d base = edges_.front().from;
    for (const Edge& edge : edges_) {
      const Eigen::Vector2d a = edge.from - base;
      const Eigen::Vector2d b = edge.to - base;
      twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * twice;
  }
  /// Corners on the line count as above it, so that a line through a corner meets only the edges on one side.
  [[nodiscard]] Spans cut(const Line& line) const override {
    const int across = line.axis == 2 ? 0 : 1;  // entry of an edge's places
    const int along = 1 - across;
    const double place = line.origin[line.axis == 2 ? 0 : 2];
    std::vector<std::pair<double, int>> crossings;
    for (const Edge& edge : edges_) {
      const bool from_above = edge.from[across] >= place;
      const bool to_above = edge.to[across] >= place;
      if (from_above == to_above) continue;
      const double share = (place - edge.from[across]) / (edge.to[across] - edge.from[across]);
      const bool rising = !from_above;
      // On a line along z the region begins at an edge that runs to +x; on a line along x it ends at one that runs to
      // +z.
      crossings.emplace_back(edge.from[along] + share * (edge.to[along] - edge.from[along]),
                             (across == 0) == rising ? 1 : -1);
    }
    std::sort(crossings.begin(), crossings.end());
    Spans spans;
    int winding = 0;
    for (const auto& [at, turn] : crossings) {
      const int before = winding;
      winding += turn;
      if (before <= 0 && winding > 0) spans.push_back({at, at});
      if (before > 0 && winding <= 0) spans.back().high = at;
    }
    return unite(spans, {});
  }
  [[nodiscard]] std::optional<Triangles> triangles(double) const override { return std::nullopt; }
  void append_surfaces(std::vector<const Surface*>& surfaces) const override {
    for (const Plane& line : lines_) surfaces.push_back(&line);
  }

 private:
  std::vector<Edge> edges_;
  std::vector<Plane> lines_;
  Bounds bounds_;
};

}  // namespace

RegionPointer make_polygon(std::vector<Edge> edges) { return std::make_shared<Polygon>(std::move(edges)); }

std::vector<Edge> edges_of(const std::vector<Eigen::Vector2d>& polygon) {
  const std::vector<Eigen::Vector2d> corners = counter_clockwise(polygon);
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < corners.size(); ++i) edges.push_back({corners[i], corners[(i + 1) % corners.size()]});
  return edges;
}

bool is_simple(const std::vector<Eigen::Vector2d>& polygon) { return to_cgal(polygon).is_simple(); }

std::vector<Eigen::Vector2d> counter_clockwise(std::vector<Eigen::Vector2d> polygon) {
  if (to_cgal(polygon).is_clockwise_oriented()) std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

namespace {

/// The cut by the plane y = 0. Corners on the plane count as lying on one side of it, so that neighbouring triangles
/// agree.
std::vector<Edge> slice(const Triangles& surface, bool on_plane_is_positive) {
  const auto positive = [&](double y) { return on_plane_is_positive ? y >= 0 : y > 0; };
  std::vector<Edge> edges;
  for (const auto& corners : surface.corners) {
    Eigen::Vector2d enters;
    Eigen::Vector2d leaves;
    int crossings = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3 a = surface.points[corners[k]];
      Vec3 b = surface.points[corners[(k + 1) % 3]];
      if (positive(a.y()) == positive(b.y())) continue;
      const bool up = positive(b.y());
      if (!up) std::swap(a, b);  // both triangles beside the edge compute the same point
      const Vec3 p = a + a.y() / (a.y() - b.y()) * (b - a);
      (up ? enters : leaves) = Eigen::Vector2d(p.x(), p.z());
      ++crossings;
    }
    if (crossings == 2 && enters != leaves) edges.push_back({enters, leaves});
  }
  return edges;
}

}  // namespace

std::vector<Edge> slice(const Triangles& surface) {
  std::vector<Edge> below = slice(surface, true);
  // A body that begins at the plane, as a profile extruded from y = 0 does, is cut just beyond it.
  return below.empty() ? slice(surface, false) : below;
}

}  // namespace thalweg::gencase
