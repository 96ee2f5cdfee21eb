#include "gencase/mesh_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "gencase/joined_sets.hpp"
#include "gencase/mesh_repair.hpp"
#include "gencase/polyhedron.hpp"
#include "gencase/triangle_columns.hpp"

namespace thalweg::gencase {
namespace {

struct Body {
  Triangles surface;  // looks outward, whatever the file says
  Bounds bounds;
  bool outward = true;  // as given, or as turned
  bool dropped = false;
  std::vector<std::size_t> around;  // bodies that it lies in, the outermost first
  std::unique_ptr<TriangleColumns> columns;
};

std::vector<Body> unjudged(const Triangles& surface) {
  std::vector<Body> bodies;
  for (Triangles& part : bodies_of(surface)) {
    Body& body = bodies.emplace_back();
    body.bounds = bounds_of(part);
    body.outward = volume(part) >= 0;
    body.surface = body.outward ? std::move(part) : turned(std::move(part));
  }
  return bodies;
}

/// True if most of some faces' middles lie inside `outer`. Bodies that touch share places, so one of them is no proof.
bool lies_in(const Body& inner, Body& outer) {
  if ((inner.bounds.lower.array() < outer.bounds.lower.array()).any() ||
      (inner.bounds.upper.array() > outer.bounds.upper.array()).any())
    return false;
  if (!outer.columns) outer.columns = std::make_unique<TriangleColumns>(outer.surface, 2);
  constexpr std::size_t looked_at = 25;
  const std::size_t stride = std::max<std::size_t>(1, inner.surface.corners.size() / looked_at);
  int inside = 0;
  int outside = 0;
  for (std::size_t face = 0; face < inner.surface.corners.size(); face += stride) {
    const auto& [a, b, c] = inner.surface.corners[face];
    const Vec3 middle = (inner.surface.points[a] + inner.surface.points[b] + inner.surface.points[c]) / 3;
    covers(outer.columns->inside(middle), middle.z()) ? ++inside : ++outside;
  }
  return inside > outside;
}

/// Finds for each body those that it lies in, sorted by volume, the largest first.
void nest(std::vector<Body>& bodies) {
  std::vector<std::size_t> by_volume(bodies.size());
  std::vector<double> volumes;
  for (const Body& body : bodies) volumes.push_back(volume(body.surface));
  for (std::size_t i = 0; i < bodies.size(); ++i) by_volume[i] = i;
  std::stable_sort(by_volume.begin(), by_volume.end(), [&](auto i, auto j) { return volumes[i] > volumes[j]; });
  for (std::size_t i = 0; i < by_volume.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (lies_in(bodies[by_volume[i]], bodies[by_volume[j]])) bodies[by_volume[i]].around.push_back(by_volume[j]);
}

struct Counts {
  std::size_t turned = 0;
  std::size_t dropped = 0;
};

Counts judge(std::vector<Body>& bodies) {
  Counts counts;
  std::vector<bool> given;
  for (const Body& body : bodies) given.push_back(body.outward);
  std::vector<std::size_t> order(bodies.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](auto i, auto j) { return bodies[i].around.size() < bodies[j].around.size(); });
  for (const std::size_t i : order) {
    Body& body = bodies[i];
    // A body that lies in no other has to look outward. What it holds turns with it.
    if (!given[body.around.empty() ? i : body.around.front()]) body.outward = !body.outward;
    int depth = 0;  // how often the place of the body is inside what lies around it
    for (const std::size_t outer : body.around)
      if (!bodies[outer].dropped) depth += bodies[outer].outward ? 1 : -1;
    if (!body.outward && depth <= 0) body.outward = true;
    body.dropped = depth >= (body.outward ? 1 : 2);
    counts.turned += body.outward != given[i];
    counts.dropped += body.dropped;
  }
  return counts;
}

}  // namespace

std::vector<std::uint32_t> parts_of(const Triangles& surface) {
  JoinedSets points(surface.points.size());
  for (const auto& [a, b, c] : surface.corners) points.join(a, b), points.join(b, c);
  std::vector<std::uint32_t> number(surface.points.size(), ~std::uint32_t{0});
  std::vector<std::uint32_t> part;
  std::uint32_t parts = 0;
  for (const auto& corners : surface.corners) {
    std::uint32_t& name = number[points.root(corners[0])];
    if (name == ~std::uint32_t{0}) name = parts++;
    part.push_back(name);
  }
  return part;
}

std::vector<Triangles> bodies_of(const Triangles& surface) {
  const std::vector<std::uint32_t> part = parts_of(surface);
  std::vector<Triangles> bodies;
  std::vector<std::uint32_t> number(surface.points.size(), ~std::uint32_t{0});
  for (std::size_t face = 0; face < part.size(); ++face) {
    if (part[face] >= bodies.size()) bodies.resize(part[face] + 1);
    Triangles& own = bodies[part[face]];
    std::array<std::uint32_t, 3>& corners = own.corners.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& name = number[surface.corners[face][k]];
      if (name == ~std::uint32_t{0}) {
        name = static_cast<std::uint32_t>(own.points.size());
        own.points.push_back(surface.points[surface.corners[face][k]]);
      }
      corners[k] = name;
    }
  }
  return bodies;
}

Judged judge_bodies(const Triangles& surface) {
  std::vector<Body> bodies = unjudged(surface);
  nest(bodies);
  const Counts counts = judge(bodies);
  Judged result;
  if (counts.turned == bodies.size())
    result.changes.emplace_back("is inside out and was turned");
  else if (counts.turned > 0)
    result.changes.push_back(fmt::format("has {} of its {} bodies inside out; turned", counts.turned, bodies.size()));
  if (counts.dropped > 0)
    result.changes.push_back(
        fmt::format("has {} of its {} bodies wholly inside another: taken as one solid with it; for a cavity, turn the "
                    "inner faces over",
                    counts.dropped, bodies.size()));
  for (Body& body : bodies) {
    if (body.dropped) continue;
    if (!body.outward) body.surface = turned(std::move(body.surface));
    const auto first = static_cast<std::uint32_t>(result.surface.points.size());
    result.surface.points.insert(result.surface.points.end(), body.surface.points.begin(), body.surface.points.end());
    for (const auto& [a, b, c] : body.surface.corners)
      result.surface.corners.push_back({a + first, b + first, c + first});
  }
  return result;
}

}  // namespace thalweg::gencase
