#include "postproc/surface_field.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace thalweg {
namespace {

// Around the fluid, with the kernel's reach, and no further than the settings say.
std::optional<SamplingGrid> grid_around_fluid(const ParticleSet& particles, const ExtractionSettings& settings) {
  const double infinite = std::numeric_limits<double>::infinity();
  Vec3 low = Vec3::Constant(infinite);
  Vec3 high = -low;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (!is_fluid(particles.type[i])) continue;
    low = low.cwiseMin(particles.position[i]);
    high = high.cwiseMax(particles.position[i]);
  }
  const Vec3 reach = Vec3::Constant(2 * particles.info.smoothing_length + particles.info.spacing);
  low = (low - reach).cwiseMax(Vec3(settings.x_from, settings.y_from, settings.z_from));
  high = (high + reach).cwiseMin(Vec3(settings.x_to, settings.y_to, settings.z_to));
  if (!((high - low).minCoeff() > 0)) return std::nullopt;
  if (particles.info.dimension == 3) return make_volume_grid(particles.info.spacing, low, high);
  return make_slice_grid(particles.info.spacing / 2, low.x(), high.x(), low.z(), high.z(), 0);
}

}  // namespace

std::unique_ptr<SurfaceField> make_surface_field(const ClassifiedParticles& set, const CellList& cells,
                                                 const ExtractionSettings& settings) {
  const std::optional<SamplingGrid> grid = grid_around_fluid(set.particles, settings);
  if (!grid) return nullptr;
  VolumeFractions sums(*grid);
  // Slabs of columns share no node; the particles at their faces are summed by both neighbours.
  constexpr std::size_t thickness = 16;
  const std::size_t slabs = (grid->nx + thickness - 1) / thickness;
  const double reach = 2 * set.particles.info.smoothing_length;
  tbb::parallel_for(std::size_t{0}, slabs, [&](std::size_t slab) {
    const std::size_t first = slab * thickness;
    const std::size_t last = std::min(first + thickness, grid->nx);
    add_volume_fractions(sums, set, cells.slab(grid->x(first) - reach, grid->x(last) + reach), first, last);
  });
  return std::make_unique<SurfaceField>(std::move(sums), set);
}

LevelMap level_map(const SurfaceField& field) {
  LevelMap map{field.sums.grid, {}};
  map.levels.resize(map.grid.columns());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, map.levels.size()), [&](const auto& range) {
    for (std::size_t column = range.begin(); column < range.end(); ++column) {
      map.levels[column] = field.bodies.levels(column);
    }
  });
  return map;
}

}  // namespace thalweg
