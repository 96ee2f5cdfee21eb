#pragma once

#include <limits>
#include <string>
#include <vector>

#include "common/extraction/bodies.hpp"
#include "common/particles.hpp"
#include "common/profile.hpp"

namespace thalweg {

/// The range and the method of profiles. The x grid has the particles' spacing dp and lies at multiples of it.
struct ExtractionSettings {
  double x_from = -std::numeric_limits<double>::infinity();  // [m] narrowed to where the walls leave room for a flow
  double x_to = std::numeric_limits<double>::infinity();     // [m]
  double y_from = -std::numeric_limits<double>::infinity();  // [m] 3-D: of surfaces, which are looked for over an area
  double y_to = std::numeric_limits<double>::infinity();     // [m]
  double z_from = -std::numeric_limits<double>::infinity();  // [m] nothing outside is looked at
  double z_to = std::numeric_limits<double>::infinity();     // [m]
  double plane_y = 0;                                        // [m] 3-D: the plane of the profile
  double gap = 0;                                            // [m] of air under a sheet of water that is bridged
  bool narrow_to_walls = true;  // false: particles around a place, whose walls do not show where the flow ends
  double rest_speed = 0.01;     // [m/s] slower sediment rests; where there is State, deposits only
};

/// A profile and the water's front.
struct ExtractedProfile {
  Profile profile;  // without sediment in the set, `bed` and `moving_bed` are empty
  double front = std::numeric_limits<double>::quiet_NaN();  // [m] water_front of the profile
};

/// Free surface, bed and moving bed of a particle set.
///
/// The volume fraction of a phase is a kernel sum over its particles (VolumeFractions) on a grid of dp/2; a surface is
/// where it crosses 1/2. Of the nodes above 1/2 only those count that are connected to the floor (neighbours along x
/// or z): a drop in the air or a floating grain moves nothing. In a column the surface is the highest crossing of that
/// body, so an overhanging wave shows its crest and the air under it is passed over. With settings.gap a sheet of fluid
/// that rides over no more than that much air counts too.
///
/// free_surface: water and sediment together, so it is the bed where the bed is dry. bed: sediment alone. moving_bed:
/// sediment at rest, which is State deposit where the set has states, and |u| < rest_speed otherwise. Where water
/// stands on a floor bare of sediment (or nothing rests), bed (or moving_bed) is the floor; on a wall that moves there
/// is none. Below a wall that hangs in the fluid the bed is the sediment's, if there is fluid between. floor: the wall
/// under the fluid. Columns with less than least_layer * dp of anything are NaN but for the
/// floor. A set without walls has no floor: its largest body counts.
///
/// Needs Type and positions, spacing and smoothing length in `particles.info`; without mass and density every particle
/// has the volume of its lattice cell; without State and Velocity there is no moving bed. Throws InputError when
/// spacing or smoothing length are missing.
ExtractedProfile extract_profile(const ParticleSet& particles, const ExtractionSettings& settings);
/// The same of a set that has been classified with `settings.rest_speed`.
ExtractedProfile extract_profile(const ClassifiedParticles& set, const ExtractionSettings& settings);

/// The meaning of a column without a value for the water there.
enum class MissingColumn {
  dry,     // of a model, which knows all columns
  unknown  // of a measurement, which ends somewhere
};

/// Tip of the water: the largest x at which water is deeper than `least_depth` [m], interpolated between columns.
/// Water is what lies between `bed` (or, where there is none, `floor`) and `free_surface`. NaN without water, and where
/// the column behind the last wet one is not known to be dry.
double water_front(const Profile& profile, double least_depth, MissingColumn missing = MissingColumn::dry);

}  // namespace thalweg
