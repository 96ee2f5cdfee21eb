#include "common/app/scour/body_in_plan.hpp"

#include <algorithm>
#include <cmath>

namespace thalweg {

std::optional<std::pair<double, double>> BodyInPlan::at(int along, double place) const {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
    if (place < std::min(a[along], b[along]) || place > std::max(a[along], b[along])) continue;
    const double way = b[along] - a[along];
    for (const double share : way == 0 ? std::vector<double>{0, 1} : std::vector<double>{(place - a[along]) / way}) {
      const double across = a[1 - along] + share * (b[1 - along] - a[1 - along]);
      low = std::min(low, across);
      high = std::max(high, across);
    }
  }
  if (low > high) return std::nullopt;
  return std::pair{low, high};
}

std::optional<BodyInPlan> body_in_plan(const Shape& shape) {
  BodyInPlan body{&shape, {}, shape.from, shape.to};
  if (shape.kind == ShapeKind::box) {
    const Eigen::Vector2d a = shape.from.head<2>();
    const Eigen::Vector2d b = shape.to.head<2>();
    body.outline = {a, {b.x(), a.y()}, b, {a.x(), b.y()}};
    return body;
  }
  if (shape.kind != ShapeKind::prism || shape.axis != Axis::z || shape.extent.size() != 2) return std::nullopt;
  body.outline = shape.polygon;
  Eigen::Vector2d low = shape.polygon.front();
  Eigen::Vector2d high = low;
  for (const Eigen::Vector2d& corner : shape.polygon) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  body.from = {low.x(), low.y(), shape.extent[0]};
  body.to = {high.x(), high.y(), shape.extent[1]};
  return body;
}

}  // namespace thalweg
