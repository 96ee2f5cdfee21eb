#include "gencase/checks.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <array>

#include "common/error.hpp"
#include "common/units.hpp"
#include "gencase/places.hpp"

namespace thalweg::gencase {
namespace {

bool inside_domain(const Case& scene, const Vec3& p) {
  for (int axis = 0; axis < 3; ++axis) {
    if (scene.info.dimension == 2 && axis == 1) continue;
    if (p[axis] < scene.domain.from[axis] || p[axis] > scene.domain.to[axis]) return false;
  }
  return true;
}

bool apart(const Case& scene, const Bounds& a, const Vec3& lower, const Vec3& upper) {
  for (int axis = 0; axis < 3; ++axis) {
    if (scene.info.dimension == 2 && axis == 1) continue;
    if (a.upper[axis] <= lower[axis] || a.lower[axis] >= upper[axis]) return true;
  }
  return false;
}

/// Name of the first earlier wall that contains the centre of the shape's bounding box, for messages.
std::string wall_around(const std::vector<PlacedShape>& shapes, const PlacedShape& inner) {
  const Bounds box = inner.body->bounds();
  for (const PlacedShape& shape : shapes) {
    if (&shape == &inner) break;
    if (shape.is_wall() && shape.body->contains(0.5 * (box.lower + box.upper)))
      return fmt::format("wall \"{}\"", shape.shape->name);
  }
  return "earlier walls";
}

[[noreturn]] void refuse_empty_shape(const Case& scene, const std::vector<PlacedShape>& shapes,
                                     const PlacedShape& shape, const ShapeFill& fill) {
  const std::string begin = where(scene, *shape.shape) + " gets no particle: ";
  if (apart(scene, shape.body->bounds(), scene.domain.from, scene.domain.to))
    throw InputError(begin + "it lies outside of the domain; move the shape or enlarge the domain");
  if (fill.claimed > 0 && shape.is_wall() && !shape.is_container())
    throw InputError(begin +
                     "no fluid can reach it, or later shapes take its place; move it, or "
                     "put it behind them in the case");
  if (fill.claimed > 0)
    throw InputError(begin + "later shapes take its place everywhere; put it behind them in the case, or remove it");
  if (fill.inside_wall > 0)
    throw InputError(begin + fmt::format("it lies inside {}; move it, or open the wall with a shape of role \"empty\" "
                                         "before it",
                                         wall_around(shapes, shape)));
  throw InputError(begin + fmt::format("no lattice point lies in it at a spacing of {}; use a smaller "
                                       "numerics.spacing, or correct the shape",
                                       length_text(scene.numerics.spacing)));
}

/// Counts a shape's particles that break a rule and keeps the first for the message.
struct Offence {
  std::int64_t count = 0;
  Vec3 first = Vec3::Zero();
  void add(const Vec3& position) {
    if (count++ == 0) first = position;
  }
  void add(const Offence& later) {
    if (count == 0) first = later.first;
    count += later.count;
  }
};

void check_places(const Case& scene, const std::vector<PlacedShape>& shapes, const FlowRoom& room,
                  const Filling& filling) {
  using Offences = std::vector<Offence>;  // per shape
  const Lattice& lattice = filling.lattice;
  const std::int64_t slabs = lattice.count[lattice.axes[0]];
  const std::int64_t nodes_of_slab = lattice.nodes() / slabs;
  std::vector<std::array<Offences, 2>> found(static_cast<std::size_t>(slabs));
  tbb::parallel_for(std::int64_t{0}, slabs, [&](std::int64_t slab) {
    auto& [domain, rooms] = found[static_cast<std::size_t>(slab)];
    domain.resize(shapes.size());
    rooms.resize(shapes.size());
    for (std::int64_t node = slab * nodes_of_slab; node < (slab + 1) * nodes_of_slab; ++node) {
      const Label label = filling.label[static_cast<std::size_t>(node)];
      if (label == nothing || label == solid_core) continue;
      const Vec3 position = lattice.position(lattice.offset(node));
      if (!inside_domain(scene, position)) domain[label - 1U].add(position);
      if (shapes[label - 1U].is_fluid() && !room.inside_rooms(position)) rooms[label - 1U].add(position);
    }
  });
  Offences outside_domain(shapes.size());
  Offences outside_rooms(shapes.size());
  for (const auto& [domain, rooms] : found) {
    for (std::size_t s = 0; s < shapes.size(); ++s) outside_domain[s].add(domain[s]), outside_rooms[s].add(rooms[s]);
  }
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    if (outside_domain[s].count > 0)
      throw InputError(
          fmt::format("{} has {} of its {} particles outside of the domain, the first at {}; enlarge "
                      "[domain] or shrink the shape",
                      where(scene, *shapes[s].shape), outside_domain[s].count, filling.shapes[s].kept,
                      placed_text(scene, outside_domain[s].first)));
    if (outside_rooms[s].count > 0)
      throw InputError(
          fmt::format("{} has {} of its {} particles outside of every container, the first at {}; shrink "
                      "the shape, or open that face of the container",
                      where(scene, *shapes[s].shape), outside_rooms[s].count, filling.shapes[s].kept,
                      placed_text(scene, outside_rooms[s].first)));
  }
}

}  // namespace

void check_filling(const Case& scene, const std::vector<PlacedShape>& shapes, const FlowRoom& room,
                   const Filling& filling) {
  for (std::size_t s = 0; s < shapes.size(); ++s)
    if (shapes[s].shape->role != ShapeRole::empty && filling.shapes[s].kept == 0)
      refuse_empty_shape(scene, shapes, shapes[s], filling.shapes[s]);
  check_places(scene, shapes, room, filling);
}

void warn_of_filling(const Case& scene, const std::vector<PlacedShape>& shapes, const Filling& filling,
                     const std::function<void(const std::string&)>& warn) {
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    const std::string begin = where(scene, *shapes[s].shape);
    const ShapeFill& fill = filling.shapes[s];
    if (fill.inside_wall > 0)
      warn(
          fmt::format("{}: {} of its {} lattice points lie in walls and stay wall; open the wall with a shape of role "
                      "\"empty\" before it if this is not intended",
                      begin, fill.inside_wall, fill.inside_wall + fill.claimed));
    if (shapes[s].shape->role == ShapeRole::empty && fill.claimed == 0)
      warn(begin + ": removes nothing, because no earlier shape overlaps it");
    if (shapes[s].is_wall() && shapes[s].thickness < kernel_support(scene) * (1 - 1e-6))
      warn(
          fmt::format("{}: the wall's thickness of {} is less than the kernel's support of {}; fluid beside it will "
                      "miss a part of the wall",
                      begin, length_text(shapes[s].thickness), length_text(kernel_support(scene))));
  }
}

}  // namespace thalweg::gencase
