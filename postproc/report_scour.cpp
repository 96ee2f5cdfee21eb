// The report's part about a bed that is a surface: the depth of the hole over the bed's time.
#include <fmt/format.h>

#include "common/units.hpp"
#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"

namespace thalweg::report_sections {

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

}  // namespace thalweg::report_sections
