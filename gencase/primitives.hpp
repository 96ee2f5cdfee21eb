#pragma once

#include <array>
#include <string>
#include <vector>

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// Faces of a box in the order -x, +x, -y, +y, -z, +z.
using Faces = std::array<bool, 6>;
inline constexpr std::array<const char*, 6> face_names{"-x", "+x", "-y", "+y", "-z", "+z"};

/// The box between two corners [m], lower < upper; in 2-D a rectangle of the plane x-z.
RegionPointer make_box(const Vec3& lower, const Vec3& upper, int dimension);

/// The box continued without end through its open faces: the room a container leaves to the flow.
RegionPointer make_open_box(const Vec3& lower, const Vec3& upper, const Faces& open, int dimension);

/// The wall of a container: everything within `thickness` [m] of the box in each direction, also around its edges and
/// corners, but nothing beyond an open face. Only the box's own faces are surfaces of it; nothing flows outside.
RegionPointer make_container_wall(const Vec3& lower, const Vec3& upper, const Faces& open, double thickness,
                                  int dimension);

/// `radius` [m] around the segment from `from` to `to`, with flat ends.
RegionPointer make_cylinder(const Vec3& from, const Vec3& to, double radius);

/// `radius` [m] at `from` and `end_radius` at `to`, with flat ends; one of the radii may be 0.
RegionPointer make_cone(const Vec3& from, const Vec3& to, double radius, double end_radius);

/// The disc of the plane x-z: what a cylinder along y or a sphere is in 2-D.
RegionPointer make_disc(const Vec3& center, double radius);

RegionPointer make_sphere(const Vec3& center, double radius);

}  // namespace thalweg::gencase
