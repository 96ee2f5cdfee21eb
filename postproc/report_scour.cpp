// The report's parts about scour: the depth of a hole in a bed that is a surface over the bed's time, and formulas.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "common/app/scour/table.hpp"
#include "common/units.hpp"
#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"

namespace thalweg::report_sections {
namespace {

/// Share of the factor and of the spacing in the depth: the hole of runs beside this one, at the latest time that both have.
std::string checks(const ReportInput& input) {
  if (input.scour_checks.empty()) return "";
  std::vector<std::vector<std::string>> rows;
  double widest = 0;
  for (const ScourCheck& check : input.scour_checks) {
    const double difference = check.depth - check.of_main;
    widest = std::max(widest, std::abs(difference));
    const std::string share =
        check.of_main > 0 ? fmt::format("{:+.1f} %", 100 * difference / check.of_main) : std::string("–");
    rows.push_back({html::escape(check.label), html::typeset(format_quantity(check.time, "s")),
                    html::typeset(format_quantity(check.depth, "m")),
                    html::typeset(format_quantity(check.of_main, "m")), share});
  }
  return html::table({"run with", "bed’s time", "its depth", "depth here", "difference"}, rows, "lrrrr") +
         fmt::format(
             "<p class=\"small\">The factor and the spacing decide the depth within {}. That is no error against "
             "nature.</p>\n",
             html::typeset(format_quantity(widest, "m")));
}

}  // namespace

std::string scour(const ReportInput& input, const std::filesystem::path& pictures) {
  const ScourRecord& record = input.scour;
  if (record.time.empty()) return "";
  const bool in_plane = input.resolved.info.dimension == 2;
  const auto length = [](double value) { return html::typeset(format_quantity(value, "m")); };
  const std::string place =
      in_plane ? "x = " + length(record.at[0]) : "x = " + length(record.at[0]) + ", y = " + length(record.at[1]);
  std::string text = "<h2>Scour over time</h2>\n";
  text += fmt::format("<p>Deepest scour {} at {}, after {} of the bed’s time. {}.</p>\n", length(record.depth.back()),
                      place, html::typeset(format_quantity(record.time.back(), "s")),
                      html::escape(describe_fit(record.fit, "m", "s")));
  text += figure(html::inline_svg(pictures / "scour.svg", "scour", "Depth of the scour over the bed’s time"),
                 "Largest fall of a column of the bed since the start, over the time that the bed’s changes stand for. "
                 "Numbers: <a href=\"data/scour.csv\">data/scour.csv</a>.");
  text += checks(input);
  const std::string unit = in_plane ? "m^2" : "m^3";
  text += fmt::format(
      "<p class=\"small\">The water was computed for {}, the bed went on {:.3g} times as fast, in {} steps, {} of them "
      "under a stress that had not settled. Volume of grains that came in {}, that went out {}{}. An equilibrium is "
      "told only where the curve has come to {:g} of it; its error is that of the fit alone, not of the model.</p>\n",
      html::typeset(format_quantity(record.water_time, "s")), record.time.back() / record.water_time, record.steps,
      record.unsettled, html::typeset(fmt::format("{:.3g} {}", record.fed, unit)),
      html::typeset(fmt::format("{:.3g} {}", record.left, unit)), in_plane ? " per metre of width" : "",
      enough_reached);
  return text;
}

std::string formulas(const ReportInput& input) {
  std::vector<std::vector<std::string>> rows;
  std::size_t unknown = 0;
  for (const FormulaRow& row : input.formulas) {
    if (!row.value) {
      ++unknown;
      continue;
    }
    std::vector<std::string> left;
    std::transform(row.outside.begin(), row.outside.end(), std::back_inserter(left), limit_text);
    rows.push_back({html::escape(row.subject), html::escape(row.formula), html::escape(row.gives),
                    html::typeset(value_text(row)),
                    left.empty() ? "within" : html::escape(fmt::format("outside: {}", fmt::join(left, ", ")))});
  }
  if (rows.empty()) return "";
  std::string text = "<h2>Scour by formulas</h2>\n";
  text += html::table({"at", "formula", "gives", "value", "range"}, rows, "lllrl");
  text += fmt::format(
      "<p class=\"small\">Empirical formulas for what the case shows, as <code>thalweg formulas</code> prints them "
      "with "
      "their inputs and sources. Outside its range a formula says little.{}</p>\n",
      unknown > 0 ? fmt::format(" {} more lack an input that the case does not tell.", unknown) : "");
  return text;
}

}  // namespace thalweg::report_sections
