#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "common/particles.hpp"
#include "postproc/profile_set.hpp"

namespace thalweg {

/// Okabe & Ito (2008): distinguishable with any common colour-vision deficiency. In the order of `curves`.
inline constexpr std::array<const char*, 3> curve_colours{"#0072b2", "#d55e00", "#1a1a1a"};

/// How the line of a source is broken, as "10,5": the run's is whole (empty), meshes' are dashed, the second one's
/// dotted, other sources' dash-dotted. Measurements are markers (empty).
std::string dashes_of_source(const std::vector<ProfileSet>& sets, std::size_t s);

/// Where the axes of a profile picture lie, in shares of its width and height from the lower left.
struct PlotArea {
  int width = 1000;  // [pixels] of the picture
  int height = 280;
  double left = 0.07;
  double right = 0.985;
  double bottom = 0.21;
  double top = 0.87;
};
inline constexpr PlotArea profile_area;

/// The part of the plane all profile pictures of a report show [m].
struct PictureFrame {
  double x_from = 0;
  double x_to = 1;
  double z_from = 0;
  double z_to = 1;

  /// The same with `margin` [m] more on every side.
  [[nodiscard]] PictureFrame widened(double margin) const {
    return {x_from - margin, x_to + margin, z_from - margin, z_to + margin};
  }

  /// How much taller than long a square looks in a profile picture, from the size of its plot.
  [[nodiscard]] double exaggeration() const {
    const PlotArea& area = profile_area;
    return (x_to - x_from) / (z_to - z_from) * (area.top - area.bottom) * area.height /
           ((area.right - area.left) * area.width);
  }
};

/// The frame that holds all curves of all sets, with a margin above; x from .. to where `to` is larger.
PictureFrame frame_around(const std::vector<ProfileSet>& sets, double from, double to);

/// A folder name made of a label: "OpenFOAM 10 mm" → "openfoam_10_mm".
std::string folder_name_of(const std::string& label);

/// A table of particles to draw: x, z [m], kind (0 water, 1 sediment without state, 2 deposit, 3 bed load, 4 suspended,
/// 5 wall), speed [m/s] and pressure [Pa].
struct ParticleTable {
  std::filesystem::path file;
  std::vector<std::size_t> kinds;  // that occur
  double fastest = 0;              // [m/s]
  double highest_pressure = 0;     // [Pa]
};

/// Writes gnuplot scripts into one folder; each draws NAME.svg and NAME.png beside itself, from CSV files named by
/// relative paths. How a curve looks: its colour says which curve it is (Okabe and Ito's colours, safe for colour-blind
/// readers), its dash or marker says where it comes from. Every function returns the script's path and throws RunError.
class FigureWriter {
 public:
  explicit FigureWriter(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Curves of all sets at `time`; set s has its profiles in data_folders[s], as write_profile writes them.
  [[nodiscard]] std::filesystem::path profiles(double time, const std::vector<ProfileSet>& sets,
                                               const std::vector<std::filesystem::path>& data_folders,
                                               const PictureFrame& frame) const;

  /// Water front against time: the run's own series `front` and a table `fronts` with a column "LABEL [m]" per set.
  [[nodiscard]] std::filesystem::path front(const std::filesystem::path& front, const std::filesystem::path& fronts,
                                            const std::vector<ProfileSet>& sets) const;

  /// Kinetic energy, change of potential and internal energy, and their sum, from history.csv.
  [[nodiscard]] std::filesystem::path energies(const std::filesystem::path& history, bool has_internal,
                                               const std::string& unit) const;

  /// Particles by what they are, how fast they are and their pressure, without exaggeration (PNG only).
  [[nodiscard]] std::filesystem::path particles(const ParticleTable& table, const PictureFrame& frame,
                                                double spacing) const;

  /// Particles by what they are, without exaggeration (PNG only).
  [[nodiscard]] std::filesystem::path scene(const ParticleTable& table, const PictureFrame& frame,
                                            double spacing) const;

  /// The bed's change of level over place and time from the table of a BedHistory, and the water's `front` over it (PNG
  /// only); `largest` [m] ends the colours.
  [[nodiscard]] std::filesystem::path space_time(const std::filesystem::path& table, const std::filesystem::path& front,
                                                 const PictureFrame& frame, double spacing, double largest) const;

  /// Any other picture: `settings`, then the command `plot`, which draws data(file).
  [[nodiscard]] std::filesystem::path write(const std::string& name, int width, int height, const std::string& settings,
                                            const std::string& plot) const;
  /// A CSV file as a script names it: quoted, relative to the script's folder.
  [[nodiscard]] std::string data(const std::filesystem::path& file) const;

 private:
  std::filesystem::path folder_;
};

/// Writes the water and sediment (and walls) within half a spacing of the plane y, at most `limit` of them (every
/// n-th). Throws RunError.
ParticleTable write_particle_table(const std::filesystem::path& file, const ParticleSet& particles, double plane_y,
                                   std::size_t limit, bool with_walls = false);

}  // namespace thalweg
