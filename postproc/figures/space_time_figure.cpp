#include <fmt/format.h>

#include "common/whole_file.hpp"
#include "postproc/figures/figure_writer.hpp"
#include "postproc/figures/script_template.hpp"
#include "postproc/figures/scripts.hpp"

namespace thalweg {

namespace fs = std::filesystem;

// Brown where the bed has risen, blue-green where it has sunk (ColorBrewer's BrBG). The boxes overlap by a tenth,
// because the smoothing of their edges would draw a grid.
fs::path FigureWriter::space_time(const fs::path& table, const fs::path& front, const PictureFrame& frame,
                                  double spacing, double largest, const PageUnit& height) const {
  const auto number = [](double value) { return fmt::format("{:g}", value); };
  write_whole_text(script("space_time"), [&](std::ostream& stream) {
    stream << fill_template(embedded::script_space_time, {{"look", std::string(embedded::script_look)},
                                                          {"x_from", number(frame.x_from)},
                                                          {"x_to", number(frame.x_to)},
                                                          {"unit", height.name},
                                                          {"factor", height.factor()},
                                                          {"lowest", number(-largest / height.size)},
                                                          {"highest", number(largest / height.size)},
                                                          {"changes", data(table)},
                                                          {"half", number(0.55 * spacing)},
                                                          {"front", data(front)}});
  });
  return script("space_time");
}

}  // namespace thalweg
