#include "postproc/profile_extraction.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/error.hpp"
#include "postproc/connected_body.hpp"
#include "postproc/volume_fraction.hpp"
#include "postproc/wall_runs.hpp"

namespace thalweg {
namespace {

// The plane's grid: over the settings' range, narrowed to the particles, with the kernel's reach around the fluid.
std::optional<SliceGrid> grid_around(const ParticleSet& particles, const ExtractionSettings& settings,
                                     const WallRuns& walls) {
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
  const double x_from = std::max({low.x() - spacing, settings.x_from, walls.open_from});
  const double x_to = std::min({high.x() + spacing, settings.x_to, walls.open_to});
  const double z_from = std::max(low.z() - reach, settings.z_from);
  const double z_to = std::min(high.z() + reach, settings.z_to);
  if (x_from > x_to || z_from > z_to) return std::nullopt;
  return make_slice_grid(spacing / 2, x_from, x_to, z_from, z_to, settings.plane_y);
}

bool is_slow(const ParticleSet& particles, std::size_t i, double speed) { return particles.velocity[i].norm() < speed; }

// Height of a phase's body over a column's floor; the floor itself where the body is less than a layer.
double top_or_floor(const ConnectedBody& body, std::size_t column, double floor, double least_thickness) {
  const double top = body.top(column);
  return std::isnan(top) || (!std::isnan(floor) && top - floor < least_thickness) ? floor : top;
}

}  // namespace

bool has_sediment_states(const ParticleSet& particles) {
  for (std::size_t i = 0; i < particles.state.size(); ++i) {
    if (particles.type[i] == ParticleType::sediment && particles.state[i] != SedimentState::none) return true;
  }
  return false;
}

ExtractedProfile extract_profile(const ParticleSet& particles, const ExtractionSettings& settings) {
  const double spacing = particles.info.spacing;
  if (!(spacing > 0) || !(particles.info.smoothing_length > 0)) {
    throw InputError("the particle file does not say its spacing and smoothing length; write it with thalweg-solver");
  }
  ExtractedProfile result;
  const bool has_sediment = count_by_type(particles)[static_cast<std::size_t>(ParticleType::sediment)] > 0;
  const bool states = has_sediment_states(particles);
  const bool knows_rest = has_sediment && (states || !particles.velocity.empty());

  const WallRuns walls = find_wall_runs(particles, spacing);
  const std::optional<SliceGrid> found = grid_around(particles, settings, walls);
  if (!found) return result;
  const SliceGrid& grid = *found;
  const VolumeFractions sums = sum_volume_fractions(particles, walls, grid, [&](std::size_t i) {
    if (states && particles.state[i] != SedimentState::deposit) return false;
    if (particles.velocity.empty()) return states;
    return is_slow(particles, i, settings.rest_speed);
  });
  const ConnectedBody fluid(sums, sums.fluid);
  const std::optional<ConnectedBody> sediment =
      has_sediment ? std::make_optional<ConnectedBody>(sums, sums.sediment) : std::nullopt;
  const std::optional<ConnectedBody> resting =
      knows_rest ? std::make_optional<ConnectedBody>(sums, sums.resting) : std::nullopt;

  const double least_thickness = least_layer * spacing;
  Profile& profile = result.profile;
  for (std::size_t i = grid.first_x % 2 == 0 ? 0 : 1; i < grid.nx; i += 2) {  // every second node: multiples of dp
    const double surface = fluid.top(i);
    const double floor = fluid.base(i);
    const bool empty = !(surface - floor >= least_thickness);
    profile.x.push_back(grid.x(i));
    profile.free_surface.push_back(empty ? Profile::missing : surface);
    result.floor.push_back(floor);
    // Kernel sums of a part never exceed those of the whole, but rounding at a bare floor may.
    const double bed = has_sediment ? std::min(top_or_floor(*sediment, i, floor, least_thickness), surface) : floor;
    if (has_sediment) profile.bed.push_back(empty ? Profile::missing : bed);
    if (!knows_rest) continue;
    const double moving = std::min(top_or_floor(*resting, i, floor, least_thickness), bed);
    profile.moving_bed.push_back(empty ? Profile::missing : moving);
  }
  result.front = water_front(profile, result.floor, least_thickness);
  return result;
}

double water_front(const Profile& profile, const std::vector<double>& floor, double least_depth,
                   MissingColumn missing) {
  const std::vector<double>& ground = profile.bed.empty() ? floor : profile.bed;
  if (profile.free_surface.empty() || ground.size() != profile.x.size()) return Profile::missing;
  const auto depth = [&](std::size_t i) { return profile.free_surface[i] - ground[i]; };
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
