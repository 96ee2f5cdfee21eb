#pragma once

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// The faces of a box.
Triangles tessellate_box(const Vec3& lower, const Vec3& upper);

/// A closed surface of revolution about the unit vector `axis` through `from`. `profile` holds points (along, away)
/// [m], along the axis from `from` and away from it, in the direction of the axis. Its ends are closed by discs unless
/// they lie on the axis. Facets deviate from the true surface by at most `deviation` [m] around the axis.
Triangles revolve(const Vec3& from, const Vec3& axis, const std::vector<Eigen::Vector2d>& profile, double deviation);

/// A sphere whose facets deviate from it by at most `deviation` [m].
Triangles tessellate_sphere(const Vec3& center, double radius, double deviation);

/// The closed surface of a prism: the polygon, in the plane across `axis`, from `low` to `high` [m] along it. The
/// polygon runs counter-clockwise in the order of the two remaining coordinates (y, z / x, z / x, y).
Triangles extrude(const std::vector<Eigen::Vector2d>& polygon, int axis, double low, double high);

}  // namespace thalweg::gencase
