#pragma once

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// A plane, given by a point and the unit normal that points out of the region.
class Plane : public Surface {
 public:
  Plane(const Vec3& point, const Vec3& normal) : offset_(normal.dot(point)), normal_(normal) {}
  [[nodiscard]] double signed_distance(const Vec3& p) const override { return normal_.dot(p) - offset_; }
  [[nodiscard]] Vec3 gradient(const Vec3&) const override { return normal_; }

 private:
  double offset_;
  Vec3 normal_;
};

/// All points at `radius` from a centre, or from an axis through it.
class RoundSurface : public Surface {
 public:
  /// `axis`: unit vector of a cylinder, zero for a sphere.
  RoundSurface(Vec3 center, double radius, Vec3 axis);
  [[nodiscard]] double signed_distance(const Vec3& p) const override { return arm(p).norm() - radius_; }
  [[nodiscard]] Vec3 gradient(const Vec3& p) const override;

 private:
  [[nodiscard]] Vec3 arm(const Vec3& p) const;
  Vec3 center_;
  double radius_;
  Vec3 axis_;
};

/// The side of a cone: radius `radius` [m] at `from`, changing by `slope` [-] per length along the unit vector `axis`.
class ConeSurface : public Surface {
 public:
  ConeSurface(Vec3 from, Vec3 axis, double radius, double slope);
  [[nodiscard]] double signed_distance(const Vec3& p) const override;
  [[nodiscard]] Vec3 gradient(const Vec3& p) const override;

 private:
  /// Coordinates of p in the half plane through the axis and p: along the axis, and away from it.
  [[nodiscard]] Eigen::Vector2d in_half_plane(const Vec3& p) const;
  [[nodiscard]] bool beyond_apex(const Eigen::Vector2d& q) const;
  Vec3 from_;
  Vec3 axis_;
  double radius_;
  Eigen::Vector2d normal_;  // in the half plane
};

/// A unit vector at right angles to the unit vector `axis`.
Vec3 across(const Vec3& axis);

}  // namespace thalweg::gencase
