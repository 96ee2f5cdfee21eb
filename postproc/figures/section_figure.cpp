// Cuts through a bed at a place, and the shear stress along a bed in the plane.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/csv.hpp"
#include "postproc/figures/bed_figures.hpp"
#include "postproc/figures/script_template.hpp"
#include "postproc/figures/scripts.hpp"
#include "postproc/gnuplot.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

/// The places of a cut, in order.
std::vector<std::size_t> cut_through(const BedMap& map, bool along_x, const std::array<std::size_t, 2>& place) {
  std::vector<std::size_t> places;
  for (std::size_t n = 0; n < (along_x ? map.nx : map.ny); ++n) {
    places.push_back(along_x ? map.index(n, place[1]) : map.index(place[0], n));
  }
  return places;
}

void write_cut(const fs::path& file, const BedMap& map, bool along_x, const std::vector<std::size_t>& places) {
  CsvTable table({{along_x ? "x" : "y", "m"}, {"before", "m"}, {"now", "m"}, {"water", "m"}, {"ground", "-"}});
  for (std::size_t n = 0; n < places.size(); ++n) {
    const std::size_t k = places[n];
    table.add_row({csv_number(along_x ? map.x(n) : map.y(n)), csv_number(map.before[k]), csv_number(map.now[k]),
                   csv_number(map.water[k]), std::to_string(static_cast<int>(map.ground[k]))});
  }
  table.write(file);
}

/// The heights that a cut shows: the bed, and as much above and below it as it has changed.
struct HeightRange {
  double low = INFINITY;    // [m]
  double high = -INFINITY;  // [m]
};
HeightRange heights_of(const BedMap& map, const std::vector<std::size_t>& places) {
  HeightRange range;
  for (const std::size_t k : places) {
    if (std::isnan(map.change(k))) continue;
    range.low = std::min({range.low, map.before[k], map.now[k]});
    range.high = std::max({range.high, map.before[k], map.now[k]});
  }
  const double size = std::max(range.high - range.low, 2 * map.step);
  range.low -= 0.25 * size;
  range.high += 0.6 * size;
  return range;
}

}  // namespace

fs::path section_script(const FigureWriter& writer, const MapTable& table, bool along_x,
                        const std::array<std::size_t, 2>& place, const PageUnit& height) {
  const BedMap& map = table.map;
  const std::vector<std::size_t> places = cut_through(map, along_x, place);
  const std::string name = along_x ? "section_x" : "section_y";
  const fs::path file = table.file.parent_path() / (name + ".csv");
  write_cut(file, map, along_x, places);
  const HeightRange range = heights_of(map, places);
  const std::string data = writer.data(file);
  const std::string at = fmt::format("(column('{} [m]'))", along_x ? "x" : "y");
  const auto scaled = [&](const char* column) { return fmt::format("({}*column('{} [m]'))", height.factor(), column); };
  const double top = range.high / height.size;
  const double bottom = range.low / height.size;
  std::vector<std::string> plots;
  const std::string floor = fmt::format("({:g})", bottom);
  for (const auto& [low, high, colour] : {std::array{scaled("now"), scaled("water"), std::string("#e3eff8")},
                                          {floor, scaled("now"), std::string("#ecdcc0")}}) {
    // Columns are as wide as they are, contoured beds linear between their points.
    plots.push_back(map.in_columns ? fmt::format("{0} using {1}:{2}:({1}-{5:g}):({1}+{5:g}):{2}:{3} with boxxyerror fs "
                                                 "solid noborder fc rgb '{4}' notitle",
                                                 data, at, low, high, colour, 0.5 * map.step)
                                   : fmt::format("{} using {}:{}:{} with filledcurves fc rgb '{}' notitle", data, at,
                                                 low, high, colour));
  }
  if (std::any_of(places.begin(), places.end(), [&](std::size_t k) { return map.ground[k] >= Ground::wall; })) {
    // Contoured beds end on a wall's face, columns half a column before it.
    const double half = (map.in_columns ? 0.5 : 1.0) * map.step;
    plots.push_back(
        fmt::format("{0} using (column('ground [-]')>=2 ? {1} : NaN):({2:g}):({1}-{4:g}):({1}+{4:g}):({2:g}):({3:g}) "
                    "with boxxyerror fs solid noborder fc rgb '#b5b5b5' title 'wall'",
                    data, at, bottom, top, half));
  }
  plots.insert(
      plots.end(),
      {fmt::format("{} using {}:{} with lines lw 1.4 dt (8,5) lc rgb '#555555' title 'bed at the start'", data, at,
                   scaled("before")),
       fmt::format("{} using {}:{} with lines lw 2 lc rgb '#d55e00' title 'bed in the end'", data, at, scaled("now"))});
  const bool wet = std::any_of(places.begin(), places.end(), [&](std::size_t k) {
    return map.water[k] - map.now[k] > least_layer * map.step && map.water[k] > range.low;
  });
  if (wet) {
    plots.push_back(fmt::format("{} using {}:{} with lines lw 1.6 lc rgb '#0072b2' title 'free surface'", data, at,
                                scaled("water")));
  }
  const std::size_t deepest = map.index(place[0], place[1]);
  const double from = along_x ? map.x0 : map.y0;
  const double to = along_x ? map.x(map.nx - 1) : map.y(map.ny - 1);
  const PageUnit metres{"m", 1, decimals_of_places(map.step)};
  std::string where;
  if (map.ny > 1) where = along_x ? "y = " + metres.text(map.y(place[1])) : "x = " + metres.text(map.x(place[0]));
  return writer.write(
      name, 1000, 270,
      fill_template(embedded::script_section, {{"from", script_number(from - map.step / 2)},
                                               {"to", script_number(to + map.step / 2)},
                                               {"z_from", script_number(bottom)},
                                               {"z_to", script_number(top)},
                                               {"abscissa", along_x ? "x" : "y"},
                                               {"unit", height.name},
                                               {"place", where},
                                               {"deepest", script_number(along_x ? map.x(place[0]) : map.y(place[1]))},
                                               {"level_before", script_number(map.before[deepest] / height.size)},
                                               {"level_now", script_number(map.now[deepest] / height.size)},
                                               {"curves", joined_plots(plots)}}));
}

fs::path shear_profile_script(const FigureWriter& writer, const MapTable& table, double critical) {
  std::vector<std::string> plots{fmt::format(
      "{} using (column('x [m]')):(column('shear [Pa]')) with lines lw 1.8 lc rgb '#0072b2' title 'bed shear stress'",
      writer.data(table.file))};
  if (critical > 0) {
    plots.push_back(fmt::format(
        "{:.6g} with lines lw 1.4 dt (10,5) lc rgb '#d55e00' title 'at which a flat bed begins to move'", critical));
  }
  return writer.write("shear", 1000, 270,
                      fill_template(embedded::script_curves, {{"abscissa", "x  [m]"},
                                                              {"quantity", "bed shear stress  [Pa]"},
                                                              {"x_from", "*"},
                                                              {"key_rows", "1"},
                                                              {"curves", joined_plots(plots)}}));
}

}  // namespace thalweg
