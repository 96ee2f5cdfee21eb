#pragma once

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// Finds the nearest point of a set's skin. That point lies on one surface (a face), where two surfaces meet (an
/// edge) or where three do (a corner); each candidate is the foot of the perpendicular from the given point, and it
/// counts if the region's membership changes around it. So edges of unions and differences need no construction.
class NearestSurface : public SkinSearch {
 public:
  /// `length` [m]: the size of the smallest detail that matters (the particle spacing). The set must outlive this.
  NearestSurface(const PointSet& set, double length);

  [[nodiscard]] std::optional<SurfacePoint> find(const Vec3& from, double reach) const override;

 private:
  const PointSet& set_;
  double length_;
  std::vector<const Surface*> surfaces_;
};

}  // namespace thalweg::gencase
