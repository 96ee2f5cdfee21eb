// The report's part on the differences between the sources.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <utility>

#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"

namespace thalweg::report_sections {
namespace {

using html::escape;

std::string percent(double share) { return std::isnan(share) ? "–" : fmt::format("{:.1f} %", share * 1e2); }

std::string title_of(const std::string& curve_name) {
  for (const Curve& curve : curves) {
    if (curve.name == curve_name) return curve.title;
  }
  return curve_name;
}

const Repeatability* scatter_of(const ReportInput& input, const std::string& curve, double time) {
  for (const Repeatability& known : input.repeatability) {
    if (known.curve == curve && std::abs(known.time - time) <= same_time) return &known;
  }
  return nullptr;
}

std::vector<double> times_of(const std::vector<CurveError>& errors) {
  std::set<double> times;
  for (const CurveError& error : errors) times.insert(error.time);
  return {times.begin(), times.end()};
}

// The rows with the scatter of equal runs at these times, one a curve that has any.
std::vector<std::vector<std::string>> scatter_rows(const ReportInput& input, const std::vector<double>& times) {
  std::vector<std::vector<std::string>> rows;
  for (const Curve& curve : curves) {
    std::vector<std::string> row{"<span class=\"soft\">scatter of equal runs</span>", "", curve.title};
    bool any = false;
    for (const double time : times) {
      const Repeatability* scatter = scatter_of(input, curve.name, time);
      any = any || scatter != nullptr;
      row.push_back(scatter != nullptr ? input.units.height.number(scatter->rms) : "–");
    }
    if (any) rows.push_back(std::move(row));
  }
  return rows;
}

// Root mean square differences: a row for each pair of sources and curve, a column for each time.
std::string rmse_table(const ReportInput& input, const std::vector<CurveError>& all) {
  const std::vector<double> times = times_of(all);
  std::vector<std::string> heads{"compared", "against", "curve"};
  for (const double time : times) heads.push_back(fmt::format("t = {:g} s", time));
  std::vector<std::vector<std::string>> rows;
  std::string last_row;
  bool any_within_scatter = false;
  for (const CurveError& error : all) {
    const std::string pair = error.compared + "\n" + error.reference + "\n";
    if (pair + error.curve != last_row) {
      const bool same_pair = last_row.starts_with(pair);
      rows.push_back(
          {same_pair ? "" : escape(error.compared), same_pair ? "" : escape(error.reference), title_of(error.curve)});
      rows.back().resize(3 + times.size(), "–");
      last_row = pair + error.curve;
    }
    const auto column = static_cast<std::size_t>(std::find(times.begin(), times.end(), error.time) - times.begin());
    const Repeatability* scatter = scatter_of(input, error.curve, error.time);
    const bool within = scatter != nullptr && error.rmse <= scatter->rms;
    any_within_scatter = any_within_scatter || within;
    rows.back()[3 + column] = input.units.height.number(error.rmse) + (within ? "*" : "");
  }
  for (std::vector<std::string>& row : scatter_rows(input, times)) rows.push_back(std::move(row));
  std::string text = fmt::format("<h3>Root mean square difference [{}]</h3>\n", input.units.height.name) +
                     html::table(heads, rows, "lll" + std::string(times.size(), 'r'));
  if (input.repeatability.empty()) return text;
  return text + fmt::format(
                    "<p class=\"small\">The scatter is the difference between runs that should be equal; "
                    "smaller differences mean nothing{}. From the case's repeatability.csv: {}</p>\n",
                    any_within_scatter ? " and are marked *" : "",
                    escape(fmt::format("{}", fmt::join(input.repeatability_origin, " "))));
}

// All numbers of errors.csv along x.
std::string full_table(const std::vector<CurveError>& all, const PageUnit& height) {
  std::vector<std::vector<std::string>> rows;
  const std::string unit = height.name + "]";
  std::string last_pair;
  for (const CurveError& e : all) {
    const std::string pair = escape(e.compared) + " against " + escape(e.reference);
    if (pair != last_pair) rows.push_back({pair});
    last_pair = pair;
    const auto place = [](double x) { return html::typeset(fmt::format("{:.3f}", x)); };
    rows.push_back({title_of(e.curve), fmt::format("{:g}", e.time), height.number(e.rmse), percent(e.normalised_rmse),
                    height.signed_number(e.bias), height.signed_number(e.largest_error), place(e.largest_error_at),
                    std::isnan(e.brier_skill) ? "–" : html::typeset(fmt::format("{:.2f}", e.brier_skill)),
                    fmt::format("{}", e.points), place(e.from) + " … " + place(e.to)});
  }
  return "<h3>In full</h3>\n" +
         html::table({"curve", "t [s]", "RMSE [" + unit, "of range", "bias [" + unit, "largest [" + unit, "at x [m]",
                      "skill", "points", "common range [m]"},
                     rows, "lrrrrrrrrr", "long wide") +
         fmt::format("<p class=\"small\">{}. Numbers: <a href=\"errors.csv\">report/errors.csv</a>.</p>\n",
                     escape(comparison_method));
}

// The numbers of scalars.csv: front and extremes of the bed.
std::string extremes(const ReportInput& input) {
  std::vector<std::vector<std::string>> rows;
  std::string last_pair;
  for (const ScalarError& scalar : input.comparison.scalars) {
    if (!scalar.line.empty()) continue;
    const std::string pair = escape(scalar.compared) + " against " + escape(scalar.reference);
    if (pair != last_pair) rows.push_back({pair});
    last_pair = pair;
    std::string quantity = scalar.quantity;
    std::replace(quantity.begin(), quantity.end(), '_', ' ');
    // Heights have the page's unit, places metres.
    const bool is_height = scalar.quantity == "scour" || scalar.quantity == "deposition";
    const PageUnit unit = is_height ? input.units.height : PageUnit{"m", 1, 3};
    rows.push_back({fmt::format("{} [{}]", quantity, unit.name), fmt::format("{:g}", scalar.time),
                    html::typeset(unit.number(scalar.compared_value)),
                    html::typeset(unit.number(scalar.reference_value)),
                    unit.signed_number(scalar.compared_value - scalar.reference_value)});
  }
  if (rows.empty()) return "";
  return "<h3>Front, deepest scour and highest deposition</h3>\n" +
         html::table({"quantity", "t [s]", "compared", "against", "difference"}, rows, "lrrrr") +
         fmt::format(
             "<p class=\"small\">Along the profile{}, within the range compared. Front: largest x with more than {} "
             "of water, for every method. Scour and deposition: fall and rise of the bed, the top of the "
             "sediment whether it moves or not, since the start. Numbers: <a "
             "href=\"scalars.csv\">report/scalars.csv</a>; of the whole bed, this run's alone: <a "
             "href=\"../profiles/series.csv\">profiles/series.csv</a>.</p>\n",
             input.resolved.info.dimension == 3 ? fmt::format(" in the plane y = {:g} m", input.extraction.plane_y)
                                                : "",
             input.units.height.text(least_layer * input.extraction.info.spacing));
}

}  // namespace

std::string errors(const ReportInput& input) {
  std::string text = "<h2>Differences between the sources</h2>\n";
  for (std::string note : input.reference_notes) {
    note.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(note.front())));
    text += "<p>" + escape(note) + ".</p>\n";
  }
  std::vector<CurveError> along_x = input.comparison.errors;
  std::erase_if(along_x, [](const CurveError& error) { return !error.line.empty(); });  // in errors.csv only
  if (along_x.empty()) return text + "<p>There was nothing to compare the run with.</p>\n";
  text += rmse_table(input, along_x) + full_table(along_x, input.units.height) + extremes(input);
  if (!input.comparison.remarks.empty()) {
    text += "<ul class=\"small\">\n";
    for (const std::string& remark : input.comparison.remarks) text += "<li>" + escape(remark) + "</li>\n";
    text += "</ul>\n";
  }
  return text;
}

}  // namespace thalweg::report_sections
