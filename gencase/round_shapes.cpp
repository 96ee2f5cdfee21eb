#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <numbers>

#include "gencase/primitives.hpp"
#include "gencase/surfaces.hpp"
#include "gencase/tessellation.hpp"

namespace thalweg::gencase {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr double everywhere = HUGE_VAL;

Kernel::Point_3 to_cgal(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// The values t with a t^2 + 2 b t + c <= 0.
Spans where_not_positive(double a, double b, double c) {
  if (a == 0) {
    if (b == 0) return c <= 0 ? Spans{{-everywhere, everywhere}} : Spans{};
    const double root = -c / (2 * b);
    return b > 0 ? Spans{{-everywhere, root}} : Spans{{root, everywhere}};
  }
  const double discriminant = b * b - a * c;
  if (discriminant < 0) return a > 0 ? Spans{} : Spans{{-everywhere, everywhere}};
  // The root of larger magnitude first, the other from the product of both: this avoids cancellation.
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  double low = q / a;
  double high = q == 0 ? 0 : c / q;
  if (low > high) std::swap(low, high);
  return a > 0 ? Spans{{low, high}} : Spans{{-everywhere, low}, {high, everywhere}};
}

/// The values t for which s0 + ds t lies between 0 and `length`.
Spans within_slab(double s0, double ds, double length) {
  if (std::abs(ds) < 1e-15) return s0 >= 0 && s0 <= length ? Spans{{-everywhere, everywhere}} : Spans{};
  const double first = -s0 / ds;
  const double second = (length - s0) / ds;
  return {{std::min(first, second), std::max(first, second)}};
}

Spans moved(Spans spans, double by) {
  for (Span& span : spans) span = {span.low + by, span.high + by};
  return spans;
}

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
  [[nodiscard]] Spans cut(const Line& line) const override {
    const Vec3 start = line.point(from_[line.axis]) - from_;  // near the shape, to avoid cancellation
    const Vec3 arm = start - start.dot(axis_) * axis_;
    const Vec3 turn = Vec3::Unit(line.axis) - axis_[line.axis] * axis_;
    const Spans side = where_not_positive(turn.squaredNorm(), arm.dot(turn), arm.squaredNorm() - radius_ * radius_);
    return moved(intersect(within_slab(start.dot(axis_), axis_[line.axis], (to_ - from_).norm()), side),
                 from_[line.axis]);
  }
  [[nodiscard]] std::optional<Triangles> triangles(double deviation) const override {
    return revolve(from_, axis_, {{0, radius_}, {(to_ - from_).norm(), radius_}}, deviation);
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

class Cone : public Region {
 public:
  Cone(const Vec3& from, const Vec3& to, double radius, double end_radius)
      : from_(from),
        radius_(radius),
        end_radius_(end_radius),
        length_((to - from).norm()),
        axis_((to - from) / length_),
        slope_((end_radius - radius) / length_),
        side_(from, axis_, radius, slope_) {
    if (radius > 0) ends_.emplace_back(from, -axis_);
    if (end_radius > 0) ends_.emplace_back(to, axis_);
  }
  [[nodiscard]] bool contains(const Vec3& p) const override {
    const double along = (p - from_).dot(axis_);
    return along >= 0 && along <= length_ && (p - from_ - along * axis_).norm() <= radius_ + slope_ * along;
  }
  [[nodiscard]] Bounds bounds() const override {
    const Vec3 across_axis = (1 - axis_.array().square()).max(0.0).sqrt();
    const Vec3 to = from_ + length_ * axis_;
    return {(from_ - radius_ * across_axis).cwiseMin(to - end_radius_ * across_axis),
            (from_ + radius_ * across_axis).cwiseMax(to + end_radius_ * across_axis)};
  }
  [[nodiscard]] std::optional<double> measure() const override {
    return std::numbers::pi / 3 * length_ * (radius_ * radius_ + radius_ * end_radius_ + end_radius_ * end_radius_);
  }
  [[nodiscard]] Spans cut(const Line& line) const override {
    const Vec3 start = line.point(from_[line.axis]) - from_;
    const double s0 = start.dot(axis_);
    const double ds = axis_[line.axis];
    const Vec3 arm = start - s0 * axis_;
    const Vec3 turn = Vec3::Unit(line.axis) - ds * axis_;
    const double r0 = radius_ + slope_ * s0;
    const double dr = slope_ * ds;
    const Spans side =
        where_not_positive(turn.squaredNorm() - dr * dr, arm.dot(turn) - r0 * dr, arm.squaredNorm() - r0 * r0);
    return moved(intersect(within_slab(s0, ds, length_), side), from_[line.axis]);
  }
  [[nodiscard]] std::optional<Triangles> triangles(double deviation) const override {
    return revolve(from_, axis_, {{0, radius_}, {length_, end_radius_}}, deviation);
  }
  void append_surfaces(std::vector<const Surface*>& surfaces) const override {
    surfaces.push_back(&side_);
    for (const Plane& end : ends_) surfaces.push_back(&end);
  }

 private:
  Vec3 from_;
  double radius_, end_radius_, length_;
  Vec3 axis_;
  double slope_;
  ConeSurface side_;
  std::vector<Plane> ends_;
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
  [[nodiscard]] Spans cut(const Line& line) const override {
    const int other = line.axis == 2 ? 0 : 2;
    const double arm = line.origin[other] - center_[other];
    return moved(where_not_positive(1, 0, arm * arm - radius_ * radius_), center_[line.axis]);
  }
  [[nodiscard]] std::optional<Triangles> triangles(double) const override { return std::nullopt; }
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
  [[nodiscard]] Spans cut(const Line& line) const override {
    const Vec3 arm = line.point(center_[line.axis]) - center_;
    return moved(where_not_positive(1, 0, arm.squaredNorm() - radius_ * radius_), center_[line.axis]);
  }
  [[nodiscard]] std::optional<Triangles> triangles(double deviation) const override {
    return tessellate_sphere(center_, radius_, deviation);
  }
  void append_surfaces(std::vector<const Surface*>& surfaces) const override { surfaces.push_back(&skin_); }

 private:
  Vec3 center_;
  double radius_;
  Kernel::Sphere_3 sphere_;
  RoundSurface skin_;
};

}  // namespace

RegionPointer make_cylinder(const Vec3& from, const Vec3& to, double radius) {
  return std::make_shared<Cylinder>(from, to, radius);
}
RegionPointer make_cone(const Vec3& from, const Vec3& to, double radius, double end_radius) {
  return std::make_shared<Cone>(from, to, radius, end_radius);
}
RegionPointer make_disc(const Vec3& center, double radius) { return std::make_shared<Disc>(center, radius); }
RegionPointer make_sphere(const Vec3& center, double radius) { return std::make_shared<Sphere>(center, radius); }

}  // namespace thalweg::gencase
