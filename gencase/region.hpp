#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "common/particles.hpp"

namespace thalweg::gencase {

/// Smallest box around something [m]; in 2-D y is 0.
struct Bounds {
  Vec3 lower = Vec3::Zero();
  Vec3 upper = Vec3::Zero();
};

/// One smooth piece of a region's skin, continued beyond the piece: a plane, a cylinder's side, a sphere, or a closed
/// triangle mesh. Edges and corners of regions are found where surfaces meet (nearest_surface.hpp).
class Surface {
 public:
  virtual ~Surface() = default;
  /// Exact distance [m] to the surface, negative on the side of the region.
  [[nodiscard]] virtual double signed_distance(const Vec3& point) const = 0;
  /// Gradient of signed_distance, a unit vector; `point - signed_distance * gradient` lies on the surface.
  [[nodiscard]] virtual Vec3 gradient(const Vec3& point) const = 0;
};

/// What surfaces bound: enough to find the nearest point of its skin.
class PointSet {
 public:
  virtual ~PointSet() = default;
  /// Whether `point` [m] lies in the set or on its skin.
  [[nodiscard]] virtual bool contains(const Vec3& point) const = 0;
  /// Appends every surface on which a part of the skin may lie. The set keeps them.
  virtual void append_surfaces(std::vector<const Surface*>& surfaces) const = 0;
};

/// A part of space (3-D) or of the plane y = 0 (2-D). A further kind of shape, such as a triangle mesh, is one more
/// class of this interface and one line in shapes.cpp.
class Region : public PointSet {
 public:
  [[nodiscard]] virtual Bounds bounds() const = 0;
  /// Volume [m^3], in 2-D area [m^2]; nothing where no closed form is at hand.
  [[nodiscard]] virtual std::optional<double> measure() const = 0;
};

using RegionPointer = std::shared_ptr<const Region>;

}  // namespace thalweg::gencase
