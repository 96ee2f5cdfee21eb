#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "postproc/figures/particle_table.hpp"
#include "postproc/figures/picture_frame.hpp"
#include "postproc/figures/source_look.hpp"
#include "postproc/opening_records.hpp"
#include "postproc/report_units.hpp"
#include "postproc/velocity_stations.hpp"

namespace thalweg {

/// Velocity profiles of a mesh model, and the table that holds them.
struct MeshStations {
  std::string label;
  std::filesystem::path table;
  std::vector<VelocityStation> stations;
};

/// Writes gnuplot scripts into one folder. Each draws NAME.svg and NAME.png beside itself, from CSV files named by
/// relative paths. The look of a curve: its colour says which curve it is (Okabe and Ito's colours, safe for
/// colour-blind readers), its dash or marker says which source it comes from. Every function returns the script's path
/// and throws RunError.
class FigureWriter {
 public:
  explicit FigureWriter(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Curves of all sets at `time`; set s has its profiles in data_folders[s], as write_profile writes them.
  [[nodiscard]] std::filesystem::path profiles(double time, const std::vector<ProfileSet>& sets,
                                               const std::vector<std::filesystem::path>& data_folders,
                                               const PictureFrame& frame, const PageUnit& height) const;

  /// Water front against time: the run's own series `front` and a table `fronts` with a column "LABEL [m]" per set.
  [[nodiscard]] std::filesystem::path front(const std::filesystem::path& front, const std::filesystem::path& fronts,
                                            const std::vector<ProfileSet>& sets) const;

  /// Kinetic energy, change of potential and internal energy, and their sum, from history.csv.
  [[nodiscard]] std::filesystem::path energies(const std::filesystem::path& history, bool has_internal,
                                               const std::string& unit) const;

  /// Discharges of the openings against time, and the levels next to them, from a table of write_openings().
  [[nodiscard]] std::filesystem::path discharges(const std::filesystem::path& table, const OpeningRecords& records,
                                                 const std::string& unit) const;
  [[nodiscard]] std::filesystem::path levels_at_openings(const std::filesystem::path& table,
                                                         const OpeningRecords& records, const PageUnit& height) const;

  /// Velocity profiles and their logarithmic laws, from a table of write_velocity_stations(); those of mesh models beside
  /// them.
  [[nodiscard]] std::filesystem::path stations(const std::filesystem::path& table,
                                               const std::vector<VelocityStation>& stations,
                                               const std::vector<MeshStations>& meshes, const PageUnit& height) const;

  /// Particles by kind, speed and pressure, heights not exaggerated (PNG only).
  [[nodiscard]] std::filesystem::path particles(const ParticleTable& table, const PictureFrame& frame,
                                                double spacing) const;

  /// Particles by kind, heights not exaggerated (PNG only).
  [[nodiscard]] std::filesystem::path scene(const ParticleTable& table, const PictureFrame& frame,
                                            double spacing) const;

  /// The bed's change of level over place and time from the table of a BedHistory, and the water's `front` over it (PNG
  /// only); `largest` [m] ends the colours.
  [[nodiscard]] std::filesystem::path space_time(const std::filesystem::path& table, const std::filesystem::path& front,
                                                 const PictureFrame& frame, double spacing, double largest,
                                                 const PageUnit& height) const;

  /// Any other picture of width x height [pixels]: `body` is settings and then one command `plot`.
  [[nodiscard]] std::filesystem::path write(const std::string& name, int width, int height,
                                            const std::string& body) const;
  /// The same with several plots in one picture: `settings`, and `plots` from "set multiplot" to "unset multiplot".
  [[nodiscard]] std::filesystem::path write_multiplot(const std::string& name, int width, int height,
                                                      const std::string& settings, const std::string& plots) const;
  /// A CSV file as a script names it: quoted, relative to the script's folder.
  [[nodiscard]] std::string data(const std::filesystem::path& file) const;
  [[nodiscard]] std::filesystem::path script(const std::string& name) const { return folder_ / (name + ".gp"); }

 private:
  std::filesystem::path folder_;
};

/// The name of the picture with the profiles of a time: "t0.250".
std::string picture_name(double time);

/// The plots of one command `plot`, one a line.
std::string joined_plots(const std::vector<std::string>& plots);

}  // namespace thalweg
