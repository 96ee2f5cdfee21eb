#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "postproc/profile_set.hpp"

namespace thalweg {

/// How far one curve lies from another at one time. Errors are compared minus reference, at the reference's points.
struct CurveError {
  std::string reference;
  std::string compared;
  std::string curve;
  double time = 0;              // [s]
  std::size_t points = 0;       // [-] points of the reference that both curves cover
  double from = 0;              // [m] common range
  double to = 0;                // [m]
  double rmse = 0;              // [m]
  double normalised_rmse = 0;   // [-] rmse over (max - min) of the reference's points; NaN for a level reference
  double bias = 0;              // [m] mean error
  double largest_error = 0;     // [m] the error of largest magnitude, with its sign
  double largest_error_at = 0;  // [m] x
};

struct Comparison {
  std::vector<CurveError> errors;
  std::vector<std::string> remarks;  // what could not be compared, in words
};

/// How the errors are made, for tables and reports.
inline constexpr const char* comparison_method =
    "error = compared - reference at the reference's points between the common ends, the compared curve linear between "
    "its points, never beyond its ends or across a gap; normalised by (max - min) of the reference over those points";

/// Compares two sets at all times they share, curve by curve, over from <= x <= to [m].
Comparison compare(const ProfileSet& reference, const ProfileSet& compared, double from, double to);

/// Compares every two sets, the more trusted one (SourceKind) as the reference.
Comparison compare_all(const std::vector<ProfileSet>& sets, double from, double to);

/// The table for a terminal, lengths in mm.
std::string table_of(const Comparison& comparison);

/// Writes errors.csv; lengths in m. Throws RunError.
void write_errors(const std::filesystem::path& file, const Comparison& comparison);

}  // namespace thalweg
