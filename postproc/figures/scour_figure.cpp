// Pictures over time with levels across them: scour depths and the depths of formulas, volumes.
#include <fmt/format.h>

#include <string>
#include <vector>

#include "postproc/figures/bed_figures.hpp"
#include "postproc/figures/script_template.hpp"
#include "postproc/figures/scripts.hpp"
#include "postproc/gnuplot.hpp"

namespace thalweg {

std::filesystem::path time_script(const FigureWriter& writer, const TimePicture& picture) {
  std::vector<std::string> parts;
  for (const TimeCurve& curve : picture.curves) {
    parts.push_back(fmt::format("{} using ({}*column('time [s]')):({}*column('{}')) with lines {} title {}",
                                writer.data(curve.table), picture.time.factor(), picture.unit.factor(), curve.column,
                                curve.style, gnuplot_string(curve.title)));
  }
  constexpr const char* grey[] = {"#444444", "#777777", "#999999"};
  for (std::size_t n = 0; n < picture.levels.size(); ++n) {
    const LevelLine& level = picture.levels[n];
    parts.push_back(fmt::format("{:.6g} with lines lw 1.2 dt {} lc rgb '{}' title {}", level.value / picture.unit.size,
                                level.outside ? "(2,4)" : "(12,4)", grey[n % std::size(grey)],
                                gnuplot_string(level.title)));
  }
  const std::size_t entries = parts.size();
  return writer.write(picture.name, 490, 300,
                      fill_template(embedded::script_curves, {{"abscissa", picture.abscissa},
                                                              {"quantity", picture.quantity},
                                                              {"x_from", "0"},
                                                              {"key_rows", std::to_string((entries + 1) / 2)},
                                                              {"curves", joined_plots(parts)}}));
}

}  // namespace thalweg
