#include <fmt/format.h>

#include <array>

#include "postproc/figures/figure_writer.hpp"
#include "postproc/figures/script_template.hpp"
#include "postproc/figures/scripts.hpp"
#include "postproc/gnuplot.hpp"

namespace thalweg {

std::filesystem::path FigureWriter::stations(const std::filesystem::path& table,
                                             const std::vector<VelocityStation>& stations,
                                             const std::vector<MeshStations>& meshes, const PageUnit& height) const {
  std::vector<std::string> parts;
  // Only the rows of a station: others give no number.
  const auto only = [](const VelocityStation& station, const char* column) {
    return fmt::format("(abs(column('place [m]')-({:.9g}))<1e-6?column('{}'):NaN)", station.place, column);
  };
  for (std::size_t n = 0; n < stations.size(); ++n) {
    const char* colour = curve_colours.at(n % curve_colours.size());
    const auto of_station = [&](const char* column) { return only(stations[n], column); };
    parts.push_back(fmt::format("{} using {}:({}*column('height [m]')) with points pt 7 ps 0.7 lc rgb '{}' title {}",
                                data(table), of_station("velocity [m/s]"), height.factor(), colour,
                                gnuplot_string(fmt::format("at {:.4g} m", stations[n].place))));
    parts.push_back(fmt::format("{} using {}:({}*column('height [m]')) with lines lw 1.6 lc rgb '{}' notitle",
                                data(table), of_station("law [m/s]"), height.factor(), colour));
  }
  constexpr std::array open_points{6, 4, 8, 10};  // circle, square, triangles
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh) {
    for (std::size_t n = 0; n < meshes[mesh].stations.size(); ++n) {
      const std::string title = n == 0 ? "title " + gnuplot_string(meshes[mesh].label) : "notitle";
      parts.push_back(fmt::format("{} using {}:({}*column('height [m]')) with points pt {} ps 0.7 lc rgb '{}' {}",
                                  data(meshes[mesh].table), only(meshes[mesh].stations[n], "velocity [m/s]"),
                                  height.factor(), open_points.at(mesh % open_points.size()),
                                  curve_colours.at(n % curve_colours.size()), title));
    }
  }
  return write("stations", 490, 300,
               fill_template(embedded::script_stations, {{"unit", height.name}, {"curves", joined_plots(parts)}}));
}

}  // namespace thalweg
