#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "postproc/figures/figure_writer.hpp"
#include "postproc/figures/script_template.hpp"
#include "postproc/figures/scripts.hpp"
#include "postproc/gnuplot.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

constexpr std::array<int, 3> curve_markers{6, 4, 8};  // open circle, square, triangle

std::string style_of_curve(const std::vector<ProfileSet>& sets, std::size_t s, std::size_t c) {
  const std::string marker =
      sets[s].kind == SourceKind::measured ? fmt::format(" pt {}", curve_markers[c]) : std::string();
  return fmt::format("{}{} lc rgb '{}'", source_style(sets, s), marker, curve_colours[c]);
}

std::string column(const Curve& curve, const PageUnit& height) {
  return fmt::format("({}*column('{} [m]'))", height.factor(), curve.name);
}

// Areas under the run's curves: water, moving sediment, sediment at rest, down to `floor` [m].
std::vector<std::string> tints_of(const std::string& file, const Profile& profile, double floor,
                                  const PageUnit& height) {
  const bool has_bed = !profile.bed.empty();
  const bool has_moving = !profile.moving_bed.empty();
  std::vector<std::string> tints;
  const auto tint = [&](const Curve& low, const Curve& high, const char* colour) {
    tints.push_back(fmt::format("{} using (column('x [m]')):{}:{} with filledcurves fc rgb '{}' notitle", file,
                                column(low, height), column(high, height), colour));
  };
  if (has_bed) tint(curves[1], curves[0], "#e3eff8");
  if (has_moving) tint(curves[2], curves[1], "#f8e3c4");
  const Curve& ground = has_moving ? curves[2] : has_bed ? curves[1] : curves[0];
  tints.push_back(fmt::format("{} using (column('x [m]')):{} with filledcurves y1={:g} fc rgb '{}' notitle", file,
                              column(ground, height), floor / height.size, has_bed ? "#ecdcc0" : "#e3eff8"));
  return tints;
}

// Names of the curves in their colours, left above the plot; the key with the sources is at the right.
std::string curve_names(const std::array<bool, 3>& shown) {
  std::string names;
  double place = 0;
  for (std::size_t c = 0; c < std::size(curves); ++c) {
    if (!shown[c]) continue;
    names += fmt::format("set label {} '■ {}' at graph {:.3f},1.07 left font ',11.5' textcolor rgb '{}'\n", c + 2,
                         curves[c].title, place, curve_colours[c]);
    place += 0.035 + 0.008 * static_cast<double>(std::string_view(curves[c].title).size());
  }
  return names;
}

}  // namespace

fs::path FigureWriter::profiles(double time, const std::vector<ProfileSet>& sets,
                                const std::vector<fs::path>& data_folders, const PictureFrame& frame,
                                const PageUnit& height) const {
  std::vector<std::string> parts;
  std::array<bool, 3> shown{};
  std::vector<std::string> sources;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const TimedProfile* timed = sets[s].at(time);
    if (timed == nullptr) continue;
    const std::string file = data(data_folders[s] / profile_file_name(timed->time));
    const Profile& profile = timed->profile;
    if (sets[s].kind == SourceKind::run) {
      for (std::string& tint : tints_of(file, profile, frame.z_from, height)) parts.push_back(std::move(tint));
    }
    for (std::size_t c = 0; c < std::size(curves); ++c) {
      if ((profile.*curves[c].values).empty()) continue;
      shown[c] = true;
      parts.push_back(fmt::format("{} using (column('x [m]')):{} {} notitle", file, column(curves[c], height),
                                  style_of_curve(sets, s, c)));
    }
    sources.push_back(fmt::format("keyentry {}{} lc rgb '{}' title {}", source_style(sets, s),
                                  sets[s].kind == SourceKind::measured ? " pt 6" : "", source_colour,
                                  gnuplot_string(sets[s].label)));
  }
  std::move(sources.begin(), sources.end(), std::back_inserter(parts));

  return write(picture_name(time), profile_area.width, profile_area.height,
               fill_template(embedded::script_profiles, {{"x_from", fmt::format("{:g}", frame.x_from)},
                                                         {"x_to", fmt::format("{:g}", frame.x_to)},
                                                         {"z_from", fmt::format("{:g}", frame.z_from / height.size)},
                                                         {"z_to", fmt::format("{:g}", frame.z_to / height.size)},
                                                         {"unit", height.name},
                                                         {"time", fmt::format("{:g}", time)},
                                                         {"left", fmt::format("{}", profile_area.left)},
                                                         {"right", fmt::format("{}", profile_area.right)},
                                                         {"top", fmt::format("{}", profile_area.top)},
                                                         {"bottom", fmt::format("{}", profile_area.bottom)},
                                                         {"curve_names", curve_names(shown)},
                                                         {"curves", joined_plots(parts)}}));
}

}  // namespace thalweg
