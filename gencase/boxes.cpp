#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>

#include "gencase/primitives.hpp"
#include "gencase/surfaces.hpp"
#include "gencase/tessellation.hpp"

namespace thalweg::gencase {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Cuboid = Kernel::Iso_cuboid_3;

// Stands for infinity: far beyond any scene, but its squares are still finite numbers.
constexpr double far_away = 1e30;

Kernel::Point_3 to_cgal(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// The cuboid between two corners. In 2-D it is unbounded in y and stands for its cut by the plane y = 0.
Cuboid cuboid(Vec3 lower, Vec3 upper, int dimension) {
  if (dimension == 2) {
    lower.y() = -far_away;
    upper.y() = far_away;
  }
  return {to_cgal(lower), to_cgal(upper)};
}

/// True if `p` lies in the cuboid or on a face. Comparing doubles is exact; CGAL's own predicate uses intervals and is
/// ten times slower.
bool holds(const Cuboid& cuboid, const Vec3& p) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(p[axis] >= cuboid.min_coord(axis) && p[axis] <= cuboid.max_coord(axis))) return false;
  return true;
}

Spans cut_cuboid(const Cuboid& cuboid, const Line& line) {
  for (int axis = 0; axis < 3; ++axis)
    if (axis != line.axis &&
        !(line.origin[axis] >= cuboid.min_coord(axis) && line.origin[axis] <= cuboid.max_coord(axis)))
      return {};
  return {{cuboid.min_coord(line.axis), cuboid.max_coord(line.axis)}};
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
        planes_(face_planes(lower, upper, open, dimension, 1)),
        dimension_(dimension) {
    Vec3 edges = bounds_.upper - bounds_.lower;
    if (dimension == 2) edges.y() = 1;
    if (open == Faces{}) measure_ = edges.prod();
  }
  [[nodiscard]] bool contains(const Vec3& p) const override { return holds(cuboid_, p); }
  [[nodiscard]] Bounds bounds() const override { return bounds_; }
  [[nodiscard]] std::optional<double> measure() const override { return measure_; }
  [[nodiscard]] Spans cut(const Line& line) const override { return cut_cuboid(cuboid_, line); }
  [[nodiscard]] std::optional<Triangles> triangles(double) const override {
    if (dimension_ == 2) return std::nullopt;
    return tessellate_box(bounds_.lower, bounds_.upper);
  }
  void append_surfaces(std::vector<const Surface*>& surfaces) const override {
    for (const Plane& plane : planes_) surfaces.push_back(&plane);
  }

 private:
  Bounds bounds_;
  Cuboid cuboid_;
  std::vector<Plane> planes_;
  int dimension_;
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
  [[nodiscard]] bool contains(const Vec3& p) const override { return holds(outer_, p) && !interior_.contains(p); }
  [[nodiscard]] Bounds bounds() const override { return bounds_; }
  [[nodiscard]] std::optional<double> measure() const override { return std::nullopt; }
  [[nodiscard]] Spans cut(const Line& line) const override {
    return subtract(cut_cuboid(outer_, line), interior_.cut(line));
  }
  [[nodiscard]] std::optional<Triangles> triangles(double) const override { return std::nullopt; }
  void append_surfaces(std::vector<const Surface*>& surfaces) const override {
    for (const Plane& plane : planes_) surfaces.push_back(&plane);
  }

 private:
  Box interior_;
  Bounds bounds_;
  Cuboid outer_;
  std::vector<Plane> planes_;
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

}  // namespace thalweg::gencase
