// Both methods side by side: how sure each mesh model is of itself, and what speed and error cost.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "common/csv.hpp"
#include "postproc/figures.hpp"
#include "postproc/gnuplot.hpp"
#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"

namespace thalweg::report_sections {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 4> method_colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7"};
constexpr std::array<const char*, 4> method_tints{"#9cc9e6", "#f3bd94", "#94d3bd", "#e8c5d8"};

std::string millimetres(double metres) { return std::isnan(metres) ? "–" : fmt::format("{:.1f}", 1e3 * metres); }

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

bool has_band(const Method& method) {
  return method.runs.size() > 1 && method.runs.front().profiles.kind == SourceKind::mesh;
}

}  // namespace

std::vector<fs::path> method_scripts(const std::vector<Method>& methods, const ProfileSet& particles,
                                     const PictureFrame& frame, const RunFolder& run) {
  const FigureWriter writer(run.report() / "pictures");
  const fs::path bands = run.report() / "data" / "bands";
  std::vector<fs::path> scripts;
  for (const TimedProfile& timed : particles.profiles) {
    std::vector<std::string> parts;
    std::size_t colour = 0;
    for (const Method& method : methods) {
      ++colour;
      if (!has_band(method)) continue;
      const fs::path file = write_band(bands, method, timed.time);
      if (file.empty()) continue;
      const std::size_t c = (colour - 1) % method_colours.size();
      const std::string data = writer.data(file);
      for (const char* curve : {"free_surface", "bed"}) {
        parts.insert(parts.begin(),
                     fmt::format("{0} using (column('x [m]')):(1e3*column('{1} [m]')):(1e3*column('{1}_coarse [m]')) "
                                 "with filledcurves fs transparent solid 0.6 noborder fc rgb '{2}' notitle",
                                 data, curve, method_tints[c]));
        parts.push_back(
            fmt::format("{} using (column('x [m]')):(1e3*column('{} [m]')) with lines lw 1.6 lc rgb '{}' {}", data,
                        curve, method_colours[c],
                        std::string(curve) == "bed" ? "title " + gnuplot_string(method.runs[0].label) : "notitle"));
      }
    }
    if (parts.empty()) continue;
    for (const char* curve : {"free_surface", "bed"}) {
      parts.push_back(
          fmt::format("{} using (column('x [m]')):(1e3*column('{} [m]')) with lines lw 1.8 lc rgb '#1a1a1a' {}",
                      writer.data(timed.file), curve,
                      std::string(curve) == "bed" ? "title " + gnuplot_string(particles.label) : "notitle"));
    }
    std::string name = profile_file_name(timed.time);
    name.resize(name.rfind('.'));
    scripts.push_back(writer.write(
        "band_" + name, 1000, 270,
        fmt::format("set xrange [{:g}:{:g}]\nset yrange [{:g}:{:g}]\nset xlabel 'x  [m]' offset 0,0.4\n"
                    "set ylabel 'z  [mm]' offset 1,0\nset key outside top right horizontal maxrows 1 samplen 2.2\n"
                    "set label 1 't = {:g} s' at graph 0.985,0.88 right font ',16' front\n"
                    "set lmargin 8\nset rmargin 2\nset tmargin 2\nset bmargin 2.8\n",
                    frame.x_from, frame.x_to, 1e3 * frame.z_from, 1e3 * frame.z_to, timed.time),
        fmt::format("plot {}", fmt::join(parts, ", \\\n     "))));
  }
  const fs::path costs = run.report() / "cost.csv";
  std::vector<std::string> parts;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    if (methods[m].runs.size() < 2) continue;
    parts.push_back(
        fmt::format("{} using (strcol('method') eq {} ? column('cpu [s]') : NaN):(1e3*column('error_bed "
                    "[m]')) with linespoints pt {} ps 1 lw 1.8 lc rgb '{}' title {}",
                    writer.data(costs), gnuplot_string(methods[m].name), 5 + 2 * (m % 4),
                    method_colours[m % method_colours.size()], gnuplot_string(methods[m].name)));
  }
  if (!parts.empty()) {
    scripts.push_back(writer.write("cost", 490, 300,
                                   "set logscale xy\nset xlabel 'CPU time  [s]' offset 0,0.4\n"
                                   "set ylabel 'distance of the bed  [mm]' offset 1,0\n"
                                   "set key top right samplen 2\nset bmargin 2.8\nset rmargin 2\n"
                                   "set offsets graph 0.1,graph 0.1,graph 0.1,graph 0.1\n",
                                   fmt::format("plot {}", fmt::join(parts, ", \\\n     "))));
  }
  return scripts;
}

std::string methods(const ReportInput& input, const fs::path& pictures) {
  if (input.methods.empty()) return "";
  std::string text = "<h2>Speed against error</h2>\n";
  std::vector<std::vector<std::string>> rows;
  bool bands = false;
  for (const Method& method : input.methods) {
    bands = bands || has_band(method);
    for (const MethodRun& run : method.runs) {
      const bool finest = &run == &method.runs.front();
      rows.push_back({html::escape(run.label), html::grouped(run.elements), html::grouped(run.steps),
                      fmt::format("{:.1f}", run.cpu_seconds), html::grouped(run.element_steps_per_second()),
                      finest ? "finest" : millimetres(run.error_free_surface),
                      finest ? "finest" : millimetres(run.error_bed)});
    }
  }
  text += html::table({"method", "particles or cells", "steps", "CPU s", "element steps / CPU s",
                       "free surface, distance from the finest [mm]", "bed [mm]"},
                      rows, "lrrrrrr", "wide");
  const std::string cost = html::inline_svg(pictures / "cost.svg", "cost", "Speed against error of both methods");
  if (!cost.empty()) {
    text += "<figure>\n" + cost +
            "<figcaption>CPU time of each run against how far its bed lies from the finest run of the same method; the "
            "finest runs themselves have no place here. Distance from a method's own finest run says how far its "
            "resolution decides, not how right it is.</figcaption>\n</figure>\n";
  }
  text += "<p class=\"small\">Root mean square over all times compared; <a href=\"cost.csv\">cost.csv</a>.</p>\n";
  if (!bands) return text;
  text += "<h2>How sure the mesh models are</h2>\n";
  for (const TimedProfile& timed : input.sets.front().profiles) {
    std::string name = profile_file_name(timed.time);
    name.resize(name.rfind('.'));
    const std::string picture = html::inline_svg(pictures / ("band_" + name + ".svg"), "band" + name,
                                                 fmt::format("Mesh models and their bands at t = {:g} s", timed.time));
    if (!picture.empty()) text += "<figure>\n" + picture + "</figure>\n";
  }
  return text +
         "<p>Each mesh model is its line; the band reaches from it to the same model on cells twice as large. That is "
         "the mesh model's own uncertainty: where the particle model lies inside, the two cannot be told apart.</p>\n";
}

}  // namespace thalweg::report_sections
