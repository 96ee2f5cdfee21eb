#pragma once

#include "case/case.hpp"

namespace thalweg::foam {

/// Axis-aligned bounds [m].
struct Bounds {
  Vec3 low = Vec3::Zero();
  Vec3 high = Vec3::Zero();
};

/// The material at a point of the scene at the start.
enum class Material { air, water, sediment, solid };

/// Start of every message about a shape or the case: "file:line" or "file".
std::string place(const Case& scene, const Shape& shape);
std::string place(const Case& scene);

/// The shape another one names in `of`. Throws InputError when there is none.
const Shape& find_shape(const Case& scene, const std::string& name, const Shape& asked_by);

/// The box over the container's floor that a `level` or a `layer` fills; every other shape as it is.
/// Throws InputError if the case has no container.
Shape as_filled_box(const Case& scene, const Shape& shape);

/// True if `point` [m] lies in the shape; in 2-D only x and z count. Always false for a mesh, whose inside OpenFOAM
/// finds.
bool contains(const Case& scene, const Shape& shape, const Vec3& point);

/// Bounds of the shape [m]. Those of a difference are those of its first part; those of an intersection are the region
/// that the bounds of its parts share. Throws InputError for a kind of shape that the mesh model does not have.
Bounds bounds_of(const Case& scene, const Shape& shape);

/// The shape that fills `point` [m], nullptr if none does. Later shapes take the place of earlier ones; the container is
/// left out.
const Shape* shape_at(const Case& scene, const Vec3& point);

/// The material of that shape; air without one.
Material material_at(const Case& scene, const Vec3& point);

/// True if the shape is a solid that snappyHexMesh takes out: a wall in 3-D from an STL or OBJ file, not turned.
bool is_meshed_solid(const Case& scene, const Shape& shape);

/// True if the shape is the container of the flow.
bool is_container(const Shape& shape);

}  // namespace thalweg::foam
