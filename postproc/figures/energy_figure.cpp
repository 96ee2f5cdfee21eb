#include <fmt/format.h>

#include "postproc/figures/figure_writer.hpp"
#include "postproc/figures/script_template.hpp"
#include "postproc/figures/scripts.hpp"

namespace thalweg {

namespace fs = std::filesystem;

fs::path FigureWriter::energies(const fs::path& history, bool has_internal, const std::string& unit) const {
  const std::string file = data(history);
  const auto series = [&](const char* column, bool from_start) {
    const std::string value = fmt::format("column('{} [J]')", column);
    // Each series keeps its first value in a variable of its own, so that changes count from the start.
    return from_start ? fmt::format("({0}_0=($0==0?{1}:{0}_0), {1}-{0}_0)", column, value) : "(" + value + ")";
  };
  const auto line = [&](const std::string& value, const char* style, const char* title) {
    return fmt::format("{} using (column('time [s]')):{} with lines {} title '{}'", file, value, style, title);
  };
  std::vector<std::string> parts{
      line(series("kinetic_energy", false), "lw 2.2 dt 1 lc rgb '#0072b2'", "kinetic"),
      line(series("potential_energy", true), "lw 2.2 dt (10,5) lc rgb '#d55e00'", "potential, change"),
  };
  std::string sum = "(" + series("potential_energy", true) + "+" + series("kinetic_energy", false);
  if (has_internal) {
    parts.push_back(line(series("internal_energy", true), "lw 2.2 dt (2,4) lc rgb '#009e73'", "internal, change"));
    sum += "+" + series("internal_energy", true);
  }
  parts.push_back(line(sum + ")", "lw 1.6 dt 1 lc rgb '#1a1a1a'", "sum"));
  return write("energies", 490, 300,
               fill_template(embedded::script_energies, {{"unit", unit}, {"curves", joined_plots(parts)}}));
}

}  // namespace thalweg
