#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/particles.hpp"
#include "postproc/profile_set.hpp"

namespace thalweg {

/// The part of the plane all profile pictures of a report show [m].
struct PictureFrame {
  double x_from = 0;
  double x_to = 1;
  double z_from = 0;
  double z_to = 1;

  /// How much taller than long a square looks in a profile picture, from the size of its plot.
  [[nodiscard]] double exaggeration() const { return (x_to - x_from) / (z_to - z_from) * 185 / 900; }
};

/// The frame that holds all curves of all sets, with a margin above; x from .. to where `to` is larger.
PictureFrame frame_around(const std::vector<ProfileSet>& sets, double from, double to);

/// A folder name made of a label: "OpenFOAM 10 mm" → "openfoam_10_mm".
std::string folder_name_of(const std::string& label);

/// A table of particles to draw: x, z [m], kind (0 water, 1 sediment without state, 2 deposit, 3 bed load, 4 suspended)
/// and speed [m/s].
struct ParticleTable {
  std::filesystem::path file;
  std::vector<std::size_t> kinds;  // that occur
  double fastest = 0;              // [m/s]
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

  /// Particles by what they are and by how fast they are, without exaggeration (PNG only).
  [[nodiscard]] std::filesystem::path particles(const ParticleTable& table, const PictureFrame& frame,
                                                double spacing) const;

  /// A CSV file as a script in this folder names it, in quotes.
  [[nodiscard]] std::string data(const std::filesystem::path& file) const;
  /// A picture of any kind: NAME.gp of settings and a plot command, width and height in pixels.
  [[nodiscard]] std::filesystem::path write(const std::string& name, int width, int height, const std::string& settings,
                                            const std::string& plot) const;

 private:
  std::filesystem::path folder_;
};

/// Writes the water and sediment within half a spacing of the plane y, at most `limit` of them (every n-th).
/// Throws RunError.
ParticleTable write_particle_table(const std::filesystem::path& file, const ParticleSet& particles, double plane_y,
                                   std::size_t limit);

}  // namespace thalweg
