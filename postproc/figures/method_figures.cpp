#include "postproc/figures/method_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "common/csv.hpp"
#include "postproc/figures/script_template.hpp"
#include "postproc/figures/scripts.hpp"
#include "postproc/gnuplot.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 4> method_colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7"};
constexpr std::array<const char*, 4> method_tints{"#9cc9e6", "#f3bd94", "#94d3bd", "#e8c5d8"};

// Fine and coarse mesh at one time on the fine mesh's points: the band between them.
fs::path write_band(const fs::path& folder, const Method& method, double time) {
  const TimedProfile* fine = method.runs[0].profiles.at(time);
  const TimedProfile* coarse = method.runs[1].profiles.at(time);
  if (fine == nullptr || coarse == nullptr) return {};
  CsvTable table({{"x", "m"}, {"free_surface", "m"}, {"free_surface_coarse", "m"}, {"bed", "m"}, {"bed_coarse", "m"}});
  const auto at = [](const Profile& of, const std::vector<double>& values, double x) {
    if (values.empty()) return Profile::missing;
    const auto after = std::ranges::upper_bound(of.x, x);
    if (after == of.x.begin()) return values.front();
    if (after == of.x.end()) return values.back();
    const auto i = static_cast<std::size_t>(after - of.x.begin());
    return std::lerp(values[i - 1], values[i], (x - of.x[i - 1]) / (of.x[i] - of.x[i - 1]));
  };
  for (const double x : fine->profile.x) {
    std::vector<std::string> row{csv_number(x)};
    for (const Curve& curve : {curves[0], curves[1]}) {
      row.push_back(csv_number(at(fine->profile, fine->profile.*curve.values, x)));
      row.push_back(csv_number(at(coarse->profile, coarse->profile.*curve.values, x)));
    }
    table.add_row(std::move(row));
  }
  fs::path file = folder / (folder_name_of(method.name) + "_" + profile_file_name(time));
  table.write(file);
  return file;
}

// The bands and lines of all mesh models at one time; empty without any.
std::vector<std::string> band_plots(const FigureWriter& writer, const fs::path& folder,
                                    const std::vector<Method>& methods, double time, const PageUnit& height) {
  std::vector<std::string> parts;
  std::size_t colour = 0;
  for (const Method& method : methods) {
    ++colour;
    if (!has_band(method)) continue;
    const fs::path file = write_band(folder, method, time);
    if (file.empty()) continue;
    const std::size_t c = (colour - 1) % method_colours.size();
    const std::string data = writer.data(file);
    for (const char* curve : {"free_surface", "bed"}) {
      parts.insert(parts.begin(),
                   fmt::format("{0} using (column('x [m]')):({3}*column('{1} [m]')):({3}*column('{1}_coarse [m]')) "
                               "with filledcurves fs transparent solid 0.6 noborder fc rgb '{2}' notitle",
                               data, curve, method_tints[c], height.factor()));
      parts.push_back(
          fmt::format("{} using (column('x [m]')):({}*column('{} [m]')) with lines lw 1.6 lc rgb '{}' {}", data,
                      height.factor(), curve, method_colours[c],
                      std::string(curve) == "bed" ? "title " + gnuplot_string(method.runs[0].label) : "notitle"));
    }
  }
  return parts;
}

// The figure of one time, or nothing without any mesh model to show.
std::optional<fs::path> band_script(const FigureWriter& writer, const fs::path& folder,
                                    const std::vector<Method>& methods, const ProfileSet& particles,
                                    const TimedProfile& timed, const PictureFrame& frame, const PageUnit& height) {
  std::vector<std::string> parts = band_plots(writer, folder, methods, timed.time, height);
  if (parts.empty()) return std::nullopt;
  for (const char* curve : {"free_surface", "bed"}) {
    parts.push_back(
        fmt::format("{} using (column('x [m]')):({}*column('{} [m]')) with lines lw 1.8 lc rgb '#1a1a1a' {}",
                    writer.data(timed.file), height.factor(), curve,
                    std::string(curve) == "bed" ? "title " + gnuplot_string(particles.label) : "notitle"));
  }
  return writer.write("band_" + picture_name(timed.time), 1000, 270,
                      fill_template(embedded::script_band, {{"x_from", fmt::format("{:g}", frame.x_from)},
                                                            {"x_to", fmt::format("{:g}", frame.x_to)},
                                                            {"z_from", fmt::format("{:g}", frame.z_from / height.size)},
                                                            {"z_to", fmt::format("{:g}", frame.z_to / height.size)},
                                                            {"unit", height.name},
                                                            {"time", fmt::format("{:g}", timed.time)},
                                                            {"curves", joined_plots(parts)}}));
}

// True if some coarser run has a distance in a curve, which a logarithmic axis can show.
bool has_distance(const std::vector<Method>& methods, double MethodRun::*distance) {
  return std::ranges::any_of(methods, [&](const Method& method) {
    return std::ranges::any_of(method.runs, [&](const MethodRun& run) { return run.*distance > 0; });
  });
}

// Distances of the bed, or of the free surface where there is no bed.
std::optional<fs::path> cost_script(const FigureWriter& writer, const fs::path& costs,
                                    const std::vector<Method>& methods, const PageUnit& height) {
  const bool has_bed = has_distance(methods, &MethodRun::error_bed);
  if (!has_bed && !has_distance(methods, &MethodRun::error_free_surface)) return std::nullopt;
  std::vector<std::string> parts;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    if (methods[m].runs.size() < 2) continue;
    parts.push_back(fmt::format(
        "{} using (strcol('method') eq {} ? column('cpu [s]') : NaN):({}*column('error_{} "
        "[m]')) with linespoints pt {} ps 1 lw 1.8 lc rgb '{}' title {}",
        writer.data(costs), gnuplot_string(methods[m].name), height.factor(), has_bed ? "bed" : "free_surface",
        5 + 2 * (m % 4), method_colours[m % method_colours.size()], gnuplot_string(methods[m].name)));
  }
  if (parts.empty()) return std::nullopt;
  return writer.write("cost", 490, 300,
                      fill_template(embedded::script_cost, {{"unit", height.name},
                                                            {"title", has_bed ? "bed" : "free surface"},
                                                            {"curves", joined_plots(parts)}}));
}

}  // namespace

bool has_band(const Method& method) {
  return method.runs.size() > 1 && method.runs.front().profiles.kind == SourceKind::mesh;
}

std::vector<fs::path> method_scripts(const std::vector<Method>& methods, const ProfileSet& particles,
                                     const PictureFrame& frame, const RunFolder& run, const PageUnit& height) {
  const FigureWriter writer(run.report() / "pictures");
  std::vector<fs::path> scripts;
  for (const TimedProfile& timed : particles.profiles) {
    const auto script = band_script(writer, run.report() / "data" / "bands", methods, particles, timed, frame, height);
    if (script) scripts.push_back(*script);
  }
  if (const auto script = cost_script(writer, run.report() / "cost.csv", methods, height)) scripts.push_back(*script);
  return scripts;
}

}  // namespace thalweg
