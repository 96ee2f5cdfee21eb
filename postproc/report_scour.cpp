// The report's parts about scour: the depth of a hole in a bed that is a surface over the bed's time, and formulas.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <regex>

#include "common/app/scour/table.hpp"
#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"

namespace thalweg::report_sections {
namespace {

/// Share of the factor and of the spacing in the depth: the hole of runs beside this one, at the latest time that both have.
std::string checks(const ReportInput& input) {
  if (input.scour_checks.empty()) return "";
  std::vector<std::vector<std::string>> rows;
  double widest = 0;
  const PageUnit& height = input.units.height;
  for (const ScourCheck& check : input.scour_checks) {
    const double difference = check.depth - check.of_main;
    widest = std::max(widest, std::abs(difference));
    const std::string share =
        check.of_main > 0 ? fmt::format("{:+.1f} %", 100 * difference / check.of_main) : std::string("–");
    rows.push_back({html::escape(check.label), input.units.bed_time.number(check.time), height.number(check.depth),
                    height.number(check.of_main), share});
  }
  return html::table(
             {"run with", fmt::format("bed’s time [{}]", input.units.bed_time.name),
              fmt::format("its depth [{}]", height.name), fmt::format("depth here [{}]", height.name), "difference"},
             rows, "lrrrr") +
         fmt::format(
             "<p class=\"small\">The factor and the spacing change the depth by {} at most. That is no error against "
             "nature.</p>\n",
             height.text_or_less(widest));
}

/// The fit of an equilibrium with the page's units.
std::string fit_in_words(EquilibriumFit fit, const PageUnit& height, const PageUnit& time) {
  for (double* depth : {&fit.equilibrium, &fit.equilibrium_error, &fit.rms}) *depth /= height.size;
  for (double* scale : {&fit.time_scale, &fit.time_scale_error}) *scale /= time.size;
  const std::string text =
      std::regex_replace(html::escape(describe_fit(fit, height.name, time.name)), std::regex(R"(\+-)"), "±");
  return fit.has_reached() ? "Equilibrium: " + std::regex_replace(text, std::regex("S_eq"), "S<sub>eq</sub>")
                           : "No equilibrium is told: " + text;
}

/// Of a bed that is a surface: its fit, the runs beside it, its account of grains.
std::string of_surface(const ReportInput& input) {
  const ScourRecord& record = input.scour;
  const bool in_plane = input.resolved.info.dimension == 2;
  const PageUnit& volume = input.units.volume;
  const PageUnit& time = input.units.bed_time;
  const PageUnit& height = input.units.height;
  std::string text = fmt::format("<p>{}.</p>\n", fit_in_words(record.fit, height, time));
  text += checks(input);
  text += fmt::format(
      "<p class=\"small\">The water was computed for {:.4g} s, the bed went on {:.3g} times as fast, in {} steps, {} "
      "of them under a stress that had not settled. Volume of grains that came in {}, that went out {}{}. An "
      "equilibrium is told only where the curve has come to {:g} of it; its error is that of the fit alone, not of the "
      "model.</p>\n",
      record.water_time, record.time.back() / record.water_time, record.steps, record.unsettled,
      html::typeset(volume.text(record.fed)), html::typeset(volume.text(record.left)),
      in_plane ? " per metre of width" : "", enough_reached);
  return text;
}

/// The caption's part about formulas: those drawn as lines, and those that lie above the picture.
std::string levels_in_words(const ReportInput& input) {
  std::vector<std::string> above;
  bool drawn = false;
  for (const FormulaRow& row : input.formulas) {
    if (!is_depth(row)) continue;
    drawn = drawn || is_drawn(input, row);
    if (is_drawn(input, row)) continue;
    above.push_back(fmt::format("{} {}{}", html::escape(row.formula), input.units.height.text(*row.value),
                                row.outside.empty() ? "" : " (outside its range)"));
  }
  std::string text;
  if (drawn) text += " Grey lines: depths of empirical formulas, dotted where the scene is outside their range.";
  if (!above.empty())
    text += fmt::format(" Above the picture, most of them depths of equilibrium: {}.", fmt::join(above, ", "));
  return text;
}

}  // namespace

std::string scour(const ReportInput& input, const std::filesystem::path& pictures) {
  if (input.series.time.size() < 2) return "";
  const bool of_bed = !input.scour.time.empty();
  std::string text = fmt::format("<h2>{} and volume against time</h2>\n<div class=\"pair\">\n",
                                 has_water(input.resolved) ? "Scour depth" : "Fall of the bed");
  const std::string levels = levels_in_words(input);
  text += figure(html::inline_svg(pictures / "scour.svg", "scour", "Depth of the scour against time"),
                 (of_bed ? "Largest fall of a column of the bed since the start, over the time that the bed’s changes "
                           "stand for. Numbers: <a href=\"data/scour.csv\">data/scour.csv</a>."
                         : "Largest fall and rise of the bed since the start. Numbers: <a "
                           "href=\"data/bed_series.csv\">data/bed_series.csv</a>.") +
                     levels);
  text += figure(html::inline_svg(pictures / "volume.svg", "volume", "Volume of the scour against time"),
                 fmt::format("Volume between the bed and the bed at the start, where it has fallen and where it has "
                             "risen{}. Numbers: <a href=\"data/bed_series.csv\">data/bed_series.csv</a>.",
                             input.resolved.info.dimension == 2 ? ", per metre of width" : ""));
  return text + "</div>\n" + (of_bed ? of_surface(input) : "");
}

namespace {

/// A formula's value in the page's unit of its quantity.
std::string value_in_units(const ReportInput& input, const FormulaRow& row) {
  if (row.unit == "m") return input.units.height.text(*row.value);
  if (row.unit == "s" && !input.scour.time.empty()) return input.units.bed_time.text(*row.value);
  return value_text(row);
}

}  // namespace

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
                    html::typeset(value_in_units(input, row)),
                    left.empty() ? "within" : html::escape(fmt::format("outside: {}", fmt::join(left, ", ")))});
  }
  if (rows.empty()) return "";
  std::string text = "<h2>Scour by formulas</h2>\n";
  text += html::table({"at", "formula", "gives", "value", "range"}, rows, "lllrl");
  text += fmt::format(
      "<p class=\"small\">Empirical formulas for what the case shows, as <code>thalweg formulas</code> prints them "
      "with their inputs and sources. Outside its range a formula says little.{}</p>\n",
      unknown > 0 ? fmt::format(" {} more lack an input that the case does not tell.", unknown) : "");
  return text;
}

}  // namespace thalweg::report_sections
