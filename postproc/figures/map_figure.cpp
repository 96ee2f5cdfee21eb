// Maps of a bed seen from above.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/whole_file.hpp"
#include "postproc/figures/bed_figures.hpp"
#include "postproc/figures/script_template.hpp"
#include "postproc/figures/scripts.hpp"
#include "postproc/figures/tic_step.hpp"
#include "postproc/gnuplot.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

/// The picture of a map: its size and the place of its axes [pixels].
struct MapFrame {
  static constexpr double width = 2000;
  static constexpr double left = 190;
  static constexpr double right = 260;
  static constexpr double above = 40;
  static constexpr double below = 130;
  static constexpr double least = 200;  // height of the axes
  static constexpr double most = 1100;

  double length_x;  // [m]
  double length_y;  // [m]

  explicit MapFrame(const BedMap& map)
      : length_x(map.step * static_cast<double>(map.nx)), length_y(map.step * static_cast<double>(map.ny)) {}

  [[nodiscard]] double true_height() const { return (width - left - right) * length_y / length_x; }
  [[nodiscard]] double axes_height() const { return std::clamp(true_height(), least, most); }
  [[nodiscard]] double height() const { return std::round(axes_height() + above + below); }
};

/// The colours, the values and the lines over them.
struct MapPicture {
  std::string name;
  std::string quantity;
  std::string unit;
  std::string palette;
  std::string value;
  double lowest;
  double highest;
  std::vector<std::string> lines{};   // plots over the map
  std::vector<std::string> labels{};  // commands before it
};

fs::path write_map(const FigureWriter& writer, const MapTable& table, const MapPicture& picture) {
  const BedMap& map = table.map;
  const MapFrame frame(map);
  const double half = map.step / 2;
  constexpr double tall = 420;  // pixels of axes beside which the name of the quantity has room
  std::string lines;
  for (const std::string& line : picture.lines) lines += ", \\\n     " + line;
  std::string labels;
  for (const std::string& label : picture.labels) labels += label + "\n";
  const fs::path script = writer.script(picture.name);
  const std::string text = fill_template(
      embedded::script_map,
      {{"name", picture.name},
       {"look", std::string(embedded::script_look)},
       {"width", script_number(MapFrame::width)},
       {"height", script_number(frame.height())},
       // A map that is longer in y than the picture is high keeps its shape and is narrower.
       {"shape", frame.true_height() > MapFrame::most ? "set size ratio -1\n" : ""},
       {"left", script_number(MapFrame::left / MapFrame::width)},
       {"right", script_number(1 - MapFrame::right / MapFrame::width)},
       {"top", script_number(1 - MapFrame::above / frame.height())},
       {"bottom", script_number(MapFrame::below / frame.height())},
       {"x_from", script_number(map.x0 - half)},
       {"x_to", script_number(map.x(map.nx - 1) + half)},
       {"y_from", script_number(map.y0 - half)},
       {"y_to", script_number(map.y(map.ny - 1) + half)},
       {"y_tics", script_number(tic_step(frame.length_y, std::max(2, static_cast<int>(frame.axes_height() / 120))))},
       {"quantity",
        frame.axes_height() < tall ? "[" + picture.unit + "]" : picture.quantity + "  [" + picture.unit + "]"},
       {"steps", script_number(tic_step(picture.highest - picture.lowest,
                                        std::max(4, static_cast<int>(frame.axes_height() / 70))))},
       {"lowest", script_number(picture.lowest)},
       {"highest", script_number(picture.highest)},
       {"palette", picture.palette},
       {"labels", labels},
       {"data", writer.data(table.file)},
       {"value", picture.value},
       {"half", script_number(0.52 * map.step)},
       {"lines", lines}});
  write_whole_text(script, [&](std::ostream& to) { to << text; });
  return script;
}

