#pragma once

#include <filesystem>
#include <vector>

namespace thalweg {

/// Measured velocities over an opening, as inlet.profile = "table" has them.
struct VelocitySection {
  std::vector<double> heights;  // [m] over the opening's lower edge, increasing
  std::vector<double> across;   // [m] from its middle, increasing; empty: the same velocity all across
  std::vector<double> speeds;   // [m/s] height by height, each with as many as there are places across, or with one

  /// Linear between the places of the table, constant beyond them; 0 without any. Arguments in m.
  [[nodiscard]] double speed_at(double height, double place_across) const;
};

/// Reads a table with the columns height [m], speed [m/s] and, in space, across [m], its rows in any order. Throws
/// InputError "file:line: what is wrong; what to do" if a number is missing, a place has no row or two, there are less than two
/// places, or nothing flows.
VelocitySection read_velocity_section(const std::filesystem::path& file);

}  // namespace thalweg
