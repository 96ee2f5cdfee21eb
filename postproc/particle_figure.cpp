#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "common/extraction/volume_fraction.hpp"
#include "common/whole_file.hpp"
#include "postproc/figure_look.hpp"
#include "postproc/figures.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

// What a particle can be in a particle table, by its number there, and its colour.
constexpr std::array<std::pair<const char*, const char*>, 6> particle_kinds{{{"water", "#56b4e9"},
                                                                             {"sediment", "#b0793a"},
                                                                             {"deposit", "#8c6d46"},
                                                                             {"bed load", "#e69f00"},
                                                                             {"suspended", "#d55e00"},
                                                                             {"wall", "#9a9a9a"}}};
constexpr std::size_t wall_kind = 5;

// Sizes of a picture of panels under each other, and what its script repeats [pixels].
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
  [[nodiscard]] double share(int pixels_from_top) const { return 1 - static_cast<double>(pixels_from_top) / height(); }
  [[nodiscard]] int top(int n) const { return n * (above + panel + between) + above; }

  void begin(std::ostream& stream, const std::string& name) const {
    fmt::print(stream,
               "# Draws {0}.png from the CSV file it names: gnuplot {0}.gp\n{1}"
               "set terminal pngcairo size {2},{3} font 'sans,13' fontscale 2 linewidth 2 noenhanced\n"
               "set output '{0}.png'\nset multiplot\nunset grid\nset size ratio -1\n"
               "set xrange [{4:g}:{5:g}]\nset yrange [{6:g}:{7:g}]\nset xtics {8:g}\nset ytics {9:g}\n"
               "set lmargin at screen {10}\nset rmargin at screen {11}\n",
               name, figure_look, width, height(), frame.x_from, frame.x_to, frame.z_from, frame.z_to,
               tic_step(frame.x_to - frame.x_from, 12), tic_step(frame.z_to - frame.z_from, 4), left, right);
  }
  void place(std::ostream& stream, int n) const {
    fmt::print(stream,
               "unset label\nset tmargin at screen {0:.4f}\nset bmargin at screen {1:.4f}\n"
               "set label 1 'z  [m]' at screen 0.005,{2:.4f} left\n",
               share(top(n)), share(top(n) + panel), share(top(n) - 35));
    if (n + 1 == panels) fmt::print(stream, "set label 2 'x  [m]' at screen 0.5,{:.4f} center\n", share(height() - 22));
  }
  void kinds(std::ostream& stream, int n, const std::string& file, const std::vector<std::size_t>& present) const {
    place(stream, n);
    fmt::print(stream, "set key at screen {},{:.4f} right horizontal samplen 0.6 width 1\n", right, share(top(n) - 35));
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
    fmt::print(stream, "plot {}\nunset key\n", fmt::join(parts, ", \\\n     "));
  }
  void map(std::ostream& stream, int n, const std::string& file, const char* column, double largest,
           const char* palette) const {
    place(stream, n);
    fmt::print(stream,
               "set palette defined ({0})\nset cbrange [0:{1:g}]\nset cbtics scale 0.4 {2:g}\n"
               "set colorbox user origin 0.93,{3:.4f} size 0.008,{4:.4f}\n"
               "set label 3 '{5}' at screen {6},{7:.4f} right\n"
               "plot {8} using (column('x [m]')):(column('z [m]')):(column('{5}')) with points pt 7 ps {9:.3f} "
               "palette notitle\n",
               palette, largest, tic_step(largest, 3), share(top(n) + panel), static_cast<double>(panel) / height(),
               column, right, share(top(n) - 35), file, point);
  }
};

// Cividis for speed, and for pressure a scale of its own, so that nobody takes one for the other.
constexpr const char* speed_palette = "0 '#00204d', 0.25 '#414d6b', 0.5 '#7c7b78', 0.75 '#bcaf6f', 1 '#ffea46'";
constexpr const char* pressure_palette = "0 '#f7fcf0', 0.33 '#a8ddb5', 0.67 '#43a2ca', 1 '#08305b'";

}  // namespace

fs::path FigureWriter::particles(const ParticleTable& table, const PictureFrame& frame, double spacing) const {
  const bool has_pressure = table.highest_pressure > 0;
  const Canvas canvas(frame, has_pressure ? 3 : 2, spacing);
  const fs::path script = folder_ / "particles.gp";
  write_whole_text(script, [&](std::ostream& stream) {
    canvas.begin(stream, "particles");
    const std::string file = data(table.file);
    canvas.kinds(stream, 0, file, table.kinds);
    canvas.map(stream, 1, file, "speed [m/s]", table.fastest > 0 ? table.fastest : 1, speed_palette);
    if (has_pressure) canvas.map(stream, 2, file, "pressure [Pa]", table.highest_pressure, pressure_palette);
    fmt::print(stream, "unset multiplot\n");
  });
  return script;
}

fs::path FigureWriter::scene(const ParticleTable& table, const PictureFrame& frame, double spacing) const {
  const Canvas canvas(frame, 1, spacing);
  const fs::path script = folder_ / "scene.gp";
  write_whole_text(script, [&](std::ostream& stream) {
    canvas.begin(stream, "scene");
    canvas.kinds(stream, 0, data(table.file), table.kinds);
    fmt::print(stream, "unset multiplot\n");
  });
  return script;
}

ParticleTable write_particle_table(const fs::path& file, const ParticleSet& particles, double plane_y,
                                   std::size_t limit, bool with_walls) {
  ParticleTable table{file, {}, 0, 0};
  const double half = particles.info.spacing / 2;
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const bool in_plane = particles.info.dimension == 2 || std::abs(particles.position[i].y() - plane_y) <= half;
    if ((with_walls || is_fluid(particles.type[i])) && in_plane) shown.push_back(i);
  }
  const std::size_t every = std::max<std::size_t>(1, (shown.size() + limit - 1) / std::max<std::size_t>(1, limit));
  std::set<std::size_t> kinds;
  write_whole_text(file, [&](std::ostream& stream) {
    fmt::print(stream, "# t = {:g} s; every {}. particle\nx [m],z [m],kind,speed [m/s],pressure [Pa]\n",
               particles.info.time, every);
    for (std::size_t n = 0; n < shown.size(); n += every) {
      const std::size_t i = shown[n];
      const std::size_t state = particles.state.empty() ? 0 : static_cast<std::size_t>(particles.state[i]);
      const std::size_t kind = is_wall(particles.type[i])                 ? wall_kind
                               : particles.type[i] == ParticleType::water ? 0
                                                                          : state + 1;
      kinds.insert(kind);
      const float speed = particles.velocity.empty() ? 0.F : particles.velocity[i].norm();
      const float pressure = particles.pressure.empty() ? 0.F : particles.pressure[i];
      table.fastest = std::max(table.fastest, static_cast<double>(speed));
      table.highest_pressure = std::max(table.highest_pressure, static_cast<double>(pressure));
      fmt::print(stream, "{:.6g},{:.6g},{},{:.5g},{:.5g}\n", particles.position[i].x(), particles.position[i].z(), kind,
                 speed, pressure);
    }
  });
  table.kinds.assign(kinds.begin(), kinds.end());
  return table;
}

}  // namespace thalweg
