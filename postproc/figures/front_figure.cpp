#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "postproc/figures/figure_writer.hpp"
#include "postproc/figures/script_template.hpp"
#include "postproc/figures/scripts.hpp"
#include "postproc/gnuplot.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

int front_marker(const std::vector<ProfileSet>& sets, std::size_t s) {
  if (sets[s].kind == SourceKind::measured) return 6;  // circle
  constexpr std::array others{8, 4, 10, 12};           // triangle, square, triangle down, diamond
  const auto earlier = std::count_if(
      sets.begin(), sets.begin() + static_cast<std::ptrdiff_t>(s),
      [](const ProfileSet& set) { return set.kind == SourceKind::mesh || set.kind == SourceKind::other; });
  return others[static_cast<std::size_t>(earlier) % others.size()];
}

}  // namespace

fs::path FigureWriter::front(const fs::path& front, const fs::path& fronts, const std::vector<ProfileSet>& sets) const {
  std::vector<std::string> parts;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    if (sets[s].kind == SourceKind::run) {
      parts.push_back(
          fmt::format("{} using (column('time [s]')):(column('front [m]')) with lines lw 2.2 lc rgb '{}' title {}",
                      data(front), curve_colours[0], gnuplot_string(sets[s].label)));
      continue;
    }
    parts.push_back(fmt::format(
        "{} using (column('time [s]')):(column({})) with points pt {} ps 1 lw 1.6 lc rgb '{}' title {}", data(fronts),
        gnuplot_string(sets[s].label + " [m]"), front_marker(sets, s), source_colour, gnuplot_string(sets[s].label)));
  }
  return write("front", 490, 300, fill_template(embedded::script_front, {{"curves", joined_plots(parts)}}));
}

}  // namespace thalweg
