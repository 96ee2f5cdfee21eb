#include "gencase/mesh_sheets.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "gencase/joined_sets.hpp"

namespace thalweg::gencase {
namespace {

using Use = EdgeFaces::Use;

/// The corner of a face that lies on neither end of an edge.
std::uint32_t third(const std::array<std::uint32_t, 3>& corners, std::uint32_t a, std::uint32_t b) {
  for (const std::uint32_t corner : corners)
    if (corner != a && corner != b) return corner;
  return a;
}

std::size_t place_of(const std::array<std::uint32_t, 3>& corners, std::uint32_t point) {
  return static_cast<std::size_t>(std::find(corners.begin(), corners.end(), point) - corners.begin());
}

bool is_balanced(const EdgeFaces& edge) {
  const auto forth = std::count_if(edge.uses.begin(), edge.uses.end(), [](const Use& use) { return use.forth; });
  return 2 * static_cast<std::size_t>(forth) == edge.uses.size();
}

/// Pairs of faces with the body between them, around an edge of more than two. Seen along the edge, the body lies
/// clockwise of a face that runs forth and counter-clockwise of one that runs back, so that a face that runs back opens
/// a wedge of body and one that runs forth closes it, as brackets do.
std::vector<std::pair<std::uint32_t, std::uint32_t>> wedges(const Triangles& surface, const EdgeFaces& edge) {
  const Vec3 from = surface.points[edge.low];
  const Vec3 axis = (surface.points[edge.high] - from).normalized();
  const Vec3 u = axis.unitOrthogonal();
  const Vec3 v = axis.cross(u);
  std::vector<std::pair<double, Use>> around;
  for (const Use& use : edge.uses) {
    const Vec3 arm = surface.points[third(surface.corners[use.face], edge.low, edge.high)] - from;
    around.emplace_back(std::atan2(arm.dot(v), arm.dot(u)), use);
  }
  std::stable_sort(around.begin(), around.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  std::vector<std::uint32_t> open;
  // Twice around closes wedges that lie across the first angle.
  std::vector<bool> closed(around.size(), false);
  for (std::size_t step = 0; step < 2 * around.size(); ++step) {
    const std::size_t k = step % around.size();
    const Use& use = around[k].second;
    if (!use.forth && step < around.size()) open.push_back(use.face);
    if (!use.forth || closed[k] || open.empty()) continue;
    pairs.emplace_back(open.back(), use.face);
    open.pop_back();
    closed[k] = true;
  }
  return pairs;
}

}  // namespace

std::vector<EdgeFaces> edges_with_faces(const Triangles& surface) {
  std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, bool>> uses;
  uses.reserve(3 * surface.corners.size());
  for (std::uint32_t face = 0; face < surface.corners.size(); ++face)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = surface.corners[face][k];
      const std::uint32_t b = surface.corners[face][(k + 1) % 3];
      if (a != b) uses.emplace_back(std::min(a, b), std::max(a, b), face, a < b);
    }
  std::sort(uses.begin(), uses.end());
  std::vector<EdgeFaces> edges;
  for (const auto& [low, high, face, forth] : uses) {
    if (edges.empty() || edges.back().low != low || edges.back().high != high) edges.push_back({low, high, {}});
    edges.back().uses.push_back({face, forth});
  }
  return edges;
}

std::size_t cancel_back_to_back(Triangles& surface) {
  std::vector<bool> lasting(surface.corners.size(), true);
  std::vector<bool> unbalanced(surface.corners.size(), false);
  for (const EdgeFaces& edge : edges_with_faces(surface))
    if (!is_balanced(edge))
      for (const Use& use : edge.uses) unbalanced[use.face] = true;
  std::vector<std::tuple<std::array<std::uint32_t, 3>, bool, std::size_t>> faces;  // corners, is an even order, number
  for (std::size_t face = 0; face < surface.corners.size(); ++face) {
    const auto& given = surface.corners[face];
    std::array<std::uint32_t, 3> sorted = given;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t first = place_of(given, sorted[0]);
    if (!unbalanced[face]) faces.emplace_back(sorted, given[(first + 1) % 3] == sorted[1], face);
  }
  std::sort(faces.begin(), faces.end());
  for (std::size_t begin = 0, end = 0; begin < faces.size(); begin = end) {
    while (end < faces.size() && std::get<0>(faces[end]) == std::get<0>(faces[begin])) ++end;
    std::size_t even = begin;
    while (even < end && !std::get<1>(faces[even])) ++even;  // the odd ones come first
    for (std::size_t k = 0; begin + k < even && even + k < end; ++k)
      lasting[std::get<2>(faces[begin + k])] = lasting[std::get<2>(faces[even + k])] = false;
  }
  std::size_t kept = 0;
  for (std::size_t face = 0; face < lasting.size(); ++face)
    if (lasting[face]) surface.corners[kept++] = surface.corners[face];
  surface.corners.resize(kept);
  return lasting.size() - kept;
}

void part_sheets(Triangles& surface) {
  // Every face has three corners of its own; those that belong to one sheet around a point are joined.
  JoinedSets corners(3 * surface.corners.size());
  const auto join = [&](std::uint32_t f, std::uint32_t g, const EdgeFaces& edge) {
    for (const std::uint32_t end : {edge.low, edge.high})
      corners.join(3 * std::size_t{f} + place_of(surface.corners[f], end),
                   3 * std::size_t{g} + place_of(surface.corners[g], end));
  };
  for (const EdgeFaces& edge : edges_with_faces(surface)) {
    if (edge.uses.size() > 2 && is_balanced(edge)) {
      for (const auto& [f, g] : wedges(surface, edge)) join(f, g, edge);
    } else {
      for (const Use& use : edge.uses) join(edge.uses.front().face, use.face, edge);
    }
  }
  // The first sheet at a point keeps it.
  constexpr std::size_t none = ~std::size_t{0};
  std::vector<std::size_t> owner(surface.points.size(), none);
  std::vector<std::uint32_t> number(3 * surface.corners.size(), ~std::uint32_t{0});
  for (std::size_t corner = 0; corner < number.size(); ++corner) {
    const std::size_t sheet = corners.root(corner);
    std::uint32_t& point = surface.corners[corner / 3][corner % 3];
    if (owner[point] == none) owner[point] = sheet, number[sheet] = point;
    if (number[sheet] == ~std::uint32_t{0}) {
      number[sheet] = static_cast<std::uint32_t>(surface.points.size());
      const Vec3 place = surface.points[point];
      surface.points.push_back(place);
    }
    point = number[sheet];
  }
}

std::vector<Triangles> sheets_of(const Triangles& surface) {
  JoinedSets faces(surface.corners.size());
  for (const EdgeFaces& edge : edges_with_faces(surface))
    if (edge.uses.size() == 2) faces.join(edge.uses[0].face, edge.uses[1].face);
  std::map<std::size_t, Triangles> sheets;
  for (std::size_t face = 0; face < surface.corners.size(); ++face) {
    Triangles& sheet = sheets[faces.root(face)];
    const auto first = static_cast<std::uint32_t>(sheet.points.size());
    for (const std::uint32_t corner : surface.corners[face]) sheet.points.push_back(surface.points[corner]);
    sheet.corners.push_back({first, first + 1, first + 2});
  }
  std::vector<Triangles> result;
  for (auto& [root, sheet] : sheets) result.push_back(std::move(sheet));
  return result;
}

std::size_t turn_alike(Triangles& surface) {
  const std::size_t count = surface.corners.size();
  std::vector<std::vector<std::pair<std::uint32_t, bool>>> neighbours(count);  // face, looks the same way
  for (const EdgeFaces& edge : edges_with_faces(surface)) {
    if (edge.uses.size() != 2) continue;
    const bool alike = edge.uses[0].forth != edge.uses[1].forth;
    neighbours[edge.uses[0].face].emplace_back(edge.uses[1].face, alike);
    neighbours[edge.uses[1].face].emplace_back(edge.uses[0].face, alike);
  }
  std::vector<signed char> turn(count, 0);  // 1 as given, -1 turned, 0 not seen yet
  std::size_t turned_faces = 0;
  for (std::uint32_t start = 0; start < count; ++start) {
    if (turn[start] != 0) continue;
    turn[start] = 1;
    std::vector<std::uint32_t> part{start};
    for (std::size_t next = 0; next < part.size(); ++next)
      for (const auto& [face, alike] : neighbours[part[next]]) {
        if (turn[face] != 0) continue;
        turn[face] = static_cast<signed char>(alike ? turn[part[next]] : -turn[part[next]]);
        part.push_back(face);
      }
    const auto against = static_cast<std::size_t>(
        std::count_if(part.begin(), part.end(), [&](std::uint32_t face) { return turn[face] < 0; }));
    const signed char turns = 2 * against > part.size() ? 1 : -1;
    for (const std::uint32_t face : part)
      if (turn[face] == turns) std::swap(surface.corners[face][1], surface.corners[face][2]), ++turned_faces;
  }
  return turned_faces;
}

}  // namespace thalweg::gencase
