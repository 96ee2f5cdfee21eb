#include "foam_reference/shapes.hpp"

#include <algorithm>

#include "common/error.hpp"

namespace thalweg::foam {
namespace {

// In 2-D nothing depends on y: a sphere is a disc and a box or cylinder has no ends along y.
Vec3 in_plane(const Case& scene, Vec3 vector) {
  if (scene.info.dimension == 2) vector.y() = 0;
  return vector;
}

bool in_box(const Case& scene, const Shape& box, const Vec3& point) {
  for (const int axis : {0, 1, 2}) {
    if (axis == 1 && scene.info.dimension == 2) continue;
    if (point[axis] < box.from[axis] || point[axis] > box.to[axis]) return false;
  }
  return true;
}

bool in_cylinder(const Case& scene, const Shape& cylinder, const Vec3& point) {
  if (scene.info.dimension == 2) return in_plane(scene, point - cylinder.center).norm() <= cylinder.radius;
  const Vec3 axis = cylinder.to - cylinder.from;
  const Vec3 offset = point - cylinder.from;
  const double along = offset.dot(axis) / axis.squaredNorm();
  return along >= 0 && along <= 1 && (offset - along * axis).norm() <= cylinder.radius;
}

Bounds around(const Vec3& low, const Vec3& high, double radius) {
  return {low.cwiseMin(high).array() - radius, low.cwiseMax(high).array() + radius};
}

Bounds combined_bounds(const Case& scene, const Shape& shape) {
  Bounds bounds = bounds_of(scene, find_shape(scene, shape.of.front(), shape));
  if (shape.kind == ShapeKind::combine_difference) return bounds;
  for (const std::string& name : shape.of) {
    const Bounds part = bounds_of(scene, find_shape(scene, name, shape));
    if (shape.kind == ShapeKind::combine_union) {
      bounds = {bounds.low.cwiseMin(part.low), bounds.high.cwiseMax(part.high)};
    } else {
      bounds = {bounds.low.cwiseMax(part.low), bounds.high.cwiseMin(part.high)};
    }
  }
  return bounds;
}

}  // namespace

std::string place(const Case& scene, const Shape& shape) {
  return scene.file.string() + ":" + std::to_string(shape.line);
}

std::string place(const Case& scene) { return scene.file.string(); }

const Shape& find_shape(const Case& scene, const std::string& name, const Shape& asked_by) {
  const auto found = std::ranges::find(scene.shapes, name, &Shape::name);
  if (found != scene.shapes.end()) return *found;
  throw InputError(place(scene, asked_by) + ": shape \"" + asked_by.name + "\" names \"" + name +
                   "\", which does not exist; name a [[shape]] of this case");
}

Shape as_filled_box(const Case& scene, const Shape& shape) {
  if (shape.kind != ShapeKind::level && shape.kind != ShapeKind::layer) return shape;
  const auto container = std::ranges::find_if(scene.shapes, is_container);
  if (container == scene.shapes.end()) {
    throw InputError(place(scene, shape) + ": \"" + shape.name +
                     "\" has no container to fill; put a wall shape with side = \"outside\" before it");
  }
  Shape filled = shape;
  filled.kind = ShapeKind::box;
  filled.from = container->from;
  filled.to = container->to;
  filled.to.z() = shape.kind == ShapeKind::level ? shape.level : container->from.z() + shape.thickness;
  return filled;
}

bool contains(const Case& scene, const Shape& shape, const Vec3& point) {
  const auto in_part = [&](const std::string& name) { return contains(scene, find_shape(scene, name, shape), point); };
  switch (shape.kind) {
    case ShapeKind::box:
    case ShapeKind::level:
    case ShapeKind::layer:
      return in_box(scene, as_filled_box(scene, shape), point);
    case ShapeKind::cylinder:
      return in_cylinder(scene, shape, point);
    case ShapeKind::sphere:
      return in_plane(scene, point - shape.center).norm() <= shape.radius;
    case ShapeKind::combine_union:
      return std::ranges::any_of(shape.of, in_part);
    case ShapeKind::combine_intersection:
      return std::ranges::all_of(shape.of, in_part);
    case ShapeKind::combine_difference:
      return in_part(shape.of.front()) && std::none_of(shape.of.begin() + 1, shape.of.end(), in_part);
    case ShapeKind::cone:
    case ShapeKind::prism:
    case ShapeKind::bathymetry:
    case ShapeKind::mesh:
      break;  // plan_mesh refuses these but for a meshed solid, whose inside OpenFOAM finds
  }
  return false;
}

Bounds bounds_of(const Case& scene, const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::box:
      return {shape.from, shape.to};
    case ShapeKind::level:
    case ShapeKind::layer: {
      const Shape filled = as_filled_box(scene, shape);
      return {filled.from, filled.to};
    }
    case ShapeKind::sphere:
      return around(shape.center, shape.center, shape.radius);
    case ShapeKind::cylinder:
      if (scene.info.dimension == 2) return around(shape.center, shape.center, shape.radius);
      return around(shape.from, shape.to, shape.radius);
    case ShapeKind::combine_union:
    case ShapeKind::combine_difference:
    case ShapeKind::combine_intersection:
      return combined_bounds(scene, shape);
    case ShapeKind::cone:
    case ShapeKind::prism:
    case ShapeKind::bathymetry:
    case ShapeKind::mesh:
      break;  // plan_mesh refuses them as fluid, and as parts of it
  }
  throw InputError(place(scene, shape) + ": the mesh model does not know the bounds of \"" + shape.name +
                   "\"; run this case with --no-foam");
}

const Shape* shape_at(const Case& scene, const Vec3& point) {
  for (auto shape = scene.shapes.rbegin(); shape != scene.shapes.rend(); ++shape) {
    if (shape->role == ShapeRole::none || is_container(*shape) || !contains(scene, *shape, point)) continue;
    return &*shape;
  }
  return nullptr;
}

Material material_at(const Case& scene, const Vec3& point) {
  const Shape* shape = shape_at(scene, point);
  if (shape == nullptr) return Material::air;
  switch (shape->role) {
    case ShapeRole::water:
      return Material::water;
    case ShapeRole::sediment:
      return Material::sediment;
    case ShapeRole::wall:
    case ShapeRole::moving_wall:
      return Material::solid;
    case ShapeRole::empty:
    case ShapeRole::none:
      break;
  }
  return Material::air;
}

bool is_meshed_solid(const Case& scene, const Shape& shape) {
  const std::string extension = std::filesystem::path(shape.file).extension().string();
  return scene.info.dimension == 3 && shape.kind == ShapeKind::mesh && shape.role == ShapeRole::wall &&
         shape.side == WallSide::inside && shape.rotate.empty() && (extension == ".stl" || extension == ".obj");
}

bool is_container(const Shape& shape) { return shape.role == ShapeRole::wall && shape.side == WallSide::outside; }

}  // namespace thalweg::foam
