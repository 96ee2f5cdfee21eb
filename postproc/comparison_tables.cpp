#include <fmt/format.h>

#include <cmath>

#include "common/csv.hpp"
#include "postproc/comparison.hpp"

namespace thalweg {
namespace {

std::string millimetres(double metres) { return std::isnan(metres) ? "" : fmt::format("{:.2f}", metres * 1e3); }
std::string per_cent(double share) { return std::isnan(share) ? "-" : fmt::format("{:.1f} %", share * 1e2); }

// Twelve digits: a coordinate counted from far away keeps its hundredth of a spacing.
std::string cell_of(double value) { return std::isnan(value) ? std::string() : fmt::format("{:.12g}", value); }

void write_scalars(const std::filesystem::path& file, const std::vector<ScalarError>& scalars) {
  CsvTable table({{"reference", ""},
                  {"compared", ""},
                  {"line", ""},
                  {"quantity", ""},
                  {"time", "s"},
                  {"reference_value", "m"},
                  {"compared_value", "m"},
                  {"error", "m"},
                  {"relative_error", "-"}});
  table.comments.emplace_back(
      "error = compared - reference, relative to the reference's value; scour and deposition: largest fall and rise of "
      "the bed since 0 s within the compared range; an empty cell is a value that a source does not have");
  for (const ScalarError& s : scalars) {
    const double error = s.compared_value - s.reference_value;
    const double relative = s.reference_value == 0 ? Profile::missing : error / std::abs(s.reference_value);
    table.add_row({s.reference, s.compared, s.line, s.quantity, cell_of(s.time), cell_of(s.reference_value),
                   cell_of(s.compared_value), cell_of(error), cell_of(relative)});
  }
  table.write(file);
}

}  // namespace

std::string table_of(const Comparison& comparison) {
  std::string text;
  const CurveError* last = nullptr;
  for (const CurveError& error : comparison.errors) {
    if (last == nullptr || last->reference != error.reference || last->compared != error.compared ||
        last->line != error.line) {
      text += fmt::format("\n{} against {}{}\n  {:<13}{:>8}{:>10}{:>9}{:>10}{:>10}{:>9}{:>8}{:>13}{:>8}  {}\n",
                          error.compared, error.reference, error.line.empty() ? "" : ", line " + error.line, "curve",
                          "t [s]", "RMSE [mm]", "of range", "bias [mm]", "max [mm]", "at x [m]", "skill",
                          "scatter [mm]", "points", "range [m]");
    }
    text += fmt::format("  {:<13}{:>8.3f}{:>10}{:>9}{:>10}{:>10}{:>9.3f}{:>8}{:>13}{:>8}  {:.3f} .. {:.3f}\n",
                        error.curve, error.time, millimetres(error.rmse), per_cent(error.normalised_rmse),
                        millimetres(error.bias), millimetres(error.largest_error), error.largest_error_at,
                        std::isnan(error.brier_skill) ? "" : fmt::format("{:.2f}", error.brier_skill),
                        millimetres(error.scatter), error.points, error.from, error.to);
    last = &error;
  }
  if (last != nullptr) text += fmt::format("\n{}\n", comparison_method);
  if (!comparison.scalars.empty()) {
    text += fmt::format("\n  {:<12}{:>8}{:>16}{:>15}{:>12}  {}\n", "number", "t [s]", "reference [mm]", "compared [mm]",
                        "error [mm]", "compared against reference");
  }
  for (const ScalarError& s : comparison.scalars) {
    text += fmt::format("  {:<12}{:>8.3f}{:>16}{:>15}{:>12}  {} against {}{}\n", s.quantity, s.time,
                        millimetres(s.reference_value), millimetres(s.compared_value),
                        millimetres(s.compared_value - s.reference_value), s.compared, s.reference,
                        s.line.empty() ? "" : ", line " + s.line);
  }
  return text;
}

void write_errors(const std::filesystem::path& folder, const Comparison& comparison) {
  CsvTable table({{"reference", ""},
                  {"compared", ""},
                  {"line", ""},
                  {"curve", ""},
                  {"time", "s"},
                  {"points", "-"},
                  {"from", "m"},
                  {"to", "m"},
                  {"rmse", "m"},
                  {"normalised_rmse", "-"},
                  {"bias", "m"},
                  {"largest_error", "m"},
                  {"largest_error_at", "m"},
                  {"brier_skill", "-"},
                  {"scatter", "m"},
                  {"scatter_runs", "-"}});
  table.comments.emplace_back(comparison_method);
  table.comments.insert(table.comments.end(), comparison.remarks.begin(), comparison.remarks.end());
  for (const CurveError& e : comparison.errors) {
    table.add_row({e.reference, e.compared, e.line, e.curve, cell_of(e.time), std::to_string(e.points), cell_of(e.from),
                   cell_of(e.to), cell_of(e.rmse), cell_of(e.normalised_rmse), cell_of(e.bias),
                   cell_of(e.largest_error), cell_of(e.largest_error_at), cell_of(e.brier_skill), cell_of(e.scatter),
                   e.scatter_runs > 0 ? std::to_string(e.scatter_runs) : std::string()});
  }
  table.write(folder / "errors.csv");
  write_scalars(folder / "scalars.csv", comparison.scalars);
}

}  // namespace thalweg
