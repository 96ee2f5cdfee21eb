#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "common/particles.hpp"
#include "gencase/spans.hpp"

namespace thalweg::gencase {

/// Smallest box around something [m]; in 2-D y is 0.
struct Bounds {
  Vec3 lower = Vec3::Zero();
  Vec3 upper = Vec3::Zero();
};

/// A surface as triangles whose corners run counter-clockwise seen from outside.
struct Triangles {
  std::vector<Vec3> points;  // [m]
  std::vector<std::array<std::uint32_t, 3>> corners;
};

/// One smooth piece of a region's skin, continued beyond the piece: a plane, a cylinder's side, a cone or a sphere.
/// Edges and corners of regions are found where surfaces meet (nearest_surface.hpp).
class Surface {
 public:
  virtual ~Surface() = default;
  /// Exact distance [m] to the surface, negative on the side of the region.
  [[nodiscard]] virtual double signed_distance(const Vec3& point) const = 0;
  /// Gradient of signed_distance, a unit vector; `point - signed_distance * gradient` lies on the surface.
  [[nodiscard]] virtual Vec3 gradient(const Vec3& point) const = 0;
};

/// A set of points bounded by surfaces, with what NearestSurface needs to find the nearest point of its skin.
class PointSet {
 public:
  virtual ~PointSet() = default;
  /// True if `point` [m] lies in the set or on its skin.
  [[nodiscard]] virtual bool contains(const Vec3& point) const = 0;
  /// Appends every surface on which a part of the skin may lie. The set owns them.
  virtual void append_surfaces(std::vector<const Surface*>& surfaces) const = 0;
};

/// The point of a set's skin nearest to a given one.
struct SurfacePoint {
  Vec3 point = Vec3::Zero();      // [m]
  Vec3 direction = Vec3::Zero();  // unit vector from the given point to the skin; on the skin the surface's gradient
  double distance = 0;            // [m]
};

/// Finds the nearest point of a skin.
class SkinSearch {
 public:
  virtual ~SkinSearch() = default;
  /// The point of the skin nearest to `from` [m]; nothing if there is none within `reach` [m].
  [[nodiscard]] virtual std::optional<SurfacePoint> find(const Vec3& from, double reach) const = 0;
};

/// A part of space (3-D) or of the plane y = 0 (2-D).
class Region : public PointSet {
 public:
  [[nodiscard]] virtual Bounds bounds() const = 0;
  /// Volume [m^3], in 2-D area [m^2]; nothing if it has no closed form.
  [[nodiscard]] virtual std::optional<double> measure() const = 0;
  /// The parts of a line within the region. They need to be exact only at the line's nodes.
  [[nodiscard]] virtual Spans cut(const Line& line) const = 0;
  /// The skin as a closed surface of triangles that deviate from it by at most `deviation` [m]; nothing in 2-D and for
  /// regions that are given by distances.
  [[nodiscard]] virtual std::optional<Triangles> triangles(double deviation) const = 0;
  /// True if the region is given by triangles, so that these are exact.
  [[nodiscard]] virtual bool is_mesh() const { return false; }
  /// A search of the skin that is faster than NearestSurface, or nullptr.
  [[nodiscard]] virtual const SkinSearch* own_search() const { return nullptr; }
};

using RegionPointer = std::shared_ptr<const Region>;

}  // namespace thalweg::gencase
