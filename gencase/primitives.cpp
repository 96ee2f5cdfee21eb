#include "gencase/primitives.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <utility>

namespace thalweg::gencase {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Cuboid = Kernel::Iso_cuboid_3;

// Stands for "without end": far beyond any scene, yet a number whose squares stay finite.
constexpr double far_away = 1e30;

Kernel::Point_3 to_cgal(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// A plane given by a point and the unit normal that leads out of the region.
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
  RoundSurface(Vec3 center, double radius, Vec3 axis)
      : center_(std::move(center)), radius_(radius), axis_(std::move(axis)) {}
  [[nodiscard]] double signed_distance(const Vec3& p) const override { return arm(p).norm() - radius_; }
  [[nodiscard]] Vec3 gradient(const Vec3& p) const override {
    const Vec3 away = arm(p);
    const double length = away.norm();
    if (length > 1e-12 * radius_) return away / length;
    // On the axis every way out is as near as any other.
    return axis_.isZero()
               ? Vec3::UnitZ()
               : (std::abs(axis_.z()) < 0.9 ? axis_.cross(Vec3::UnitZ()) : axis_.cross(Vec3::UnitX())).normalized();
  }

 private:
  [[nodiscard]] Vec3 arm(const Vec3& p) const {
    const Vec3 from_center = p - center_;
    return from_center - from_center.dot(axis_) * axis_;
  }
  Vec3 center_;
  double radius_;
  Vec3 axis_;
};

/// In 2-D a cuboid stands for the rectangle in which it cuts the plane y = 0.
Cuboid cuboid(Vec3 lower, Vec3 upper, int dimension) {
  if (dimension == 2) {
    lower.y() = -far_away;
    upper.y() = far_away;
  }
  return {to_cgal(lower), to_cgal(upper)};
}

std::vector<Plane> face_planes(const Vec3& lower, const Vec3& upper, const Faces& without, int dimension,
                               double outward) {
  std::vector<Plane> planes;
  for (std::size_t face = 0; face < without.size(); ++face) {
    const auto axis = static_cast<Eigen::Index>(face / 2);
    if (without[face] || (dimension == 2 && axis == 1)) continue;
    const bool upper_face = face % 2 == 1;
    planes.emplace_back(upper_face ? upper : lower, (upper_face ? outward : -outward) * Vec3::Unit(axis));
  }
  return planes;
}

/// Pushes the faces chosen by `which` outward by `distance`.
Bounds grown(const Vec3& lower, const Vec3& upper, const Faces& which, double distance) {
  Bounds result{lower, upper};
  for (std::size_t face = 0; face < which.size(); ++face) {
    const auto axis = static_cast<Eigen::Index>(face / 2);
    if (!which[face]) continue;
    if (face % 2 == 1)
      result.upper[axis] += distance;
    else
      result.lower[axis] -= distance;
  }
  return result;
}

Faces opposite(Faces faces) {
  for (bool& face : faces) face = !face;
  return faces;
}

class Box : public Region {
 public:
  Box(const Vec3& lower, const Vec3& upper, const Faces& open, int dimension)
      : bounds_(grown(lower, upper, open, far_away)),
        cuboid_(cuboid(bounds_.lower, bounds_.upper, dimension)),
        planes_(face_planes(lower, upper, open, dimension, 1)) {
    Vec3 edges = bounds_.upper - bounds_.lower;
    if (dimension == 2) edges.y() = 1;
    if (open == Faces{}) measure_ = edges.prod();
  }
  [[nodiscard]] bool contains(const Vec3& p) const override { return !cuboid_.has_on_unbounded_side(to_cgal(p)); }
  [[nodiscard]] Bounds bounds() const override { return bounds_; }
  [[nodiscard]] std::optional<double> measure() const override { return measure_; }
  void append_surfaces(std::vector<const Surface*>& surfaces) const override {
    for (const Plane& plane : planes_) surfaces.push_back(&plane);
  }

 private:
  Bounds bounds_;
  Cuboid cuboid_;
  std::vector<Plane> planes_;
  std::optional<double> measure_;
};

class ContainerWall : public Region {
 public:
  ContainerWall(const Vec3& lower, const Vec3& upper, const Faces& open, double thickness, int dimension)
      : interior_(lower, upper, open, dimension),
        bounds_(grown(lower, upper, opposite(open), thickness)),
        outer_(cuboid(bounds_.lower, bounds_.upper, dimension)),
        planes_(face_planes(lower, upper, open, dimension, -1)) {
    if (dimension == 2) bounds_.lower.y() = bounds_.upper.y() = 0;
  }
  [[nodiscard]] bool contains(const Vec3& p) const override {
    return !outer_.has_on_unbounded_side(to_cgal(p)) && !interior_.contains(p);
  }
  [[nodiscard]] Bounds bounds() const override { return bounds_; }
  [[nodiscard]] std::optional<double> measure() const override { return std::nullopt; }
  void append_surfaces(std::vector<const Surface*>& surfaces) const override {
    for (const Plane& plane : planes_) surfaces.push_back(&plane);
  }

