#include "postproc/figures/figure_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/whole_file.hpp"
#include "postproc/figures/script_template.hpp"
#include "postproc/figures/scripts.hpp"
#include "postproc/gnuplot.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

fs::path write_picture(const fs::path& script, int width, int height, const std::string& settings,
                       const std::string& plot, const std::string& plot_again) {
  write_whole_text(script, [&](std::ostream& stream) {
    stream << fill_template(embedded::script_picture, {{"name", script.stem().string()},
                                                       {"look", std::string(embedded::script_look)},
                                                       {"settings", settings},
                                                       {"width", std::to_string(width)},
                                                       {"height", std::to_string(height)},
                                                       {"png_width", std::to_string(2 * width)},
                                                       {"png_height", std::to_string(2 * height)},
                                                       {"plot", plot},
                                                       {"plot_again", plot_again}});
  });
  return script;
}

std::string without_last_newline(std::string text) {
  if (text.ends_with('\n')) text.pop_back();
  return text;
}

}  // namespace

std::string FigureWriter::data(const fs::path& file) const {
  return gnuplot_string(fs::absolute(file).lexically_relative(fs::absolute(folder_)).generic_string());
}

fs::path FigureWriter::write(const std::string& name, int width, int height, const std::string& body) const {
  const std::size_t plot = body.find("\nplot ") + 1;
  return write_picture(script(name), width, height, body.substr(0, plot), without_last_newline(body.substr(plot)),
                       "replot");
}

fs::path FigureWriter::write_multiplot(const std::string& name, int width, int height, const std::string& settings,
                                       const std::string& plots) const {
  const std::string body = without_last_newline(plots);
  return write_picture(script(name), width, height, settings, body, body);
}

std::string picture_name(double time) { return fs::path(profile_file_name(time)).stem().string(); }

std::string joined_plots(const std::vector<std::string>& plots) {
  return fmt::format("{}", fmt::join(plots, ", \\\n     "));
}

}  // namespace thalweg
