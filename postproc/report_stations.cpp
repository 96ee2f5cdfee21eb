// The report's part about a current's velocity over the depth.
#include <fmt/format.h>

#include "common/units.hpp"
#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"

namespace thalweg::report_sections {

std::string stations(const ReportInput& input, const std::filesystem::path& pictures) {
  if (input.stations.empty()) return "";
  std::vector<std::vector<std::string>> rows;
  for (const VelocityStation& station : input.stations) {
    const auto cell = [](double value, const char* unit) { return html::typeset(format_quantity(value, unit)); };
    rows.push_back({cell(station.place, "m"), cell(station.ground, "m"), cell(station.depth, "m"),
                    cell(station.mean_velocity, "m/s"), cell(station.friction_velocity, "m/s"),
                    fmt::format("{:.1f} %", 100 * station.deviation)});
  }
  return "<h2>Velocity over the depth</h2>\n" +
         html::table({"place", "ground", "depth", "mean velocity", "u* of the law", "deviation"}, rows, "rrrrrr") +
         "<div class=\"pair\">\n" +
         figure(html::inline_svg(pictures / "stations.svg", "stations", "Velocity over the depth"),
                "Velocity along the flow at three places (points), a mean over the last half of the run, and the "
                "logarithmic law with the same mean velocity and depth (lines). Numbers: <a "
                "href=\"data/stations.csv\">data/stations.csv</a>.") +
         "</div>\n";
}

}  // namespace thalweg::report_sections
