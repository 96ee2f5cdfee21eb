#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/run_folder.hpp"

namespace thalweg {

/// A row of a summary.csv.
struct Quantity {
  std::string name;
  std::string value;
  std::string unit;
};

/// The rows of a summary.csv; empty when there is no such file. Throws InputError when it cannot be understood.
std::vector<Quantity> read_quantities(const std::filesystem::path& file);

/// A quantity by name, as text or as number; nothing when it is not there (or is no number).
std::optional<std::string> text_of(const std::vector<Quantity>& quantities, const std::string& name);
std::optional<double> number_of(const std::vector<Quantity>& quantities, const std::string& name);

/// The numbers of history.csv that a report shows.
struct History {
  struct Share {
    std::string limiter;
    double share = 0;  // [-] of the rows
  };
  std::size_t rows = 0;
  std::vector<Share> limiters;  // most frequent first
  std::vector<double> dt;       // [s]
  double max_speed = 0;         // [m/s] largest; 0 where the table does not tell
  std::vector<double> internal_energy;
  std::vector<double> water_mass;     // [kg], 2-D [kg/m]
  std::vector<double> sediment_mass;  // [kg], 2-D [kg/m]
};

/// Reads history.csv; without that file, no rows. Throws InputError.
History read_history(const std::filesystem::path& file);

/// A row of timing.csv.
struct Timing {
  std::string heading;
  double seconds = 0;
  double share = 0;  // [-]
  double calls = 0;
};
std::vector<Timing> read_timing(const std::filesystem::path& file);

/// The distance of two runs that should agree: a row of the case's repeatability.csv ("curve,time [s],rms [m]").
struct Repeatability {
  std::string curve;
  double time = 0;  // [s]
  double rms = 0;   // [m]
};
std::vector<Repeatability> read_repeatability(const std::filesystem::path& file);

/// The machine that computed a run, and the last minute at which it did ("2026-11-27 23:58", its local time): from the run's
/// lock and log. Empty where these do not tell.
struct Computed {
  std::string host;
  std::string until;
};
Computed read_computed(const RunFolder& run);

/// The leading "# " lines of a CSV file.
std::vector<std::string> comments_in(const std::filesystem::path& file);

}  // namespace thalweg
