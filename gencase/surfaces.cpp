#include "gencase/surfaces.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

namespace thalweg::gencase {

Vec3 across(const Vec3& axis) {
  return (std::abs(axis.z()) < 0.9 ? axis.cross(Vec3::UnitZ()) : axis.cross(Vec3::UnitX())).normalized();
}

RoundSurface::RoundSurface(Vec3 center, double radius, Vec3 axis)
    : center_(std::move(center)), radius_(radius), axis_(std::move(axis)) {}

Vec3 RoundSurface::gradient(const Vec3& p) const {
  const Vec3 away = arm(p);
  const double length = away.norm();
  if (length > 1e-12 * radius_) return away / length;
  return axis_.isZero() ? Vec3::UnitZ() : across(axis_);  // on the axis all directions are equal
}

Vec3 RoundSurface::arm(const Vec3& p) const {
  const Vec3 from_center = p - center_;
  return from_center - from_center.dot(axis_) * axis_;
}

ConeSurface::ConeSurface(Vec3 from, Vec3 axis, double radius, double slope)
    : from_(std::move(from)),
      axis_(std::move(axis)),
      radius_(radius),
      normal_(Eigen::Vector2d(-slope, 1).normalized()) {}

Eigen::Vector2d ConeSurface::in_half_plane(const Vec3& p) const {
  const double along = (p - from_).dot(axis_);
  return {along, (p - from_ - along * axis_).norm()};
}

bool ConeSurface::beyond_apex(const Eigen::Vector2d& q) const {
  const Eigen::Vector2d from_ring = q - Eigen::Vector2d(0, radius_);
  return (from_ring - from_ring.dot(normal_) * normal_).y() < -radius_;  // the foot lies on the other side of the axis
}

double ConeSurface::signed_distance(const Vec3& p) const {
  const Eigen::Vector2d q = in_half_plane(p);
  if (!beyond_apex(q)) return normal_.dot(q - Eigen::Vector2d(0, radius_));
  return (q - Eigen::Vector2d(radius_ * normal_.y() / normal_.x(), 0)).norm();
}

Vec3 ConeSurface::gradient(const Vec3& p) const {
  const Eigen::Vector2d q = in_half_plane(p);
  const Vec3 arm = p - from_ - q.x() * axis_;
  const Vec3 away = q.y() > 1e-12 * (radius_ + std::abs(q.x())) ? Vec3(arm / q.y()) : across(axis_);
  if (!beyond_apex(q)) return normal_.x() * axis_ + normal_.y() * away;
  const Eigen::Vector2d from_apex = q - Eigen::Vector2d(radius_ * normal_.y() / normal_.x(), 0);
  return (from_apex.x() * axis_ + from_apex.y() * away).normalized();
}

}  // namespace thalweg::gencase
