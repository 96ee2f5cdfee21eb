#pragma once

#include <filesystem>
#include <vector>

#include "case/case.hpp"
#include "common/io/series.hpp"

namespace thalweg {

/// The water's velocity over the depth at one place of a current, a mean over time.
struct VelocityStation {
  double place = 0;              // [m] along the flow: x, or y
  double ground = 0;             // [m] z of the lowest water
  double depth = 0;              // [m]
  double mean_velocity = 0;      // [m/s] along the flow
  double friction_velocity = 0;  // [m/s] of the logarithmic law with this mean velocity and depth
  double deviation = 0;          // root of the mean square of velocity minus law, over the mean velocity [-]
  std::vector<double> height;    // [m] over the ground, middles of rows one spacing high
  std::vector<double> velocity;  // [m/s]
  std::vector<double> law;       // [m/s]
};

/// Velocity profiles at three places along a current that lasts: at a quarter, half and three quarters of the way from
/// the first inlet to the first outlet, or of the extent of the water. They are means over the snapshots of the last half
/// of the run, of twenty of them at the most; in space over all of the width. Rows that water fills in less than half of
/// the snapshots are left out. None without such a current, and in places without water. A snapshot that
/// cannot be read is passed over.
std::vector<VelocityStation> velocity_stations(const Case& of, const std::vector<SeriesEntry>& snapshots);

/// Writes them as a table: place [m], height [m], velocity [m/s], law [m/s].
void write_velocity_stations(const std::filesystem::path& file, const std::vector<VelocityStation>& stations);

/// Reads the stations that a mesh model has written (foam/MODEL/stations.csv): that table with the station's ground [m],
/// depth [m], mean_velocity [m/s] and friction_velocity [m/s] in each row. None if there is no such file. Throws
/// InputError.
std::vector<VelocityStation> read_velocity_stations(const std::filesystem::path& file);

}  // namespace thalweg
