#include "gencase/polyhedron.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Geometry>
#include <array>
#include <mutex>

#include "gencase/mesh_sheets.hpp"
#include "gencase/triangle_columns.hpp"

namespace thalweg::gencase {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Facets = std::vector<Kernel::Triangle_3>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Facets::const_iterator>>>;

Kernel::Point_3 to_cgal(const Vec3& p) { return {p.x(), p.y(), p.z()}; }
Vec3 from_cgal(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

Facets facets_of(const Triangles& surface) {
  Facets facets;
  facets.reserve(surface.corners.size());
  for (const auto& [a, b, c] : surface.corners)
    facets.emplace_back(to_cgal(surface.points[a]), to_cgal(surface.points[b]), to_cgal(surface.points[c]));
  return facets;
}

Vec3 normal_of(const Kernel::Triangle_3& facet) {
  const Vec3 a = from_cgal(facet[0]);
  return (from_cgal(facet[1]) - a).cross(from_cgal(facet[2]) - a).normalized();
}

/// Finds nearest points with CGAL's tree of boxes around the facets.
class FacetTree : public SkinSearch {
 public:
  explicit FacetTree(const Triangles& surface) : facets_(facets_of(surface)), tree_(facets_.begin(), facets_.end()) {
    tree_.build();
    tree_.accelerate_distance_queries();
  }
  [[nodiscard]] std::optional<SurfacePoint> find(const Vec3& from, double reach) const override {
    const auto [point, facet] = tree_.closest_point_and_primitive(to_cgal(from));
    const Vec3 arm = from_cgal(point) - from;
    const double distance = arm.norm();
    if (distance >= reach) return std::nullopt;
    const double size = std::sqrt(facet->squared_area());
    if (distance <= 1e-9 * size) return SurfacePoint{from_cgal(point), normal_of(*facet), distance};
    return SurfacePoint{from_cgal(point), arm / distance, distance};
  }

 private:
  Facets facets_;
  Tree tree_;
};

class Polyhedron : public Region {
 public:
  explicit Polyhedron(Triangles surface) : surface_(std::move(surface)), bounds_(bounds_of(surface_)) {}

  [[nodiscard]] bool contains(const Vec3& p) const override {
    if ((p.array() < bounds_.lower.array()).any() || (p.array() > bounds_.upper.array()).any()) return false;
    for (const Span& span : columns(2).inside(p))
      if (p.z() >= span.low && p.z() <= span.high) return true;
    return false;
  }
  [[nodiscard]] Bounds bounds() const override { return bounds_; }
  [[nodiscard]] std::optional<double> measure() const override { return volume(surface_); }
  [[nodiscard]] Spans cut(const Line& line) const override { return columns(line.axis).inside(line.origin); }
  [[nodiscard]] std::optional<Triangles> triangles(double) const override { return surface_; }
  [[nodiscard]] bool is_mesh() const override { return true; }
  [[nodiscard]] const SkinSearch* own_search() const override {
    std::call_once(tree_made_, [&] { tree_ = std::make_unique<FacetTree>(surface_); });
    return tree_.get();
  }
  void append_surfaces(std::vector<const Surface*>& surfaces) const override { surfaces.push_back(&skin_); }

 private:
  /// The skin as one surface for NearestSurface.
  class Skin : public Surface {
   public:
    explicit Skin(const Polyhedron& of) : of_(of) {}
    [[nodiscard]] double signed_distance(const Vec3& p) const override {
      const double distance = of_.own_search()->find(p, HUGE_VAL)->distance;
      return of_.contains(p) ? -distance : distance;
    }
    [[nodiscard]] Vec3 gradient(const Vec3& p) const override {
      const SurfacePoint near = *of_.own_search()->find(p, HUGE_VAL);
      const bool on_it = near.distance <= 1e-9 * (of_.bounds_.upper - of_.bounds_.lower).norm();
      return on_it || of_.contains(p) ? near.direction : Vec3(-near.direction);
    }

   private:
    const Polyhedron& of_;
  };

  const TriangleColumns& columns(int axis) const {
    std::call_once(columns_made_[axis], [&] { columns_[axis] = std::make_unique<TriangleColumns>(surface_, axis); });
    return *columns_[axis];
  }

  Triangles surface_;
  Bounds bounds_;
  Skin skin_{*this};
  mutable std::array<std::once_flag, 3> columns_made_;
  mutable std::array<std::unique_ptr<TriangleColumns>, 3> columns_;
  mutable std::once_flag tree_made_;
  mutable std::unique_ptr<FacetTree> tree_;
};

/// A plate: its skin lies half the thickness away from its middle surface.
class Plate : public Region, public SkinSearch {
 public:
  Plate(Triangles surface, double thickness) : surface_(std::move(surface)), half_(0.5 * thickness), middle_(surface_) {
    bounds_ = bounds_of(surface_);
    bounds_.lower.array() -= half_;
    bounds_.upper.array() += half_;
    for (const Triangles& sheet : sheets_of(surface_)) skins_.push_back(std::make_unique<Skin>(sheet, half_));
  }
  [[nodiscard]] bool contains(const Vec3& p) const override { return middle_.find(p, half_).has_value(); }
  [[nodiscard]] Bounds bounds() const override { return bounds_; }
  [[nodiscard]] std::optional<double> measure() const override { return std::nullopt; }
  [[nodiscard]] Spans cut(const Line& line) const override {
    Spans spans;
    for (std::int64_t node = 0; node < line.count;) {
      const double at = line.along(node);
      const double distance = middle_.find(line.point(at), HUGE_VAL)->distance;
      if (distance < half_) spans.push_back({at, at});
      // The distance changes by at most a step from node to node, so these nodes lie beyond half the thickness.
      node += std::max<std::int64_t>(1, static_cast<std::int64_t>((distance - half_) / line.step));
    }
    return spans;
  }
  [[nodiscard]] std::optional<Triangles> triangles(double) const override { return std::nullopt; }
  [[nodiscard]] const SkinSearch* own_search() const override { return this; }
  [[nodiscard]] std::optional<SurfacePoint> find(const Vec3& from, double reach) const override {
    const SurfacePoint middle = *middle_.find(from, HUGE_VAL);
    const double distance = std::abs(half_ - middle.distance);
    if (distance >= reach) return std::nullopt;
    const bool inside = middle.distance < half_;
    const Vec3 out = middle.distance > 1e-9 * half_ ? Vec3(-middle.direction) : middle.direction;
    return SurfacePoint{middle.point + half_ * out, inside ? out : Vec3(-out), distance};
  }
  void append_surfaces(std::vector<const Surface*>& surfaces) const override {
    for (const auto& skin : skins_) surfaces.push_back(skin.get());
  }

 private:
  /// The skin around one sheet. Where sheets meet or cross, their skins hide each other and meet in edges.
  class Skin : public Surface {
   public:
    Skin(const Triangles& sheet, double half) : middle_(sheet), half_(half) {}
    [[nodiscard]] double signed_distance(const Vec3& p) const override {
      return middle_.find(p, HUGE_VAL)->distance - half_;
    }
    [[nodiscard]] Vec3 gradient(const Vec3& p) const override {
      const SurfacePoint middle = *middle_.find(p, HUGE_VAL);
      return middle.distance > 1e-9 * half_ ? Vec3(-middle.direction) : middle.direction;
    }

   private:
    FacetTree middle_;
    double half_;
  };

  Triangles surface_;
  double half_;
  FacetTree middle_;
  Bounds bounds_;
  std::vector<std::unique_ptr<Skin>> skins_;
};

}  // namespace

RegionPointer make_polyhedron(Triangles surface) { return std::make_shared<Polyhedron>(std::move(surface)); }
RegionPointer make_plate(Triangles surface, double thickness) {
  return std::make_shared<Plate>(std::move(surface), thickness);
}

double volume(const Triangles& surface) {
  if (surface.points.empty()) return 0;
  // Signed tetrahedra about a point of the surface: about the origin, large coordinates would cancel.
  const Kernel::Point_3 apex = to_cgal(surface.points.front());
  double sum = 0;
  for (const auto& [a, b, c] : surface.corners)
    sum += CGAL::volume(apex, to_cgal(surface.points[a]), to_cgal(surface.points[b]), to_cgal(surface.points[c]));
  return sum;
}

Bounds bounds_of(const Triangles& surface) {
  Bounds result{surface.points.front(), surface.points.front()};
  for (const Vec3& p : surface.points) {
    result.lower = result.lower.cwiseMin(p);
    result.upper = result.upper.cwiseMax(p);
  }
  return result;
}

}  // namespace thalweg::gencase
