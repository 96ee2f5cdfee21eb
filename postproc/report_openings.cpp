// The report's part about inlets and outlets: hydrographs, levels, and the balance of the water.
#include <fmt/format.h>

#include <cmath>

#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"

namespace thalweg::report_sections {
namespace {

std::string mass(double kilograms) { return html::typeset(fmt::format("{:.4g}", kilograms)); }

std::string opening_table(const OpeningRecords& records, const std::string& unit, const PageUnit& height) {
  std::vector<std::vector<std::string>> rows;
  for (const OpeningRecord& opening : records.openings) {
    const double sign = opening.enters ? 1 : -1;
    rows.push_back({html::escape(opening.name), opening.enters ? "inlet" : "outlet",
                    html::typeset(fmt::format("{:.4g} {}", sign * opening.mean_rate, unit)),
                    std::isnan(opening.mean_level) ? "–" : html::typeset(height.number(opening.mean_level)),
                    mass(sign * opening.water), mass(opening.sediment == 0 ? 0 : sign * opening.sediment)});
  }
  return html::table(
      {"opening", "", "discharge", fmt::format("level [{}]", height.name), "water [kg]", "sediment [kg]"}, rows,
      "llrrrr");
}

/// The mean velocity of a driven current.
std::string current(const std::filesystem::path& pictures) {
  const std::string picture = html::inline_svg(pictures / "current.svg", "current", "Mean velocity of the current");
  if (picture.empty()) return "";
  return "<h2>The current</h2>\n<div class=\"pair\">\n" +
         figure(picture,
                "Mean velocity of the water along the flow. Numbers: <a href=\"../history.csv\">history.csv</a>.") +
         "</div>\n";
}

}  // namespace

bool has_levels(const OpeningRecords& records) {
  for (const OpeningRecord& opening : records.openings) {
    if (!std::isnan(opening.mean_level)) return true;
  }
  return false;
}

std::string openings(const ReportInput& input, const std::filesystem::path& pictures) {
  const OpeningRecords& records = input.openings;
  if (records.openings.empty()) return current(pictures);
  const std::string unit = input.resolved.info.dimension == 2 ? "m^2/s" : "m^3/s";
  double net = 0;
  for (const OpeningRecord& opening : records.openings) net += opening.mean_rate;
  std::string text = "<h2>What came in and went out</h2>\n" + opening_table(records, unit, input.units.height);
  text += fmt::format(
      "<p class=\"small\">Discharge and level are means over the last half of the run, water and sediment sums over "
      "all of it{}. In that half {} came in more than went out.</p>\n<div class=\"pair\">\n",
      input.resolved.info.dimension == 2 ? ", per metre of width" : "",
      html::typeset(fmt::format("{:.2g} {}", net, unit)));
  text += figure(html::inline_svg(pictures / "discharges.svg", "discharges", "Discharges of inlets and outlets"),
                 "Discharge into the scene (whole lines) and out of it (dashed). Numbers: <a "
                 "href=\"data/openings.csv\">data/openings.csv</a>.");
  if (has_levels(records)) {
    text += figure(html::inline_svg(pictures / "levels.svg", "levels", "Water levels at inlets and outlets"),
                   "Level of the scene's water next to the openings.");
  }
  text += "</div>\n";
  for (const MeshModel& mesh : input.meshes) {
    if (mesh.openings.openings.empty()) continue;
    text += "<p>" + html::escape(mesh.label) + ":</p>\n" + opening_table(mesh.openings, unit, input.units.height);
  }
  return text;
}

}  // namespace thalweg::report_sections
