#include <string>
#include <vector>

#include "postproc/figures/figure_writer.hpp"
#include "postproc/figures/script_template.hpp"
#include "postproc/figures/scripts.hpp"

namespace thalweg {

std::filesystem::path FigureWriter::scour(const std::filesystem::path& table, bool has_fit) const {
  const std::string file = data(table);
  std::vector<std::string> parts{
      file + " using (column('time [s]')):(column('depth [m]')) with lines lw 2 lc rgb '#0072b2' title 'computed'"};
  if (has_fit) {
    parts.push_back(
        file +
        " using (column('time [s]')):(column('fit [m]')) with lines lw 2 dt (10,5) lc rgb '#d55e00' title 'fit'");
  }
  return write("scour", 490, 300,
               fill_template(embedded::script_openings,
                             {{"quantity", "depth of the scour  [m]"}, {"curves", joined_plots(parts)}}));
}

}  // namespace thalweg
