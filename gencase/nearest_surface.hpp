#pragma once

#include <optional>

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// The point of a set's skin nearest to a given one.
struct SurfacePoint {
  Vec3 point = Vec3::Zero();      // [m]
  Vec3 direction = Vec3::Zero();  // unit vector from the given point to the skin; on the skin the surface's gradient
  double distance = 0;            // [m]
};

/// Finds the nearest point of a set's skin. That point lies on one surface (a face), where two surfaces meet (an
/// edge) or where three do (a corner); each candidate is the foot of the perpendicular from the given point, and it
/// counts if the region's membership changes around it. So edges of unions and differences need no construction.
class NearestSurface {
 public:
  /// `length` [m]: the size of the smallest detail that matters (the particle spacing). The set must outlive this.
  NearestSurface(const PointSet& set, double length);

  /// Nothing when no skin lies within `reach` [m] of `from` (or none at all).
  [[nodiscard]] std::optional<SurfacePoint> find(const Vec3& from, double reach) const;

 private:
  const PointSet& set_;
  double length_;
  std::vector<const Surface*> surfaces_;
};

}  // namespace thalweg::gencase
