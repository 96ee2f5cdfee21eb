#pragma once

#include "gencase/region.hpp"

namespace thalweg::gencase {

/// Finds the nearest point of a set's skin from its surfaces. That point lies on one surface (a face), on the
/// intersection of two (an edge) or of three (a corner). Each candidate is the foot of the perpendicular from the given
/// point; it lies on the skin if points around it are partly inside and partly outside of the set. So the edges of
/// unions and differences need not be constructed.
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
