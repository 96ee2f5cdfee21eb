// The report's part about a current's velocity over the depth.
#include <fmt/format.h>

#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"

namespace thalweg::report_sections {

namespace {

void add_rows(const std::vector<VelocityStation>& stations, const std::string& method, const ReportUnits& units,
              std::vector<std::vector<std::string>>& rows) {
  for (const VelocityStation& station : stations) {
    rows.push_back({html::escape(method), html::typeset(units.place.number(station.place)),
                    html::typeset(units.height.number(station.ground)), units.height.number(station.depth),
                    fmt::format("{:.3f}", station.mean_velocity), fmt::format("{:.4f}", station.friction_velocity),
                    fmt::format("{:.1f} %", 100 * station.deviation)});
  }
}

}  // namespace

std::string stations(const ReportInput& input, const std::filesystem::path& pictures) {
  if (input.stations.empty()) return "";
  std::vector<std::vector<std::string>> rows;
  add_rows(input.stations, "particles", input.units, rows);
  for (const MeshModel& mesh : input.meshes) add_rows(mesh.stations, mesh.label, input.units, rows);
  const std::string of_meshes = rows.size() > input.stations.size() ? ", of mesh models open ones" : "";
  return "<h2>Velocity over the depth</h2>\n" +
         html::table({"method", "place [m]", fmt::format("ground [{}]", input.units.height.name),
                      fmt::format("depth [{}]", input.units.height.name), "mean velocity [m/s]", "u* of the law [m/s]",
                      "deviation"},
                     rows, "lrrrrrr") +
         "<div class=\"pair\">\n" +
         figure(
             html::inline_svg(pictures / "stations.svg", "stations", "Velocity over the depth"),
             "Velocity along the flow at three places (points" + of_meshes +
                 "), a mean over the last half of the run, and the logarithmic law with the particles' mean velocity "
                 "and depth (lines). Numbers: <a href=\"data/stations.csv\">data/stations.csv</a>.") +
         "</div>\n";
}

}  // namespace thalweg::report_sections
