#include "gencase/shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "common/error.hpp"
#include "common/units.hpp"
#include "gencase/combinations.hpp"
#include "gencase/primitives.hpp"

namespace thalweg::gencase {
namespace {

std::string length(double metres) { return format_quantity(metres, "m"); }

[[noreturn]] void refuse(const Case& scene, const Shape& shape, const std::string& what) {
  throw InputError(where(scene, shape) + " " + what);
}

/// The geometry of a shape; `named` holds the shapes before it.
RegionPointer make_region(const Shape& shape, int dimension, const std::map<std::string, RegionPointer>& named) {
  std::vector<RegionPointer> parts;
  for (const std::string& name : shape.of) parts.push_back(named.at(name));
  switch (shape.kind) {
    case ShapeKind::box:
      return make_box(shape.from, shape.to, dimension);
    case ShapeKind::cylinder:
      return dimension == 2 ? make_disc(shape.center, shape.radius) : make_cylinder(shape.from, shape.to, shape.radius);
    case ShapeKind::sphere:
      return dimension == 2 ? make_disc(shape.center, shape.radius) : make_sphere(shape.center, shape.radius);
    case ShapeKind::combine_union:
      return make_union(std::move(parts));
    case ShapeKind::combine_difference:
      return make_difference(std::move(parts));
    case ShapeKind::combine_intersection:
      return make_intersection(std::move(parts));
  }
  throw std::logic_error("a kind of shape without geometry");
}

Faces open_faces(const Case& scene, const Shape& shape) {
  Faces open{};
  for (std::size_t face = 0; face < open.size(); ++face)
    open[face] = std::find(shape.open.begin(), shape.open.end(), face_names[face]) != shape.open.end();
  for (const std::string& direction : scene.domain.periodic)
    for (std::size_t face = 0; face < open.size(); ++face)
      if (face_names[face] + 1 == direction && !open[face])
        refuse(scene, shape,
               fmt::format("walls off {0}, in which the domain is periodic; add \"-{0}\" and \"+{0}\" to its `open`",
                           direction));
  return open;
}

double density_at_rest(const Case& scene, const Shape& shape) {
  if (shape.role != ShapeRole::sediment) return scene.water.density;
  return shape.material.empty() ? scene.sediment().bed_density() : scene.sediments.at(shape.material).bed_density();
}

void check_extent(const Case& scene, const Shape& shape, const Bounds& bounds) {
  const double spacing = scene.numerics.spacing;
  for (int axis = 0; axis < 3; ++axis) {
    if (scene.info.dimension == 2 && axis == 1) continue;
    const double extent = bounds.upper[axis] - bounds.lower[axis];
    if (extent < spacing * (1 - 1e-9))
      refuse(scene, shape,
             fmt::format(
                 "measures {} in {}, less than the spacing of {}; use a smaller numerics.spacing or a larger shape",
                 length(extent), "xyz"[axis], length(spacing)));
  }
}

}  // namespace

ParticleType PlacedShape::type() const {
  switch (shape->role) {
    case ShapeRole::water:
      return ParticleType::water;
    case ShapeRole::sediment:
      return ParticleType::sediment;
    case ShapeRole::moving_wall:
      return ParticleType::moving_wall;
    default:
      return ParticleType::wall;
  }
}

std::string where(const Case& scene, const Shape& shape) {
  return fmt::format("{}:{}: shape \"{}\"", scene.file.string(), shape.line, shape.name);
}

double kernel_support(const Case& scene) { return 2 * scene.smoothing_length(); }

std::vector<PlacedShape> place_shapes(const Case& scene) {
  std::map<std::string, RegionPointer> named;
  std::vector<PlacedShape> placed;
  for (const Shape& shape : scene.shapes) {
    const RegionPointer region = make_region(shape, scene.info.dimension, named);
    named[shape.name] = region;
    if (shape.role == ShapeRole::none) continue;
    PlacedShape result{&shape, region, nullptr, 0, density_at_rest(scene, shape)};
    check_extent(scene, shape, region->bounds());
    const bool container = result.is_wall() && shape.side == WallSide::outside;
    const double spacing = scene.numerics.spacing;
    // Whole layers, so that the kernel of a particle at the wall finds the wall complete.
    result.thickness =
        shape.thickness > 0 ? shape.thickness : std::ceil(kernel_support(scene) / spacing - 1e-6) * spacing;
    if (container && shape.kind == ShapeKind::box) {
      const Faces open = open_faces(scene, shape);
      result.room = make_open_box(shape.from, shape.to, open, scene.info.dimension);
      result.body = make_container_wall(shape.from, shape.to, open, result.thickness, scene.info.dimension);
    } else if (container) {
      result.room = region;
      result.body = make_shell(region, result.thickness, scene.info.dimension);
    }
    placed.push_back(std::move(result));
  }
  return placed;
}

FlowRoom flow_room(const std::vector<PlacedShape>& shapes) {
  FlowRoom room;
  for (const PlacedShape& placed : shapes) {
    if (placed.is_container()) room.add_room(placed.room);
    if (placed.is_wall()) room.add_solid(placed.body);
    if (placed.shape->role == ShapeRole::empty) room.add_opening(placed.body);
  }
  return room;
}

}  // namespace thalweg::gencase
