#include "common/extraction/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thalweg {
namespace {

// Height of a phase's body over a column's floor; the floor itself where the body is less than a layer. Where that floor
// hangs in the fluid, a pipe over a bed, it is the height of the body below.
double top_or_floor(const ConnectedBody& body, std::size_t column, double floor, double least_thickness) {
  const double top = body.top(column);
  if (!std::isnan(top) && (std::isnan(floor) || top - floor >= least_thickness)) return top;
  const double below = body.top_below_walls(column);
  return below < floor - least_thickness ? below : floor;
}

}  // namespace

Bodies::Bodies(const VolumeFractions& sums, const ClassifiedParticles& set, double gap)
    : least_thickness(least_layer * set.particles.info.spacing),
      fluid(sums, sums.fluid, gap, least_sheet * set.particles.info.spacing),
      spacing_(set.particles.info.spacing) {
  if (set.has_sediment) sediment.emplace(sums, sums.sediment);
  if (set.rest_is_known) resting.emplace(sums, sums.resting);
  for (std::size_t column = 0; column < sums.grid.columns(); ++column) {
    const double x = sums.grid.x(column / sums.grid.ny);
    const double y = sums.grid.y(column % sums.grid.ny);
    dry_floor_.push_back(set.walls.floor(x, y));
    std::vector<double> moving = set.walls.moving_tops(x, y);
    if (!moving.empty()) moving_tops_.emplace(column, std::move(moving));
  }
}

bool Bodies::lies_on_moving_wall(std::size_t column, double height) const {
  const auto found = moving_tops_.find(column);
  return found != moving_tops_.end() && std::any_of(found->second.begin(), found->second.end(),
                                                    [&](double top) { return std::abs(top - height) <= spacing_; });
}

ColumnLevels Bodies::levels(std::size_t column) const {
  const double surface = fluid.top(column);
  const double floor = std::isnan(surface) ? dry_floor_[column] : fluid.base(column);
  if (!(surface - floor >= least_thickness)) return {absent, absent, absent, floor};
  if (lies_on_moving_wall(column, floor)) return {surface, absent, absent, floor};
  // Kernel sums of a part never exceed those of the whole, but rounding at a bare floor may.
  const double bed = sediment ? std::min(top_or_floor(*sediment, column, floor, least_thickness), surface) : floor;
  const double motionless = resting ? std::min(top_or_floor(*resting, column, floor, least_thickness), bed) : absent;
  return {surface, bed, motionless, floor};
}

}  // namespace thalweg
