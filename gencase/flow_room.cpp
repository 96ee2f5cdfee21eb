#include "gencase/flow_room.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "gencase/booleans.hpp"
#include "gencase/polyhedron.hpp"
#include "gencase/tessellation.hpp"

namespace thalweg::gencase {

namespace {

bool overlap(const Bounds& a, const Bounds& b) {
  return (a.lower.array() < b.upper.array()).all() && (b.lower.array() < a.upper.array()).all();
}

/// Combines two surfaces. If they touch without overlapping, so that the result would be no surface, moves the second
/// one by `nudge` [m] in one of four directions and tries again; `nudge` is far below the resolution of the scene.
/// Throws NoManifold if none of them helps.
Triangles combine_nudged(const Triangles& a, const Triangles& b, Boolean how, double nudge) {
  try {
    return combine(a, b, how);
  } catch (const NoManifold&) {
    for (const Vec3& direction : {Vec3(1, 0.7, 0.4), Vec3(-1, 0.4, 0.7), Vec3(0.7, -1, 0.4), Vec3(-0.4, -0.7, 1)}) {
      Triangles moved = b;
      for (Vec3& p : moved.points) p += nudge * direction;
      try {
        return combine(a, moved, how);
      } catch (const NoManifold&) {
        continue;
      }
    }
    throw;
  }
}

/// True for the surface of an axis-parallel box.
bool is_box(const Triangles& surface) {
  constexpr std::size_t corners = 8;
  if (surface.points.size() != corners) return false;
  const Bounds bounds = bounds_of(surface);
  return std::all_of(surface.points.begin(), surface.points.end(), [&](const Vec3& p) {
    return (p.array() == bounds.lower.array() || p.array() == bounds.upper.array()).all();
  });
}

/// The part of a surface's body in a box. Boxes need no cutting: an open one reaches 1e30 m beyond its face, where the
/// cut of two surfaces, rounded, has points twice and faces without area. These make later cuts lose whole bodies.
Triangles clipped(const Triangles& surface, const Bounds& box) {
  if (is_box(surface)) {
    const Bounds own = bounds_of(surface);
    if (!overlap(own, box)) return {};
    return tessellate_box(own.lower.cwiseMax(box.lower), own.upper.cwiseMin(box.upper));
  }
  return combine(surface, tessellate_box(box.lower, box.upper), Boolean::intersect);
}

}  // namespace

void FlowRoom::add_container(RegionPointer room, RegionPointer wall) {
  rooms_.push_back(room);
  layers_.push_back({std::move(wall), true, std::move(room)});
}
void FlowRoom::add_solid(RegionPointer solid) { layers_.push_back({std::move(solid), true, nullptr}); }
void FlowRoom::add_opening(RegionPointer opening) { layers_.push_back({std::move(opening), false, nullptr}); }

Spans FlowRoom::cut(const Line& line) const {
  Spans spans;
  for (const RegionPointer& room : rooms_) spans = unite(spans, room->cut(line));
  if (rooms_.empty()) spans = {{-HUGE_VAL, HUGE_VAL}};
  for (const Layer& layer : layers_)
    spans = layer.solid ? subtract(spans, layer.region->cut(line)) : unite(spans, layer.region->cut(line));
  return spans;
}

Bounds FlowRoom::bounds_of_rooms() const {
  Bounds result = rooms_.front()->bounds();
  for (const RegionPointer& room : rooms_) {
    result.lower = result.lower.cwiseMin(room->bounds().lower);
    result.upper = result.upper.cwiseMax(room->bounds().upper);
  }
  return result;
}

bool FlowRoom::has_solids() const {
  return std::any_of(layers_.begin(), layers_.end(), [](const Layer& layer) { return layer.solid; });
}

Bounds FlowRoom::bounds_of_solids() const {
  Bounds result{Vec3::Constant(HUGE_VAL), Vec3::Constant(-HUGE_VAL)};
  for (const Layer& layer : layers_) {
    if (!layer.solid) continue;
    result.lower = result.lower.cwiseMin(layer.region->bounds().lower);
    result.upper = result.upper.cwiseMax(layer.region->bounds().upper);
  }
  return result;
}

bool FlowRoom::has_meshes() const {
  return std::any_of(layers_.begin(), layers_.end(), [](const Layer& layer) {
    return layer.region->is_mesh() || (layer.room != nullptr && layer.room->is_mesh());
  });
}

std::optional<Triangles> FlowRoom::triangles(const Bounds& around, double deviation) const {
  Triangles flow;
  if (rooms_.empty()) flow = tessellate_box(around.lower, around.upper);
  for (const RegionPointer& room : rooms_) {
    const auto inside = room->triangles(deviation);
    if (!inside) return std::nullopt;
    flow = combine_nudged(flow, clipped(*inside, around), Boolean::unite, 1e-3 * deviation);
  }
  for (const Layer& layer : layers_) {
    // A container's wall bounds its own room, which is in `flow` already. It matters only to openings and other
    // containers that overlap it; such walls have no triangles.
    if (layer.room != nullptr) {
      const auto reaches_through = [&](const Layer& other) {
        const bool earlier_opening = !other.solid && &other < &layer;
        const bool other_container = other.room != nullptr && &other != &layer;
        return (earlier_opening || other_container) && overlap(other.region->bounds(), layer.region->bounds());
      };
      if (std::none_of(layers_.begin(), layers_.end(), reaches_through)) continue;
      return std::nullopt;
    }
    const auto body = layer.region->triangles(deviation);
    if (!body) return std::nullopt;
    flow = combine_nudged(flow, layer.solid ? *body : clipped(*body, around),
                          layer.solid ? Boolean::subtract : Boolean::unite, 1e-3 * deviation);
  }
  return flow;
}

std::vector<Vec3> FlowRoom::skin_samples(double step) const {
  constexpr std::size_t samples_of_a_mesh = 200;
  std::vector<Vec3> samples;
  for (const Layer& layer : layers_) {
    const auto mesh = layer.solid && layer.region->is_mesh() ? layer.region->triangles(0) : std::nullopt;
    if (!mesh) continue;
    const std::size_t stride = std::max<std::size_t>(1, mesh->corners.size() / samples_of_a_mesh);
    for (std::size_t face = 0; face < mesh->corners.size(); face += stride) {
      const auto& [a, b, c] = mesh->corners[face];
      const Vec3& p = mesh->points[a];
      const Vec3 normal = (mesh->points[b] - p).cross(mesh->points[c] - p).normalized();
      const Vec3 middle = (p + mesh->points[b] + mesh->points[c]) / 3;
      if (contains(middle + step * normal) && !contains(middle - step * normal)) samples.push_back(middle);
    }
  }
  return samples;
}

bool FlowRoom::inside_containers(const Vec3& point) const {
  return std::any_of(rooms_.begin(), rooms_.end(), [&](const RegionPointer& room) { return room->contains(point); });
}

bool FlowRoom::inside_rooms(const Vec3& point) const {
  if (rooms_.empty() || inside_containers(point)) return true;
  return std::any_of(layers_.begin(), layers_.end(),
                     [&](const Layer& layer) { return !layer.solid && layer.region->contains(point); });
}

bool FlowRoom::contains(const Vec3& point) const {
  if (!inside_rooms(point)) return false;
  for (auto layer = layers_.rbegin(); layer != layers_.rend(); ++layer)
    if (layer->region->contains(point)) return !layer->solid;
  return true;
}

void FlowRoom::append_surfaces(std::vector<const Surface*>& surfaces) const {
  for (const Layer& layer : layers_) layer.region->append_surfaces(surfaces);
}

}  // namespace thalweg::gencase
