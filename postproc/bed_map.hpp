#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "common/particles.hpp"
#include "postproc/level_map.hpp"

namespace thalweg {

/// The kind of a place of a BedMap: a bed; a floor without sediment, or nothing; a wall around the flow; a body in it.
enum class Ground : std::uint8_t { bed, bare, wall, body };

/// A bed seen from above, before and after a run: heights at the places of a regular grid, a single row of them in 2-D.
/// Values are NaN where there is no bed.
struct BedMap {
  double step = 0;  // [m]
  double x0 = 0;    // [m] of place (0, 0)
  double y0 = 0;    // [m]
  std::size_t nx = 0;
  std::size_t ny = 1;
  bool in_columns = false;      // a place is a column of a bed that is a surface, and not a point of a contoured one
  double time = 0;              // [s] of the second heights
  std::vector<double> before;   // [m] at index(i, j)
  std::vector<double> now;      // [m]
  std::vector<double> water;    // [m] free surface at `time`
  std::vector<double> shields;  // [-] Shields number at `time`; empty where the run's files carry none
  std::vector<Ground> ground;

  [[nodiscard]] std::size_t index(std::size_t i, std::size_t j) const { return i * ny + j; }
  [[nodiscard]] std::size_t size() const { return nx * ny; }
  [[nodiscard]] double x(std::size_t i) const { return x0 + step * static_cast<double>(i); }
  [[nodiscard]] double y(std::size_t j) const { return y0 + step * static_cast<double>(j); }
  [[nodiscard]] double change(std::size_t k) const { return now[k] - before[k]; }
  [[nodiscard]] bool has_bed() const;
};

/// Extremes and volumes of a bed's change. Volumes are per metre of width in 2-D [m^2].
struct BedExtremes {
  double scour = 0;  // [m] >= 0
  std::array<std::size_t, 2> scour_at{};
  double deposition = 0;  // [m] >= 0
  std::array<std::size_t, 2> deposition_at{};
  double eroded = 0;     // [m^3]
  double deposited = 0;  // [m^3]
};
BedExtremes extremes_of(const BedMap& map);

/// The map of two sets of contoured heights, at the nodes of the second.
BedMap map_of_levels(const LevelMap& before, const LevelMap& now);
/// The map of a bed that is a surface: its columns end half a spacing above their highest particle.
BedMap map_of_columns(const ParticleSet& before, const ParticleSet& now);

/// Says where walls and bodies stand: places without bed and water that hold wall particles within the heights of the
/// fluid; bodies lie within the fluid's extent, walls around it.
void add_ground(BedMap& map, const ParticleSet& particles);

/// Adds Shields numbers: the mean ShieldsNumber of the grains that have one within a spacing of a place or, of a bed that is a surface,
/// BedShear [Pa] over `grain_weight` [Pa]. Leaves the map without where the set has neither array.
void add_shields(BedMap& map, const ParticleSet& particles, double grain_weight);

/// A line of equal change of the bed [m].
struct Contour {
  double level = 0;
  std::vector<std::array<double, 2>> points;  // [m] x and y
};
/// Lines at `levels` of `values` at the places of the map. VTK contours the cells whose four corners have values. Empty in
/// 2-D.
std::vector<Contour> contours_of(const BedMap& map, const std::vector<double>& values,
                                 const std::vector<double>& levels);
/// The multiples of `step` but zero between the least and the largest value.
std::vector<double> contour_levels(const std::vector<double>& values, double step);

/// Writes x [m], y [m], before [m], now [m], change [m], shields [-], shear [Pa], ground [-], a row a place.
void write_bed_map(const std::filesystem::path& file, const BedMap& map, double grain_weight);
/// Writes the bed as it is now as a survey that gencase reads (kind = "bathymetry"): x [m], y [m], z [m], in 2-D x [m],
/// z [m]. Half a step around the bed its outermost heights go on, so that the survey reaches the bed's ends; points outside
/// of `low` to `high` are left out.
void write_bed_survey(const std::filesystem::path& file, const BedMap& map, const Vec3& low, const Vec3& high);
/// Writes level [m], x [m], y [m]; lines are parted by empty lines.
void write_contours(const std::filesystem::path& file, const std::vector<Contour>& contours);

}  // namespace thalweg
