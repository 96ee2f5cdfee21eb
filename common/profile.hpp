#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace thalweg {

/// Curves along x at one time, in the CSV format "x [m], free_surface [m], bed [m], moving_bed [m],
/// floor [m]" (docs/file-formats.md). A column that a source does not have is empty; a single missing value is NaN (an empty cell
/// in the file).
struct Profile {
  static constexpr double missing = std::numeric_limits<double>::quiet_NaN();

  std::vector<double> x;             // [m] strictly increasing
  std::vector<double> free_surface;  // [m] elevation of the water's (or a dry bed's) top
  std::vector<double> bed;           // [m] elevation of the sediment's top, moving or not
  std::vector<double> moving_bed;    // [m] elevation of the lower edge of the moving sediment
  std::vector<double> floor;         // [m] elevation of the wall under the fluid; a bed at this height is bare
};

/// Writes a profile, whole or not at all; `comments` become leading "# " lines. Throws RunError.
void write_profile(const std::filesystem::path& file, const Profile& profile, const std::vector<std::string>& comments);

/// Reads a profile with any subset of the columns (x [m] is needed; unknown columns are an error that names the known
/// ones). Throws InputError "file:line: what is wrong; what to do".
Profile read_profile(const std::filesystem::path& file);

/// "t0.250.csv" for 0.25 s; three decimals, up to six where the time has more.
std::string profile_file_name(double time);

/// The time [s] in a profile's file name; nothing if the name is not of the form of profile_file_name.
std::optional<double> time_of_profile(const std::filesystem::path& file);

}  // namespace thalweg
