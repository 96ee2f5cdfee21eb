#pragma once

#include "case/case.hpp"

namespace thalweg::foam {

/// Axis-aligned bounds [m].
struct Bounds {
  Vec3 low = Vec3::Zero();
  Vec3 high = Vec3::Zero();
};

/// What a point of the scene is made of at the start.
enum class Material { air, water, sediment, solid };

/// Start of every message about a shape or the case: "file:line" or "file".
std::string place(const Case& scene, const Shape& shape);
std::string place(const Case& scene);

/// The shape another one names in `of`. Throws InputError when there is none.
const Shape& find_shape(const Case& scene, const std::string& name, const Shape& asked_by);

/// `level` and `layer` as the box over the container's floor that they fill; every other shape as it is.
/// Throws InputError where no container stands before it.
Shape as_filled_box(const Case& scene, const Shape& shape);

/// Whether `point` [m] lies in the shape (never in a mesh, whose inside OpenFOAM finds); in 2-D only x and z count.
bool contains(const Case& scene, const Shape& shape, const Vec3& point);

/// Bounds of the shape [m] (of a difference: those of its first part; of an intersection: what the bounds share).
Bounds bounds_of(const Case& scene, const Shape& shape);

/// What the shapes put at `point` [m]: later ones take the place of earlier ones; the container counts for nothing.
Material material_at(const Case& scene, const Vec3& point);

/// Whether the shape is a solid that snappyHexMesh takes out: a wall in 3-D from an STL or OBJ file, not turned.
bool is_meshed_solid(const Case& scene, const Shape& shape);

/// Whether the shape is the container the flow lies in.
bool is_container(const Shape& shape);

}  // namespace thalweg::foam
