#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "common/whole_file.hpp"
#include "postproc/figures/figure_writer.hpp"
#include "postproc/figures/script_template.hpp"
#include "postproc/figures/scripts.hpp"
#include "postproc/figures/tic_step.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

// The kinds of particles by their number in a ParticleTable, with their colours.
constexpr std::array<std::pair<const char*, const char*>, 6> particle_kinds{{{"water", "#56b4e9"},
                                                                             {"sediment", "#b0793a"},
                                                                             {"deposit", "#8c6d46"},
                                                                             {"bed load", "#e69f00"},
                                                                             {"suspended", "#d55e00"},
                                                                             {"wall", "#9a9a9a"}}};

// A picture of panels below each other: its sizes [pixels] and the parts of its script.
struct Canvas {
  static constexpr int width = 2400;
  static constexpr double left = 0.05;
  static constexpr double right = 0.92;
  static constexpr int above = 65;    // of a panel: its legend
  static constexpr int between = 80;  // panels: the numbers of the x axis
  static constexpr int below = 60;    // the title of the x axis

  PictureFrame frame;
  int panels = 1;
  int panel = 0;     // height of one
  double point = 0;  // size of a particle's dot

  Canvas(const PictureFrame& shown, int count, double spacing) : frame(shown), panels(count) {
    const double pixels_per_metre = width * (right - left) / (frame.x_to - frame.x_from);
    panel = static_cast<int>(std::clamp((frame.z_to - frame.z_from) * pixels_per_metre, 120.0, 1600.0));
    // The unit of `ps` in pngcairo is about 6.5 px of diameter for a filled circle at pointscale 1.
    point = std::max(0.15, 1.3 * spacing * pixels_per_metre / 6.5);
  }
  [[nodiscard]] int height() const { return panels * (above + panel + between) + below; }
  // A height as gnuplot's share of the screen.
  [[nodiscard]] std::string share(int pixels_from_top) const {
    return fmt::format("{:.4f}", 1 - static_cast<double>(pixels_from_top) / height());
  }
  [[nodiscard]] static std::string number(double value) { return fmt::format("{:g}", value); }
  [[nodiscard]] int top(int n) const { return n * (above + panel + between) + above; }

  // The script of a picture with these panels.
  [[nodiscard]] std::string script(const std::string& name, const std::string& panels_text) const {
    return fill_template(embedded::script_particles, {{"name", name},
                                                      {"look", std::string(embedded::script_look)},
                                                      {"width", std::to_string(width)},
                                                      {"height", std::to_string(height())},
                                                      {"x_from", number(frame.x_from)},
                                                      {"x_to", number(frame.x_to)},
                                                      {"z_from", number(frame.z_from)},
                                                      {"z_to", number(frame.z_to)},
                                                      {"x_tics", number(tic_step(frame.x_to - frame.x_from, 12))},
                                                      {"z_tics", number(tic_step(frame.z_to - frame.z_from, 4))},
                                                      {"left", fmt::format("{}", left)},
                                                      {"right", fmt::format("{}", right)},
                                                      {"panels", panels_text}});
  }
  // Panel n with its content; the last one has the title of the x axis.
  [[nodiscard]] std::string placed(int n, const std::string& content) const {
    const std::string x_title =
        n + 1 == panels ? fmt::format("set label 2 'x  [m]' at screen 0.5,{} center\n", share(height() - 22)) : "";
    return fill_template(embedded::script_particle_panel, {{"top", share(top(n))},
                                                           {"bottom", share(top(n) + panel)},
                                                           {"title_height", share(top(n) - 35)},
                                                           {"x_title", x_title},
                                                           {"content", content}});
  }
  [[nodiscard]] std::string kinds(int n, const std::string& file, const std::vector<std::size_t>& present) const {
    std::vector<std::string> parts;
    for (const std::size_t k : present) {
      parts.push_back(fmt::format(
          "{0} using (column('kind')=={1}?column('x [m]'):NaN):(column('z [m]')) with points pt 7 ps {2:.3f} "
          "lc rgb '{3}' notitle",
          file, k, point, particle_kinds[k].second));
    }
    for (const std::size_t k : present) {
      const auto& [name, colour] = particle_kinds[k];
      parts.push_back(fmt::format("keyentry with points pt 7 ps 2.2 lc rgb '{}' title '{}'", colour, name));
    }
    return placed(n, fill_template(embedded::script_particle_kinds, {{"right", fmt::format("{}", right)},
                                                                     {"title_height", share(top(n) - 35)},
                                                                     {"curves", joined_plots(parts)}}));
  }
  [[nodiscard]] std::string map(int n, const std::string& file, const char* column, double largest,
                                const char* palette) const {
    return placed(n, fill_template(embedded::script_particle_map,
                                   {{"palette", palette},
                                    {"largest", number(largest)},
                                    {"tics", number(tic_step(largest, 3))},
                                    {"bottom", share(top(n) + panel)},
                                    {"height", fmt::format("{:.4f}", static_cast<double>(panel) / height())},
                                    {"column", column},
                                    {"right", fmt::format("{}", right)},
                                    {"title_height", share(top(n) - 35)},
                                    {"table", file},
                                    {"point", fmt::format("{:.3f}", point)}}));
  }
};

// Cividis for speed, and for pressure a scale of its own, so that nobody takes one for the other.
constexpr const char* speed_palette = "0 '#00204d', 0.25 '#414d6b', 0.5 '#7c7b78', 0.75 '#bcaf6f', 1 '#ffea46'";
constexpr const char* pressure_palette = "0 '#f7fcf0', 0.33 '#a8ddb5', 0.67 '#43a2ca', 1 '#08305b'";

}  // namespace

fs::path FigureWriter::particles(const ParticleTable& table, const PictureFrame& frame, double spacing) const {
  const bool has_pressure = table.highest_pressure > 0;
  const Canvas canvas(frame, has_pressure ? 3 : 2, spacing);
  const std::string file = data(table.file);
  std::string panels = canvas.kinds(0, file, table.kinds) +
                       canvas.map(1, file, "speed [m/s]", table.fastest > 0 ? table.fastest : 1, speed_palette);
  if (has_pressure) panels += canvas.map(2, file, "pressure [Pa]", table.highest_pressure, pressure_palette);
  write_whole_text(script("particles"), [&](std::ostream& stream) { stream << canvas.script("particles", panels); });
  return script("particles");
}

fs::path FigureWriter::scene(const ParticleTable& table, const PictureFrame& frame, double spacing) const {
  const Canvas canvas(frame, 1, spacing);
  const std::string panel = canvas.kinds(0, data(table.file), table.kinds);
  write_whole_text(script("scene"), [&](std::ostream& stream) { stream << canvas.script("scene", panel); });
  return script("scene");
}

}  // namespace thalweg
