#include "postproc/figures.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>

#include "common/whole_file.hpp"
#include "postproc/figure_look.hpp"
#include "postproc/gnuplot.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

constexpr const char* source_colour = "#444444";
constexpr std::array<int, 3> curve_markers{6, 4, 8};  // open circle, square, triangle

std::string source_style(const std::vector<ProfileSet>& sets, std::size_t s) {
  if (sets[s].kind == SourceKind::measured) return "with points lw 1.3 ps 0.7";
  const std::string dashes = dashes_of_source(sets, s);
  return dashes.empty() ? "with lines lw 2.2 dt 1" : fmt::format("with lines lw 1.8 dt ({})", dashes);
}

std::string style_of_curve(const std::vector<ProfileSet>& sets, std::size_t s, std::size_t c) {
  const std::string marker =
      sets[s].kind == SourceKind::measured ? fmt::format(" pt {}", curve_markers[c]) : std::string();
  return fmt::format("{}{} lc rgb '{}'", source_style(sets, s), marker, curve_colours[c]);
}

int front_marker(const std::vector<ProfileSet>& sets, std::size_t s) {
  if (sets[s].kind == SourceKind::measured) return 6;  // circle
  constexpr std::array others{8, 4, 10, 12};           // triangle, square, triangle down, diamond
  const auto earlier = std::count_if(
      sets.begin(), sets.begin() + static_cast<std::ptrdiff_t>(s),
      [](const ProfileSet& set) { return set.kind == SourceKind::mesh || set.kind == SourceKind::other; });
  return others[static_cast<std::size_t>(earlier) % others.size()];
}

}  // namespace

std::string dashes_of_source(const std::vector<ProfileSet>& sets, std::size_t s) {
  const auto nth_of_kind =
      static_cast<std::size_t>(std::count_if(sets.begin(), sets.begin() + static_cast<std::ptrdiff_t>(s),
                                             [&](const ProfileSet& earlier) { return earlier.kind == sets[s].kind; }));
  constexpr std::array mesh_dashes{"10,5", "2,4", "14,4,2,4"};
  constexpr std::array other_dashes{"12,4,2,4", "5,3", "2,7"};
  if (sets[s].kind == SourceKind::mesh) return mesh_dashes[nth_of_kind % 3];
  return sets[s].kind == SourceKind::other ? other_dashes[nth_of_kind % 3] : "";
}

PictureFrame frame_around(const std::vector<ProfileSet>& sets, double from, double to) {
  const double infinite = std::numeric_limits<double>::infinity();
  PictureFrame frame{infinite, -infinite, infinite, -infinite};
  for (const ProfileSet& set : sets) {
    for (const TimedProfile& timed : set.profiles) {
      for (const Curve& curve : curves) {
        const std::vector<double>& values = timed.profile.*curve.values;
        for (std::size_t i = 0; i < values.size(); ++i) {
          if (std::isnan(values[i])) continue;
          frame.x_from = std::min(frame.x_from, timed.profile.x[i]);
          frame.x_to = std::max(frame.x_to, timed.profile.x[i]);
          frame.z_from = std::min(frame.z_from, values[i]);
          frame.z_to = std::max(frame.z_to, values[i]);
        }
      }
    }
  }
  if (!(frame.x_from < frame.x_to)) return {};
  if (to > from) {
    frame.x_from = from;
    frame.x_to = to;
  }
  // A floor at zero is worth showing where the curves are not far above it.
  if (frame.z_from > 0 && frame.z_from < frame.z_to) frame.z_from = 0;
  frame.z_to += 0.08 * (frame.z_to - frame.z_from) + 1e-6;
  return frame;
}

std::string folder_name_of(const std::string& label) {
  std::string name;
  for (const char c : label) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (plain) name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (!plain && !name.empty() && name.back() != '_') name += '_';
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  return name.empty() ? "source" : name;
}

std::string FigureWriter::data(const fs::path& file) const {
  return gnuplot_string(fs::absolute(file).lexically_relative(fs::absolute(folder_)).generic_string());
}

fs::path FigureWriter::write(const std::string& name, int width, int height, const std::string& settings,
                             const std::string& plot) const {
  const fs::path script = folder_ / (name + ".gp");
  write_whole_text(script, [&](std::ostream& stream) {
    fmt::print(stream, "# Draws {0}.svg and {0}.png from the CSV files it names: gnuplot {0}.gp\n", name);
    stream << figure_look << settings;
    fmt::print(stream,
               "set terminal svg size {1},{2} dynamic font 'Helvetica,13' noenhanced\n"
               "set output '{0}.svg'\n"
               "{3}\n"
               "set terminal pngcairo size {4},{5} font 'sans,13' fontscale 1.9 linewidth 2 pointscale 2 noenhanced\n"
               "set output '{0}.png'\n"
               "replot\n",
               name, width, height, plot, 2 * width, 2 * height);
  });
  return script;
}

