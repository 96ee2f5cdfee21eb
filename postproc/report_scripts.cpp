#include "postproc/report_scripts.hpp"

#include <fmt/format.h>

#include <cmath>

#include "postproc/figures/bed_figures.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

constexpr const char* fallen_style = "lw 2 lc rgb '#0072b2'";
constexpr const char* risen_style = "lw 2 lc rgb '#8c510a'";

/// Depths of the formulas, as many as a picture can name. A depth far above the curve would flatten it: the page names it.
std::vector<LevelLine> levels_of(const ReportInput& input) {
  constexpr std::size_t most = 5;
  std::vector<LevelLine> levels;
  for (const bool outside : {false, true}) {
    for (const FormulaRow& row : input.formulas) {
      if (!is_depth(row) || !is_drawn(input, row) || row.outside.empty() == outside || levels.size() == most) continue;
      levels.push_back({*row.value, row.formula + (outside ? " (outside its range)" : ""), outside});
    }
  }
  return levels;
}

TimePicture depth_picture(const ReportInput& input, const fs::path& data) {
  const PageUnit second{"s", 1, 1};
  const bool of_bed = input.series.of_bed_time;
  const PageUnit& time = of_bed ? input.units.bed_time : second;
  TimePicture picture{
      "scour",
      fmt::format("{}  [{}]", of_bed ? "time of the bed" : "t", time.name),
      fmt::format("{}  [{}]", of_bed ? "depth of the scour" : "fall and rise of the bed", input.units.height.name),
      time,
      input.units.height,
      {}};
  picture.levels = levels_of(input);
  if (input.scour.time.empty()) {
    picture.curves.push_back({data / "bed_series.csv", "scour [m]", "deepest fall", fallen_style});
    picture.curves.push_back({data / "bed_series.csv", "deposition [m]", "highest rise", risen_style});
    return picture;
  }
  const fs::path table = data / "scour.csv";
  write_scour(table, input.scour);
  picture.curves.push_back({table, "depth [m]", "computed", fallen_style});
  if (input.scour.fit.has_reached()) {
    picture.curves.push_back({table, "fit [m]", "fit", "lw 2 dt (10,5) lc rgb '#d55e00'"});
  }
  constexpr const char* colours[] = {"#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#999999"};
  for (std::size_t n = 0; n < input.scour_checks.size(); ++n) {
    const ScourCheck& check = input.scour_checks[n];
    const fs::path beside = data / fmt::format("scour-beside{}.csv", n + 1);
    write_scour(beside, check.record);
    picture.curves.push_back(
        {beside, "depth [m]", check.label, fmt::format("lw 1.5 lc rgb '{}'", colours[n % std::size(colours)])});
  }
  return picture;
}

TimePicture volume_picture(const ReportInput& input, const TimePicture& depth, const fs::path& data) {
  const bool in_plane = input.resolved.info.dimension == 2;
  const std::string unit = in_plane ? "m^2" : "m^3";
  TimePicture picture = depth;
  picture.name = "volume";
  picture.unit = input.units.volume;
  picture.quantity = fmt::format("{}  [{}]", in_plane ? "area of the bed" : "volume of the bed", picture.unit.drawn());
  picture.levels.clear();
  picture.curves = {{data / "bed_series.csv", fmt::format("eroded [{}]", unit), "fallen", fallen_style},
                    {data / "bed_series.csv", fmt::format("deposited [{}]", unit), "risen", risen_style}};
  return picture;
}

/// Mean velocity of a driven current.
TimePicture current_picture(const ReportInput& input) {
  TimePicture picture;
  picture.name = "current";
  picture.abscissa = "t  [s]";
  picture.quantity = "mean velocity  [m/s]";
  picture.time = {"s", 1, 1};
  picture.unit = {"m/s", 1, 3};
  picture.curves.push_back({input.run.history(), "bulk_velocity [m/s]", "computed", fallen_style});
  return picture;
}

}  // namespace

bool is_drawn(const ReportInput& input, const FormulaRow& row) {
  constexpr double most = 3;
  return input.answer && *row.value <= most * input.answer->depth;
}

std::vector<fs::path> bed_scripts(const ReportInput& input, const fs::path& pictures) {
  const FigureWriter writer(pictures);
  const fs::path data = input.run.report() / "data";
  std::vector<fs::path> scripts;
  if (input.resolved.flow.drive != Drive::off && input.history.rows > 1) {
    scripts.push_back(time_script(writer, current_picture(input)));
  }
  if (input.series.time.size() > 1) {
    write_series_table(data / "bed_series.csv", input.series, input.resolved.info.dimension);
    const TimePicture depth = depth_picture(input, data);
    scripts.push_back(time_script(writer, depth));
    scripts.push_back(time_script(writer, volume_picture(input, depth, data)));
  }
  const BedMap& map = input.map.map;
  if (map.size() == 0) return scripts;
  const MapTable table{map, data / "bed_map.csv"};
  write_bed_map(table.file, map, input.map.grain_weight);
  const auto deepest = extremes_of(map).scour_at;
  scripts.push_back(section_script(writer, table, true, deepest, input.units.height));
  if (map.ny > 1) {
    scripts.push_back(section_script(writer, table, false, deepest, input.units.height));
    scripts.push_back(change_map_script(writer, table, input.units.height));
  }
  if (map.shields.empty()) return scripts;
  scripts.push_back(map.ny > 1 ? shear_map_script(writer, table, input.map.grain_weight, input.map.critical_stress)
                               : shear_profile_script(writer, table, input.map.critical_stress));
  return scripts;
}

}  // namespace thalweg
