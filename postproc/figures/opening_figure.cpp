#include <fmt/format.h>

#include <array>
#include <cmath>

#include "postproc/figures/figure_writer.hpp"
#include "postproc/figures/script_template.hpp"
#include "postproc/figures/scripts.hpp"
#include "postproc/gnuplot.hpp"

namespace thalweg {
namespace {

/// Colours of openings, by turns; those of outlets are dashed.
constexpr std::array<const char*, 4> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7"};

std::string curve(const std::string& file, const OpeningRecord& opening, std::size_t number, const std::string& value) {
  return fmt::format("{} using (column('time [s]')):({}) with lines lw 2 {} lc rgb '{}' title {}", file, value,
                     opening.enters ? "dt 1" : "dt (10,5)", colours[number % colours.size()],
                     gnuplot_string(opening.name));
}

}  // namespace

std::filesystem::path FigureWriter::discharges(const std::filesystem::path& table, const OpeningRecords& records,
                                               const std::string& unit) const {
  std::vector<std::string> parts;
  for (std::size_t n = 0; n < records.openings.size(); ++n) {
    const OpeningRecord& opening = records.openings[n];
    const std::string column = gnuplot_string(fmt::format("{}_rate [{}]", opening.name, unit));
    parts.push_back(curve(data(table), opening, n, fmt::format("{}column({})", opening.enters ? "" : "-", column)));
  }
  return write("discharges", 490, 300,
               fill_template(embedded::script_openings,
                             {{"quantity", fmt::format("discharge  [{}]", PageUnit{unit, 1, 3}.drawn())},
                              {"curves", joined_plots(parts)}}));
}

std::filesystem::path FigureWriter::levels_at_openings(const std::filesystem::path& table,
                                                       const OpeningRecords& records, const PageUnit& height) const {
  std::vector<std::string> parts;
  for (std::size_t n = 0; n < records.openings.size(); ++n) {
    const OpeningRecord& opening = records.openings[n];
    if (std::isnan(opening.mean_level)) continue;
    const std::string column = gnuplot_string(opening.name + "_level [m]");
    parts.push_back(curve(data(table), opening, n, fmt::format("{}*column({})", height.factor(), column)));
  }
  return write("levels", 490, 300,
               fill_template(embedded::script_openings, {{"quantity", fmt::format("water level z  [{}]", height.name)},
                                                         {"curves", joined_plots(parts)}}));
}

}  // namespace thalweg
