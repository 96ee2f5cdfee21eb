#include "postproc/volume_fraction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thalweg {
namespace {

// The range of grid indices within `reach` of a coordinate, clipped to the grid.
struct IndexRange {
  std::size_t begin;
  std::size_t end;
};
IndexRange indices_within(double coordinate, double reach, double step, long first, std::size_t count) {
  const auto clip = [&](double index) {
    return static_cast<std::size_t>(std::clamp(index - static_cast<double>(first), 0.0, static_cast<double>(count)));
  };
  return {clip(std::ceil((coordinate - reach) / step)), clip(std::floor((coordinate + reach) / step) + 1)};
}

}  // namespace

SliceGrid make_slice_grid(double step, double x_from, double x_to, double z_from, double z_to, double y) {
  SliceGrid grid;
  grid.step = step;
  grid.first_x = std::lround(std::floor(x_from / step));
  grid.first_z = std::lround(std::floor(z_from / step));
  grid.nx = static_cast<std::size_t>(std::max(0L, std::lround(std::ceil(x_to / step)) - grid.first_x + 1));
  grid.nz = static_cast<std::size_t>(std::max(0L, std::lround(std::ceil(z_to / step)) - grid.first_z + 1));
  grid.y = y;
  return grid;
}

WendlandC2::WendlandC2(double smoothing_length, int dimension)
    : h(smoothing_length),
      sigma(dimension == 2 ? 7 / (4 * std::numbers::pi * h * h) : 21 / (16 * std::numbers::pi * h * h * h)) {}

double WendlandC2::operator()(double distance_squared) const {
  const double q = std::sqrt(distance_squared) / h;
  const double s = std::max(0.0, 1 - q / 2);
  return sigma * s * s * s * s * (2 * q + 1);
}

double VolumeFractions::open_share(std::size_t node) const {
  constexpr double least = 0.25;  // reached only inside walls, where nothing is evaluated
  return std::max(1 - side[node], least);
}

double VolumeFractions::with_walls(const std::vector<double>& phase, std::size_t node) const {
  return (phase[node] + floor[node]) / open_share(node);
}

VolumeFractions sum_volume_fractions(const ParticleSet& particles, const WallRuns& walls, const SliceGrid& grid,
                                     const std::function<bool(std::size_t)>& at_rest) {
  VolumeFractions sums;
  sums.grid = grid;
  for (auto* field : {&sums.fluid, &sums.sediment, &sums.resting, &sums.floor, &sums.side}) {
    field->assign(grid.size(), 0);
  }

  const int dimension = particles.info.dimension;
  const double spacing = particles.info.spacing;
  const WendlandC2 kernel(particles.info.smoothing_length, dimension);
  const double reach = kernel.support();
  const double lattice_volume = dimension == 2 ? spacing * spacing : spacing * spacing * spacing;
  const bool has_volumes = !particles.mass.empty() && !particles.density.empty();

  for (std::size_t b = 0; b < particles.size(); ++b) {
    const Vec3& at = particles.position[b];
    const double out_of_plane = dimension == 2 ? 0 : at.y() - grid.y;
    const double reach_in_plane_squared = reach * reach - out_of_plane * out_of_plane;
    if (reach_in_plane_squared <= 0) continue;
    const double reach_in_plane = std::sqrt(reach_in_plane_squared);
    const IndexRange columns = indices_within(at.x(), reach_in_plane, grid.step, grid.first_x, grid.nx);
    const IndexRange rows = indices_within(at.z(), reach_in_plane, grid.step, grid.first_z, grid.nz);

    const bool wall = is_wall(particles.type[b]);
    const bool sediment = particles.type[b] == ParticleType::sediment;
    const bool resting = sediment && at_rest(b);
    // The volume of a wall particle is its lattice cell: mass and density of dummy particles mean something else.
    const double volume = !wall && has_volumes && particles.density[b] > 0
                              ? static_cast<double>(particles.mass[b]) / static_cast<double>(particles.density[b])
                              : lattice_volume;

    for (std::size_t i = columns.begin; i < columns.end; ++i) {
      const double dx = grid.x(i) - at.x();
      for (std::size_t k = rows.begin; k < rows.end; ++k) {
        const double dz = grid.z(k) - at.z();
        const double share = volume * kernel(dx * dx + dz * dz + out_of_plane * out_of_plane);
        const std::size_t node = grid.node(i, k);
        if (wall) {
          (walls.top[b] <= grid.z(k) + spacing ? sums.floor : sums.side)[node] += share;
          continue;
        }
        sums.fluid[node] += share;
        if (sediment) sums.sediment[node] += share;
        if (resting) sums.resting[node] += share;
      }
    }
  }
  return sums;
}

}  // namespace thalweg
