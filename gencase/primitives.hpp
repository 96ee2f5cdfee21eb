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

/// The box, extended to infinity through its open faces: the inside of a container.
RegionPointer make_open_box(const Vec3& lower, const Vec3& upper, const Faces& open, int dimension);

/// The wall of a container: the box enlarged by `thickness` [m] in each direction, edges and corners included, without
/// its inside and without the parts beyond open faces. Only the inner faces are its surfaces, because there is no flow
/// outside.
RegionPointer make_container_wall(const Vec3& lower, const Vec3& upper, const Faces& open, double thickness,
                                  int dimension);

/// The cylinder of `radius` [m] around the segment from `from` to `to` [m], with flat ends.
RegionPointer make_cylinder(const Vec3& from, const Vec3& to, double radius);

/// The cone or frustum with `radius` [m] at `from` and `end_radius` [m] at `to`, with flat ends. One radius may be 0.
RegionPointer make_cone(const Vec3& from, const Vec3& to, double radius, double end_radius);

/// A disc in the plane x-z, the cut of a cylinder along y or of a sphere by the plane of a 2-D scene.
RegionPointer make_disc(const Vec3& center, double radius);

RegionPointer make_sphere(const Vec3& center, double radius);

}  // namespace thalweg::gencase