 private:
  Box interior_;
  Bounds bounds_;
  Cuboid outer_;
  std::vector<Plane> planes_;
};

class Cylinder : public Region {
 public:
  Cylinder(const Vec3& from, const Vec3& to, double radius)
      : from_(from),
        to_(to),
        radius_(radius),
        axis_((to - from).normalized()),
        line_(to_cgal(from), to_cgal(to)),
        first_end_(to_cgal(from), Kernel::Vector_3(-axis_.x(), -axis_.y(), -axis_.z())),
        second_end_(to_cgal(to), Kernel::Vector_3(axis_.x(), axis_.y(), axis_.z())),
        side_(from, radius, axis_),
        ends_{Plane(from, -axis_), Plane(to, axis_)} {}
  [[nodiscard]] bool contains(const Vec3& p) const override {
    const Kernel::Point_3 point = to_cgal(p);
    return !first_end_.has_on_positive_side(point) && !second_end_.has_on_positive_side(point) &&
           CGAL::squared_distance(point, line_) <= radius_ * radius_;
  }
  [[nodiscard]] Bounds bounds() const override {
    const Vec3 reach = radius_ * (1 - axis_.array().square()).max(0.0).sqrt();
    return {from_.cwiseMin(to_) - reach, from_.cwiseMax(to_) + reach};
  }
  [[nodiscard]] std::optional<double> measure() const override {
    return std::numbers::pi * radius_ * radius_ * (to_ - from_).norm();
  }
  void append_surfaces(std::vector<const Surface*>& surfaces) const override {
    surfaces.insert(surfaces.end(), {&side_, &ends_[0], &ends_[1]});
  }

 private:
  Vec3 from_, to_;
  double radius_;
  Vec3 axis_;
  Kernel::Line_3 line_;
  Kernel::Plane_3 first_end_, second_end_;
  RoundSurface side_;
  std::array<Plane, 2> ends_;
};

class Disc : public Region {
 public:
  Disc(const Vec3& center, double radius)
      : center_(center),
        radius_(radius),
        circle_(Kernel::Point_2(center.x(), center.z()), radius * radius),
        edge_(center, radius, Vec3::UnitY()) {}
  [[nodiscard]] bool contains(const Vec3& p) const override {
    return !circle_.has_on_unbounded_side(Kernel::Point_2(p.x(), p.z()));
  }
  [[nodiscard]] Bounds bounds() const override {
    const Vec3 reach(radius_, 0, radius_);
    return {center_ - reach, center_ + reach};
  }
  [[nodiscard]] std::optional<double> measure() const override { return std::numbers::pi * radius_ * radius_; }
  void append_surfaces(std::vector<const Surface*>& surfaces) const override { surfaces.push_back(&edge_); }

 private:
  Vec3 center_;
  double radius_;
  Kernel::Circle_2 circle_;
  RoundSurface edge_;
};

class Sphere : public Region {
 public:
  Sphere(const Vec3& center, double radius)
      : center_(center),
        radius_(radius),
        sphere_(to_cgal(center), radius * radius),
        skin_(center, radius, Vec3::Zero()) {}
  [[nodiscard]] bool contains(const Vec3& p) const override { return !sphere_.has_on_unbounded_side(to_cgal(p)); }
  [[nodiscard]] Bounds bounds() const override {
    return {center_ - Vec3::Constant(radius_), center_ + Vec3::Constant(radius_)};
  }
  [[nodiscard]] std::optional<double> measure() const override {
    return 4.0 / 3.0 * std::numbers::pi * radius_ * radius_ * radius_;
  }
  void append_surfaces(std::vector<const Surface*>& surfaces) const override { surfaces.push_back(&skin_); }

 private:
  Vec3 center_;
  double radius_;
  Kernel::Sphere_3 sphere_;
  RoundSurface skin_;
};

}  // namespace

RegionPointer make_box(const Vec3& lower, const Vec3& upper, int dimension) {
  return std::make_shared<Box>(lower, upper, Faces{}, dimension);
}
RegionPointer make_open_box(const Vec3& lower, const Vec3& upper, const Faces& open, int dimension) {
  return std::make_shared<Box>(lower, upper, open, dimension);
}
RegionPointer make_container_wall(const Vec3& lower, const Vec3& upper, const Faces& open, double thickness,
                                  int dimension) {
  return std::make_shared<ContainerWall>(lower, upper, open, thickness, dimension);
}
RegionPointer make_cylinder(const Vec3& from, const Vec3& to, double radius) {
  return std::make_shared<Cylinder>(from, to, radius);
}
RegionPointer make_disc(const Vec3& center, double radius) { return std::make_shared<Disc>(center, radius); }
RegionPointer make_sphere(const Vec3& center, double radius) { return std::make_shared<Sphere>(center, radius); }

}  // namespace thalweg::gencase
