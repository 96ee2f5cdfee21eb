#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "case/case.hpp"

namespace thalweg {

/// A wall whose outline seen from above is known: a box, or a prism along z.
struct BodyInPlan {
  const Shape* shape;
  std::vector<Eigen::Vector2d> outline;  // [m] x, y
  Vec3 from;                             // [m] corners of the box around it
  Vec3 to;

  /// Lowest and highest place [m] across at a place along an axis (0: x, 1: y), if the body is there.
  [[nodiscard]] std::optional<std::pair<double, double>> at(int along, double place) const;
};

/// The outline of a shape; none of other kinds and of prisms that lie.
std::optional<BodyInPlan> body_in_plan(const Shape& shape);

}  // namespace thalweg
