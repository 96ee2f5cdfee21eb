#include "common/extraction/sampling_grid.hpp"

#include <algorithm>
#include <cmath>

namespace thalweg {
namespace {

long node_below(double coordinate, double step) { return std::lround(std::floor(coordinate / step)); }
std::size_t nodes_between(long first, double to, double step) {
  return static_cast<std::size_t>(std::max(0L, std::lround(std::ceil(to / step)) - first + 1));
}

}  // namespace

SamplingGrid make_slice_grid(double step, double x_from, double x_to, double z_from, double z_to, double y) {
  SamplingGrid grid = make_volume_grid(step, {x_from, y, z_from}, {x_to, y, z_to});
  grid.ny = 1;
  grid.plane_y = y;
  return grid;
}

SamplingGrid make_volume_grid(double step, const Vec3& from, const Vec3& to) {
  SamplingGrid grid;
  grid.step = step;
  grid.first_x = node_below(from.x(), step);
  grid.first_y = node_below(from.y(), step);
  grid.first_z = node_below(from.z(), step);
  grid.nx = nodes_between(grid.first_x, to.x(), step);
  grid.ny = nodes_between(grid.first_y, to.y(), step);
  grid.nz = nodes_between(grid.first_z, to.z(), step);
  return grid;
}

}  // namespace thalweg
