#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "postproc/profile_set.hpp"

namespace thalweg {

/// The distance of one curve from another at one time. Errors are compared minus reference, at the reference's points.
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

  std::string line{};  // empty: the profile along x
  /// [-] of the bed: 1 - <(compared - reference)^2> / <(initial - reference)^2> (Sutherland, Peet and Soulsby 2004,
  /// Coastal Engineering 51, 917-939), 1 when perfect, 0 when no better than a bed that does not change; NaN without an
  /// initial bed or without change.
  double brier_skill = std::numeric_limits<double>::quiet_NaN();
  double scatter = std::numeric_limits<double>::quiet_NaN();  // [m] of repeated runs; NaN where it is not known
  int scatter_runs = 0;                                       // [-] 0: not known
};

/// One number at one time, as two sources give it [m].
struct ScalarError {
  std::string reference;
  std::string compared;
  std::string line;
  std::string quantity;  // "front", "scour", "scour_at", "deposition"
  double time = 0;       // [s]
  double reference_value = 0;
  double compared_value = 0;  // NaN, like the other, where the source does not have it
};

/// The difference of equal runs: root mean square over all pairs of runs and the columns they share.
struct Scatter {
  std::string line;
  std::string curve;
  double time = 0;  // [s]
  double rms = 0;   // [m]
  int runs = 0;
};

struct Comparison {
  std::vector<CurveError> errors;
  std::vector<ScalarError> scalars{};
  std::vector<std::string> remarks;  // in words: the things that could not be compared
};

/// The definition of the errors, for tables and reports.
inline constexpr const char* comparison_method =
    "error = compared - reference at the reference's points between the common ends, the compared curve linear between "
    "its points, never beyond its ends or across a gap; normalised by (max - min) of the reference over those points; "
    "skill: Brier skill score of the bed's change since 0 s; scatter: what equal runs differ by (root mean square)";

/// The range that is compared, and the least depth of water of a wet place.
struct ComparedRange {
  double from = -std::numeric_limits<double>::infinity();  // [m]
  double to = std::numeric_limits<double>::infinity();     // [m]
  double least_depth = 0;                                  // [m] of the front
};

/// Compares two sets at all times they share, curve by curve and number by number.
Comparison compare(const ProfileSet& reference, const ProfileSet& compared, const ComparedRange& range);

/// Compares every two sets, the more trusted one (SourceKind) as the reference.
Comparison compare_all(const std::vector<ProfileSet>& sets, const ComparedRange& range);

/// The scatter of sets of one line at the times all of them have.
std::vector<Scatter> scatter_of(const std::vector<ProfileSet>& repeated);

/// Writes the scatter beside the errors of pairs in which `label` takes part.
void add_scatter(Comparison& comparison, const std::string& label, const std::vector<Scatter>& scatter);

/// The table for a terminal, lengths in mm.
std::string table_of(const Comparison& comparison);

/// Writes errors.csv and scalars.csv into `folder`; lengths in m. Throws RunError.
void write_errors(const std::filesystem::path& folder, const Comparison& comparison);

}  // namespace thalweg
