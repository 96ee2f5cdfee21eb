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
constexpr std::array<std::pair<const char*, const char*>, 5> particle_kinds{{{"water", "#56b4e9"},
                                                                             {"sediment", "#b0793a"},
                                                                             {"deposit", "#8c6d46"},
                                                                             {"bed load", "#e69f00"},
                                                                             {"suspended", "#d55e00"}}};

}  // namespace

fs::path FigureWriter::particles(const ParticleTable& table, const PictureFrame& frame, double spacing) const {
  const double fastest = table.fastest > 0 ? table.fastest : 1;
  const double width = frame.x_to - frame.x_from;
  const double height = frame.z_to - frame.z_from;
  constexpr int pixels = 2400;
  constexpr double margin_left = 0.05;
  constexpr double margin_right = 0.94;
  const double pixels_per_metre = pixels * (margin_right - margin_left) / width;
  const int panel = static_cast<int>(std::clamp(height * pixels_per_metre, 120.0, 1600.0));
  const int total = 2 * panel + 300;
  // The unit of `ps` in pngcairo is about 6.5 px of diameter for a filled circle at pointscale 1.
  const double point = std::max(0.15, 1.3 * spacing * pixels_per_metre / 6.5);
  const auto share = [&](int pixel) { return static_cast<double>(pixel) / total; };

  const fs::path script = folder_ / "particles.gp";
  write_whole_text(script, [&](std::ostream& stream) {
    fmt::print(stream, "# Draws particles.png from the CSV file it names: gnuplot particles.gp\n{}", figure_look);
    fmt::print(stream,
               "set terminal pngcairo size {},{} font 'sans,13' fontscale 2 linewidth 2 noenhanced\n"
               "set output 'particles.png'\n"
               "set multiplot\nunset grid\nset size ratio -1\n"
               "set xrange [{:g}:{:g}]\nset yrange [{:g}:{:g}]\nset xtics {:g}\nset ytics {:g}\n"
               "set lmargin at screen {}\nset rmargin at screen {}\n",
               pixels, total, frame.x_from, frame.x_to, frame.z_from, frame.z_to, tic_step(width, 12),
               tic_step(height, 4), margin_left, margin_right);
    fmt::print(stream,
               "set label 1 'z  [m]' at screen 0.005,{:.4f} left\n"
               "set tmargin at screen {:.4f}\nset bmargin at screen {:.4f}\n"
               "set key at screen 0.94,{:.4f} right horizontal samplen 0.6 width 1\n",
               1 - share(30), 1 - share(65), 1 - share(65 + panel), 1 - share(30));
    const std::string file = data(table.file);
    std::vector<std::string> parts;
    for (const std::size_t k : table.kinds) {
      parts.push_back(fmt::format(
          "{0} using (column('kind')=={1}?column('x [m]'):NaN):(column('z [m]')) with points pt 7 ps {2:.3f} "
          "lc rgb '{3}' notitle",
          file, k, point, particle_kinds[k].second));
    }
    for (const std::size_t k : table.kinds) {
      const auto& [name, colour] = particle_kinds[k];
      parts.push_back(fmt::format("keyentry with points pt 7 ps 2.2 lc rgb '{}' title '{}'", colour, name));
    }
    fmt::print(stream, "plot {}\n", fmt::join(parts, ", \\\n     "));
    fmt::print(stream,
               "set tmargin at screen {:.4f}\nset bmargin at screen {:.4f}\nunset key\nunset label 1\n"
               "set palette defined (0 '#00204d', 0.25 '#414d6b', 0.5 '#7c7b78', 0.75 '#bcaf6f', 1 '#ffea46')\n"
               "set cbrange [0:{:g}]\nset cbtics scale 0.4 {:g}\n"
               "set colorbox user origin 0.95,{:.4f} size 0.008,{:.4f}\n"
               "set label 2 'speed  [m/s]' at screen 0.94,{:.4f} right\n"
               "set label 3 'x  [m]' at screen 0.5,{:.4f} center\n"
               "plot {} using (column('x [m]')):(column('z [m]')):(column('speed [m/s]')) with points pt 7 ps {:.3f} "
               "palette notitle\nunset multiplot\n",
               share(105 + panel), share(105), fastest, tic_step(fastest, 3), share(105), share(panel),
               share(105 + panel + 28), share(22), file, point);
  });
  return script;
}

ParticleTable write_particle_table(const fs::path& file, const ParticleSet& particles, double plane_y,
                                   std::size_t limit) {
  ParticleTable table{file, {}, 0};
  const double half = particles.info.spacing / 2;
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const bool in_plane = particles.info.dimension == 2 || std::abs(particles.position[i].y() - plane_y) <= half;
    if (is_fluid(particles.type[i]) && in_plane) shown.push_back(i);
  }
  const std::size_t every = std::max<std::size_t>(1, (shown.size() + limit - 1) / std::max<std::size_t>(1, limit));
  std::set<std::size_t> kinds;
  write_whole_text(file, [&](std::ostream& stream) {
    fmt::print(stream, "# t = {:g} s; every {}. particle\nx [m],z [m],kind,speed [m/s]\n", particles.info.time, every);
    for (std::size_t n = 0; n < shown.size(); n += every) {
      const std::size_t i = shown[n];
      const std::size_t state = particles.state.empty() ? 0 : static_cast<std::size_t>(particles.state[i]);
      const std::size_t kind = particles.type[i] == ParticleType::water ? 0 : state + 1;
      kinds.insert(kind);
      const float speed = particles.velocity.empty() ? 0.F : particles.velocity[i].norm();
      table.fastest = std::max(table.fastest, static_cast<double>(speed));
      fmt::print(stream, "{:.6g},{:.6g},{},{:.5g}\n", particles.position[i].x(), particles.position[i].z(), kind,
                 speed);
    }
  });
  table.kinds.assign(kinds.begin(), kinds.end());
  return table;
}

}  // namespace thalweg
