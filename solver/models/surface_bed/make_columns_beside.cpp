#include "solver/models/surface_bed/make_columns_beside.hpp"

#include <cmath>

namespace thalweg {

int axis_of(const Opening& opening) {
  const Vec3 flow = opening.axes().flow;
  const int axis = std::abs(flow.x()) > std::abs(flow.y()) ? 0 : 1;
  return std::abs(flow[axis]) < 0.9 ? -1 : axis;
}

std::vector<int> columns_beside(const Opening& opening, const Case& of, const BedGrid& grid, const double (&first)[2],
                                double from, double to) {
  std::vector<int> found;
  if (axis_of(opening) < 0) return found;
  const OpeningAxes axes = opening.axes();
  const bool in_space = of.info.dimension == 3;
  for (int c = 0; c < grid.columns(); ++c) {
    const int row = c / grid.nx;
    const double x = first[0] + grid.dx * (c % grid.nx);
    const double y = in_space ? first[1] + grid.dy * row : 0;
    const Vec3 way = Vec3(x, y, 0) - opening.at;
    const double along = way.dot(axes.flow);
    const bool in_width = !in_space || std::abs(way.dot(axes.across)) < 0.5 * opening.extent_across(3);
    if (in_width && along >= from && along < to) found.push_back(c);
  }
  return found;
}

}  // namespace thalweg
