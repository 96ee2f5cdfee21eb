#include <fmt/format.h>

#include <string>
#include <vector>

#include "postproc/figures/figure_writer.hpp"
#include "postproc/figures/script_template.hpp"
#include "postproc/figures/scripts.hpp"
#include "postproc/gnuplot.hpp"

namespace thalweg {

std::filesystem::path FigureWriter::scour(const std::filesystem::path& table, bool has_fit,
                                          const std::vector<ScourCurve>& beside) const {
  const std::string file = data(table);
  std::vector<std::string> parts{
      file + " using (column('time [s]')):(column('depth [m]')) with lines lw 2 lc rgb '#0072b2' title 'computed'"};
  if (has_fit) {
    parts.push_back(
        file +
        " using (column('time [s]')):(column('fit [m]')) with lines lw 2 dt (10,5) lc rgb '#d55e00' title 'fit'");
  }
  const std::vector<std::string> colours{"#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#999999"};
  for (std::size_t n = 0; n < beside.size(); ++n) {
    parts.push_back(
        fmt::format("{} using (column('time [s]')):(column('depth [m]')) with lines lw 1.5 lc rgb '{}' title {}",
                    data(beside[n].table), colours[n % colours.size()], gnuplot_string(beside[n].label)));
  }
  return write("scour", 490, 300,
               fill_template(embedded::script_openings,
                             {{"quantity", "depth of the scour  [m]"}, {"curves", joined_plots(parts)}}));
}

}  // namespace thalweg