/// A label at the middle of the longest line of each level, on lines that are long enough to carry it.
std::vector<std::string> labels_of(const std::vector<Contour>& contours, const BedMap& map, const PageUnit& height) {
  std::vector<std::string> labels;
  constexpr std::size_t least_points = 12;
  for (std::size_t n = 0; n < contours.size();) {
    std::size_t longest = n;
    std::size_t next = n;
    for (; next < contours.size() && contours[next].level == contours[n].level; ++next) {
      if (contours[next].points.size() > contours[longest].points.size()) longest = next;
    }
    n = next;
    const auto& points = contours[longest].points;
    if (points.size() < least_points) continue;
    const auto& at = points[(labels.size() % 2 == 0 ? 1 : 3) * points.size() / 4];
    labels.push_back(fmt::format("set label {} '{:g}' at {:.6g},{:.6g} center font ',9' textcolor rgb '#222222' front",
                                 labels.size() + 1, contours[longest].level / height.size, at[0],
                                 std::clamp(at[1], map.y0, map.y(map.ny - 1))));
  }
  return labels;
}

}  // namespace

double map_stretch(const BedMap& map) {
  const MapFrame frame(map);
  return frame.true_height() > MapFrame::most ? 1 : frame.axes_height() / frame.true_height();
}

fs::path change_map_script(const FigureWriter& writer, const MapTable& table, const PageUnit& height) {
  const BedExtremes extremes = extremes_of(table.map);
  const double largest = std::max({extremes.scour, extremes.deposition, 1e-9});
  std::vector<double> change(table.map.size());
  for (std::size_t k = 0; k < change.size(); ++k) change[k] = table.map.change(k);
  const std::vector<Contour> contours =
      contours_of(table.map, change, contour_levels(change, tic_step(largest, most_contours)));
  const fs::path file = table.file.parent_path() / "bed_contours.csv";
  write_contours(file, contours);
  MapPicture picture{"bed_map",
                     "bed risen or sunk",
                     height.name,
                     "-1 '#005a50', -0.5 '#5ab4ac', 0 '#f5f5f0', 0.5 '#d8a048', 1 '#54300a'",
                     height.factor() + "*column('change [m]')",
                     -largest / height.size,
                     largest / height.size};
  if (!contours.empty()) {
    picture.lines.push_back(writer.data(file) + " using 2:3 with lines lw 0.5 lc rgb '#333333' notitle");
    picture.labels = labels_of(contours, table.map, height);
  }
  const BedMap& map = table.map;
  if (extremes.scour > 0) {
    picture.labels.push_back(
        fmt::format("set label {} '' at {:.6g},{:.6g} point pt 2 ps 2.5 lw 1.5 lc rgb '#c00000' front",
                    picture.labels.size() + 1, map.x(extremes.scour_at[0]), map.y(extremes.scour_at[1])));
  }
  return write_map(writer, table, picture);
}

fs::path shear_map_script(const FigureWriter& writer, const MapTable& table, double grain_weight, double critical) {
  const BedMap& map = table.map;
  double highest = 0;
  std::vector<double> stress(map.size());
  for (std::size_t k = 0; k < map.size(); ++k) {
    stress[k] = map.shields[k] * grain_weight;
    if (!std::isnan(stress[k])) highest = std::max(highest, stress[k]);
  }
  MapPicture picture{"shear_map",
                     "bed shear stress",
                     "Pa",
                     "0 '#ffffff', 0.25 '#d6e6f2', 0.5 '#7fb2d6', 0.75 '#2f78b3', 1 '#08306b'",
                     "column('shear [Pa]')",
                     0,
                     std::max(highest, 1e-9)};
  if (critical > 0) {
    const fs::path file = table.file.parent_path() / "critical_shear.csv";
    write_contours(file, contours_of(map, stress, {critical}));
    picture.lines.push_back(writer.data(file) + " using 2:3 with lines lw 1 lc rgb '#d55e00' notitle");
  }
  return write_map(writer, table, picture);
}

}  // namespace thalweg
