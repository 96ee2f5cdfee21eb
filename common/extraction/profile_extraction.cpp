#include "common/extraction/profile_extraction.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/extraction/bodies.hpp"
#include "common/extraction/volume_fraction.hpp"

namespace thalweg {
namespace {

// The plane's grid: over the settings' range, narrowed to the particles, with the kernel's reach around the fluid.
std::optional<SamplingGrid> grid_around(const ClassifiedParticles& set, const ExtractionSettings& settings) {
  const ParticleSet& particles = set.particles;
  const double spacing = particles.info.spacing;
  const double reach = 2 * particles.info.smoothing_length + spacing;
  const double infinite = std::numeric_limits<double>::infinity();
  Vec3 low = Vec3::Constant(infinite);
  Vec3 high = Vec3::Constant(-infinite);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Vec3& at = particles.position[i];
    low = low.cwiseMin(at);
    high.x() = std::max(high.x(), at.x());  // columns without fluid inside the walls are part of the profile
    if (is_fluid(particles.type[i])) high.z() = std::max(high.z(), at.z());
  }
  if (!std::isfinite(high.z())) return std::nullopt;
  double x_from = std::max(low.x() - spacing, settings.x_from);
  double x_to = std::min(high.x() + spacing, settings.x_to);
  if (settings.narrow_to_walls) {
    x_from = std::max(x_from, set.walls.open_from);
    x_to = std::min(x_to, set.walls.open_to);
  }
  const double z_from = std::max(low.z() - reach, settings.z_from);
  const double z_to = std::min(high.z() + reach, settings.z_to);
  if (x_from > x_to || z_from > z_to) return std::nullopt;
  return make_slice_grid(spacing / 2, x_from, x_to, z_from, z_to, settings.plane_y);
}

}  // namespace

ExtractedProfile extract_profile(const ParticleSet& particles, const ExtractionSettings& settings) {
  return extract_profile(ClassifiedParticles(particles, settings.rest_speed), settings);
}

ExtractedProfile extract_profile(const ClassifiedParticles& set, const ExtractionSettings& settings) {
  ExtractedProfile result;
  const std::optional<SamplingGrid> found = grid_around(set, settings);
  if (!found) return result;
  const SamplingGrid& grid = *found;
  const VolumeFractions sums = sum_volume_fractions(set, grid);
  const Bodies bodies(sums, set, settings.gap);

  Profile& profile = result.profile;
  for (std::size_t i = grid.first_x % 2 == 0 ? 0 : 1; i < grid.nx; i += 2) {  // every second node: multiples of dp
    const ColumnLevels levels = bodies.levels(i);
    profile.x.push_back(grid.x(i));
    profile.free_surface.push_back(levels.free_surface);
    profile.floor.push_back(levels.floor);
    if (set.has_sediment) profile.bed.push_back(levels.bed);
    if (set.rest_is_known) profile.moving_bed.push_back(levels.motionless_bed);
  }
  result.front = water_front(profile, bodies.least_thickness);
  return result;
}

double water_front(const Profile& profile, double least_depth, MissingColumn missing) {
  if (profile.free_surface.empty() || (profile.bed.empty() && profile.floor.empty())) return Profile::missing;
  const auto depth = [&](std::size_t i) {
    const bool on_bed = !profile.bed.empty() && !std::isnan(profile.bed[i]);
    const double ground = on_bed ? profile.bed[i] : profile.floor.empty() ? Profile::missing : profile.floor[i];
    return profile.free_surface[i] - ground;
  };
  for (std::size_t i = profile.x.size(); i-- > 0;) {
    if (!(depth(i) > least_depth)) continue;
    const bool last = i + 1 == profile.x.size();
    const bool next_is_unknown = last || std::isnan(depth(i + 1));
    if (next_is_unknown && missing == MissingColumn::unknown) return Profile::missing;
    if (last) return profile.x[i];
    const double next = next_is_unknown ? 0 : depth(i + 1);
    const double share = (depth(i) - least_depth) / (depth(i) - next);
    return profile.x[i] + share * (profile.x[i + 1] - profile.x[i]);
  }
  return Profile::missing;
}

}  // namespace thalweg
