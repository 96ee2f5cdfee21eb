#include "gencase/mesh_borders.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>

#include "gencase/mesh_bodies.hpp"
#include "gencase/mesh_sheets.hpp"

namespace thalweg::gencase {
namespace {

struct OpenEdge {
  std::uint32_t a, b;  // its points, as its face runs
  std::uint32_t face;
};

std::vector<OpenEdge> open_edges(const Triangles& surface) {
  std::vector<OpenEdge> open;
  for (const EdgeFaces& edge : edges_with_faces(surface)) {
    if (edge.uses.size() != 1) continue;
    const auto [face, forth] = edge.uses.front();
    open.push_back({forth ? edge.low : edge.high, forth ? edge.high : edge.low, face});
  }
  return open;
}

/// The points of open edges, sorted by x, for searches within a small distance.
class BorderPoints {
 public:
  BorderPoints(const Triangles& surface, const std::vector<OpenEdge>& open) : surface_(surface) {
    std::set<std::uint32_t> once;
    for (const OpenEdge& edge : open) once.insert({edge.a, edge.b});
    points_.assign(once.begin(), once.end());
    std::stable_sort(points_.begin(), points_.end(), [&](auto i, auto j) { return x(i) < x(j); });
  }
  [[nodiscard]] const std::vector<std::uint32_t>& all() const { return points_; }
  /// Calls `visit` with each point whose x lies between two values [m].
  template <class Visit>
  void between(double low, double high, Visit&& visit) const {
    auto point = std::lower_bound(points_.begin(), points_.end(), low, [&](auto i, double at) { return x(i) < at; });
    for (; point != points_.end() && x(*point) <= high; ++point) visit(*point);
  }

 private:
  [[nodiscard]] double x(std::uint32_t i) const { return surface_.points[i].x(); }
  const Triangles& surface_;
  std::vector<std::uint32_t> points_;
};

void drop_faces_of_two_points(Triangles& surface) {
  std::erase_if(surface.corners, [](const auto& c) { return c[0] == c[1] || c[1] == c[2] || c[2] == c[0]; });
}

/// Makes one point of each two points of open edges that are nearer than `width`, unless an edge joins them.
void join_points(Triangles& surface, double width) {
  const std::vector<OpenEdge> open = open_edges(surface);
  const BorderPoints border(surface, open);
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& corners : surface.corners)
    for (std::size_t k = 0; k < 3; ++k) edges.insert(std::minmax(corners[k], corners[(k + 1) % 3]));
  std::map<std::uint32_t, std::uint32_t> joined;
  for (const std::uint32_t i : border.all()) {
    const Vec3& p = surface.points[i];
    std::uint32_t nearest = i;
    double distance = width;
    border.between(p.x() - width, p.x(), [&](std::uint32_t j) {
      const double apart = (surface.points[j] - p).norm();
      if (j == i || joined.contains(j) || apart > distance || edges.contains(std::minmax(i, j))) return;
      nearest = j;
      distance = apart;
    });
    if (nearest != i) joined[i] = nearest;
  }
  for (auto& corners : surface.corners)
    for (std::uint32_t& corner : corners)
      if (const auto other = joined.find(corner); other != joined.end()) corner = other->second;
  drop_faces_of_two_points(surface);
}

/// The points of other open edges that lie within `width` of an edge's inside, in the order along it.
std::vector<std::uint32_t> points_on(const Triangles& surface, const BorderPoints& border, const OpenEdge& edge,
                                     double width) {
  const Vec3& a = surface.points[edge.a];
  const Vec3& b = surface.points[edge.b];
  const double length = (b - a).norm();
  const Vec3 along = (b - a) / length;
  std::vector<std::pair<double, std::uint32_t>> found;
  border.between(std::min(a.x(), b.x()) - width, std::max(a.x(), b.x()) + width, [&](std::uint32_t i) {
    const Vec3 arm = surface.points[i] - a;
    const double at = arm.dot(along);
    const auto& own = surface.corners[edge.face];
    const bool is_own = std::find(own.begin(), own.end(), i) != own.end();
    if (!is_own && at > width && at < length - width && (arm - at * along).norm() <= width) found.emplace_back(at, i);
  });
  std::sort(found.begin(), found.end());
  std::vector<std::uint32_t> points;
  for (const auto& [at, point] : found) points.push_back(point);
  return points;
}

/// Cuts faces so that their open edges have the points of other open edges beside them. Of each face one edge is cut at
/// a time. Returns false if there was nothing to cut.
bool cut_edges(Triangles& surface, double width) {
  const std::vector<OpenEdge> open = open_edges(surface);
  const BorderPoints border(surface, open);
  std::set<std::uint32_t> cut;
  for (const OpenEdge& edge : open) {
    if (cut.contains(edge.face)) continue;
    std::vector<std::uint32_t> points = points_on(surface, border, edge, width);
    if (points.empty()) continue;
    cut.insert(edge.face);
    const auto corners = surface.corners[edge.face];
    const std::uint32_t tip =
        *std::find_if(corners.begin(), corners.end(), [&](std::uint32_t c) { return c != edge.a && c != edge.b; });
    points.push_back(edge.b);
    surface.corners[edge.face] = {edge.a, points.front(), tip};
    for (std::size_t k = 0; k + 1 < points.size(); ++k) surface.corners.push_back({points[k], points[k + 1], tip});
  }
  return !cut.empty();
}

}  // namespace

std::size_t close_slits(Triangles& surface, double width) {
  const std::size_t before = open_edges(surface).size();
  constexpr int most_cuts = 4;  // a face has three edges; a cut can make one more necessary
  for (const double part : {1e-3, 1e-2, 0.1, 1.0}) {
    if (open_edges(surface).empty()) break;
    join_points(surface, part * width);
    for (int round = 0; round < most_cuts && cut_edges(surface, part * width); ++round) continue;
  }
  return before - std::min(before, open_edges(surface).size());
}

std::size_t drop_loose_faces(Triangles& surface) {
  const std::vector<std::uint32_t> part = parts_of(surface);
  std::map<std::uint32_t, double> area;
  double whole = 0;
  for (std::size_t face = 0; face < part.size(); ++face) {
    const auto& [a, b, c] = surface.corners[face];
    const Vec3 u = surface.points[b] - surface.points[a];
    const double own = 0.5 * u.cross(surface.points[c] - surface.points[a]).norm();
    area[part[face]] += own;
    whole += own;
  }
  std::set<std::uint32_t> loose;
  for (const OpenEdge& edge : open_edges(surface)) loose.insert(part[edge.face]);
  constexpr double small_share = 0.05;
  for (const std::uint32_t each : loose)
    if (area[each] > small_share * whole) return 0;
  const std::size_t before = surface.corners.size();
  std::size_t kept = 0;
  for (std::size_t face = 0; face < before; ++face)
    if (!loose.contains(part[face])) surface.corners[kept++] = surface.corners[face];
  surface.corners.resize(kept);
  return before - kept;
}

}  // namespace thalweg::gencase
