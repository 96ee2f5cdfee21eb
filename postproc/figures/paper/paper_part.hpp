#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "postproc/figures/figure_writer.hpp"
#include "postproc/report.hpp"

namespace thalweg::paper {

/// One part of the page: scripts to draw, and the text around their pictures.
struct Part {
  std::vector<std::filesystem::path> scripts;
  std::function<std::string()> html;  // to be called when the pictures have been drawn
};

/// The things all parts need; the parts keep a reference to it.
struct Context {
  explicit Context(const ReportInput& of);

  const ReportInput& input;
  std::filesystem::path folder;  // report/paper
  FigureWriter writer;
  double spacing;  // [m] of the run's particles

  [[nodiscard]] std::filesystem::path data(const char* name) const { return folder / "data" / name; }
  /// The run's first profile, or null.
  [[nodiscard]] const TimedProfile* initial() const;
  /// True if some source is measured.
  [[nodiscard]] bool has_measurement() const;
  /// The empty slot of the measurement, or nothing if there is one.
  [[nodiscard]] std::string measured_slot() const;
};

/// A box on the page for something that is missing.
std::string empty_slot(const std::string& what);

/// A curve's value at x, linear between its points; NaN beyond its ends and in gaps.
double value_at(const std::vector<double>& x, const std::vector<double>& z, double at);

/// The deepest place of the bed below the initial bed.
struct DeepestScour {
  double depth = 0;  // [m]
  double at = Profile::missing;
};
DeepestScour deepest_scour(const Profile& initial, const Profile& now);

/// Figure 6: front against spacing over an immobile bed, from the fronts of `series`. Throws InputError for a folder
/// that is no run, or for runs of different cases.
Part front_against_spacing(const Context& context, const std::vector<std::filesystem::path>& series);
/// Figures 8 to 10: the start, and profiles with their RMSE.
Part start_and_profiles(const Context& context);
/// Figures 11 and 12: levels at three sections, and the local errors there.
Part sections(const Context& context);
/// Figure 13: deepest scour against time; nothing without a bed.
std::optional<Part> scour_against_time(const Context& context);

}  // namespace thalweg::paper