fs::path FigureWriter::profiles(double time, const std::vector<ProfileSet>& sets,
                                const std::vector<fs::path>& data_folders, const PictureFrame& frame) const {
  std::vector<std::string> parts;
  std::array<bool, 3> shown{};
  std::vector<std::string> sources;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const TimedProfile* timed = sets[s].at(time);
    if (timed == nullptr) continue;
    const std::string file = data(data_folders[s] / profile_file_name(timed->time));
    const auto column = [](const Curve& curve) { return fmt::format("(1e3*column('{} [m]'))", curve.name); };
    const std::string x = "(column('x [m]'))";
    const Profile& profile = timed->profile;
    if (sets[s].kind == SourceKind::run) {  // tints: water, moving sediment, sediment at rest
      const auto tint = [&](const Curve& low, const Curve& high, const char* colour) {
        parts.push_back(fmt::format("{} using {}:{}:{} with filledcurves fc rgb '{}' notitle", file, x, column(low),
                                    column(high), colour));
      };
      const bool has_bed = !profile.bed.empty();
      const bool has_moving = !profile.moving_bed.empty();
      if (has_bed) tint(curves[1], curves[0], "#e3eff8");
      if (has_moving) tint(curves[2], curves[1], "#f8e3c4");
      const Curve& ground = has_moving ? curves[2] : has_bed ? curves[1] : curves[0];
      parts.push_back(fmt::format("{} using {}:{} with filledcurves y1={:g} fc rgb '{}' notitle", file, x,
                                  column(ground), 1e3 * frame.z_from, has_bed ? "#ecdcc0" : "#e3eff8"));
    }
    for (std::size_t c = 0; c < std::size(curves); ++c) {
      if ((profile.*curves[c].values).empty()) continue;
      shown[c] = true;
      parts.push_back(fmt::format("{} using {}:{} {} notitle", file, x, column(curves[c]), style_of_curve(sets, s, c)));
    }
    sources.push_back(fmt::format("keyentry {}{} lc rgb '{}' title {}", source_style(sets, s),
                                  sets[s].kind == SourceKind::measured ? " pt 6" : "", source_colour,
                                  gnuplot_string(sets[s].label)));
  }
  std::string names;  // of the curves, in their colours, left above the plot; the key with the sources is at the right
  double place = 0;
  for (std::size_t c = 0; c < std::size(curves); ++c) {
    if (!shown[c]) continue;
    names += fmt::format("set label {} '■ {}' at graph {:.3f},1.07 left font ',11.5' textcolor rgb '{}'\n", c + 2,
                         curves[c].title, place, curve_colours[c]);
    place += 0.035 + 0.008 * static_cast<double>(std::string_view(curves[c].title).size());
  }
  std::move(sources.begin(), sources.end(), std::back_inserter(parts));

  const std::string settings =
      fmt::format(
          "set xrange [{:g}:{:g}]\nset yrange [{:g}:{:g}]\n"
          "set xlabel 'x  [m]' offset 0,0.4\nset ylabel 'z  [mm]' offset 1,0\n"
          "set key outside top right horizontal maxrows 1 samplen 2.2 width -4 font ',11.5' textcolor rgb '#333333'\n"
          "set label 1 't = {:g} s' at graph 0.985,0.88 right font ',16' front\n"
          "set lmargin at screen {}\nset rmargin at screen {}\nset tmargin at screen {}\nset bmargin at screen {}\n",
          frame.x_from, frame.x_to, 1e3 * frame.z_from, 1e3 * frame.z_to, time, profile_area.left, profile_area.right,
          profile_area.top, profile_area.bottom) +
      names;
  std::string name = profile_file_name(time);
  name.resize(name.rfind('.'));
  return write(name, profile_area.width, profile_area.height, settings,
               fmt::format("plot {}", fmt::join(parts, ", \\\n     ")));
}

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
  return write("front", 490, 300,
               "set xlabel 't  [s]' offset 0,0.4\nset ylabel 'x of the water front  [m]' offset 1,0\n"
               "set key top left reverse Left samplen 2\nset bmargin 2.8\nset rmargin 2\nset xrange [0:*]\n"
               "set offsets 0,0,graph 0.06,graph 0.06\n",
               fmt::format("plot {}", fmt::join(parts, ", \\\n     ")));
}

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
  return write(
      "energies", 490, 300,
      fmt::format(
          "set xlabel 't  [s]' offset 0,0.4\nset ylabel 'energy  [{}]' offset 1,0\n"
          "set key outside top center horizontal maxrows 2 samplen 2.4 width 1\nset bmargin 2.8\nset rmargin 2\n",
          unit),
      fmt::format("plot {}", fmt::join(parts, ", \\\n     ")));
}

}  // namespace thalweg
