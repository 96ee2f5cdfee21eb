// The overview at the top of the report (scene, methods, their errors and costs), and its maps and views.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "postproc/embedded.hpp"
#include "postproc/figures/figure_writer.hpp"
#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"

namespace thalweg::report_sections {
namespace {

namespace fs = std::filesystem;
using html::escape;

// The summary with the numbers of a method: the run's, or that of the mesh model of this label.
const std::vector<Quantity>* summary_of(const ReportInput& input, const ProfileSet& set) {
  if (set.kind == SourceKind::run) return &input.summary;
  for (const MeshModel& mesh : input.meshes) {
    if (mesh.label == set.label) return &mesh.summary;
  }
  return nullptr;
}

std::string kind_of(const ProfileSet& set) {
  switch (set.kind) {
    case SourceKind::run:
      return "particles (SPH)";
    case SourceKind::mesh:
      return "mesh (finite volumes)";
    case SourceKind::measured:
      return "<b>measured</b>";
    case SourceKind::other:
      break;
  }
  return "further source";
}

// A piece of the line, or the marker, with which the pictures draw a source.
std::string sample_of(const ReportInput& input, std::size_t s) {
  const std::string dashes = dashes_of_source(input.sets, s);
  const std::string mark = input.sets[s].kind == SourceKind::measured
                               ? "<circle cx=\"23\" cy=\"5\" r=\"3.5\" fill=\"none\"/>"
                               : fmt::format("<path d=\"M1 5H45\" stroke-dasharray=\"{}\"/>", dashes);
  return "<svg class=\"sample\" width=\"46\" height=\"10\" viewBox=\"0 0 46 10\" stroke=\"#444\" "
         "stroke-width=\"2.2\">" +
         mark + "</svg>";
}

std::string whole(const std::optional<double>& value) { return value ? html::grouped(*value) : "–"; }

// "1.8–3.7": the smallest and the largest root mean square of one curve between two sources over the times.
std::string range_of_rms(const ReportInput& input, const std::string& reference, const std::string& compared,
                         const char* curve) {
  double low = INFINITY;
  double high = 0;
  for (const CurveError& error : input.comparison.errors) {
    if (error.reference != reference || error.compared != compared || error.curve != curve) continue;
    if (!error.line.empty()) continue;
    low = std::min(low, error.rmse);
    high = std::max(high, error.rmse);
  }
  if (low > high) return "–";
  const std::string least = input.units.height.number(low);
  const std::string most = input.units.height.number(high);
  return least == most ? most : least + "–" + most;
}

std::string range_of_scatter(const ReportInput& input, const char* curve) {
  double low = INFINITY;
  double high = 0;
  for (const Repeatability& known : input.repeatability) {
    if (known.curve != curve) continue;
    low = std::min(low, known.rms);
    high = std::max(high, known.rms);
  }
  if (low > high) return "–";
  return input.units.height.number(low) + "–" + input.units.height.number(high);
}

// The source with which the others are compared at the top of the page: the measurement if there is one, or this run.
const ProfileSet& held_against(const ReportInput& input) {
  for (const ProfileSet& set : input.sets) {
    if (set.kind == SourceKind::measured) return set;
  }
  return input.sets.front();
}

// When the run wrote its first snapshot; the beginning of all times without one.
fs::file_time_type start_of_run(const ReportInput& input) {
  std::error_code ignored;
  fs::file_time_type first = fs::file_time_type::max();
  for (const auto& entry : fs::directory_iterator(input.run.snapshots(), ignored)) {
    if (entry.path().extension() == ".vtp") first = std::min(first, fs::last_write_time(entry.path(), ignored));
  }
  return first == fs::file_time_type::max() ? fs::file_time_type::min() : first;
}

struct ParaviewPictures {
  std::vector<fs::path> of_run;
  std::size_t older = 0;  // than the run
};

ParaviewPictures find_paraview_pictures(const ReportInput& input) {
  ParaviewPictures found;
  const fs::file_time_type start = start_of_run(input);
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(input.run.report() / "paraview", ignored)) {
    if (entry.path().extension() != ".png") continue;
    if (fs::last_write_time(entry.path(), ignored) < start) {
      ++found.older;
    } else {
      found.of_run.push_back(entry.path());
    }
  }
  std::sort(found.of_run.begin(), found.of_run.end());
  return found;
}

std::vector<fs::path> paraview_pictures(const ReportInput& input) { return find_paraview_pictures(input).of_run; }

// view.py names a picture by its time: t0.500.png.
std::string paraview_figure(const fs::path& picture) {
  std::string name = picture.stem().string();
  if (name.starts_with('t')) name = "t = " + name.substr(1) + " s";
  return figure(html::inline_png(picture, "The run in ParaView, " + name), escape(name) + ", in ParaView (view.py).");
}

}  // namespace

std::string scene(const ReportInput& input, const fs::path& pictures) {
  const std::string plane =
      input.resolved.info.dimension == 3 ? fmt::format(" in the plane y = {:g} m", input.extraction.plane_y) : "";
  std::string text =
      "<h2>The scene</h2>\n" + figure(html::inline_png(pictures / "scene.png", "The scene at the start"),
                                      fmt::format("The scene at the start{}, heights not exaggerated.", plane));
  const std::vector<fs::path> shots = paraview_pictures(input);
  if (shots.empty()) {
    return text +
           "<p class=\"small onscreen\">In ParaView: <code>paraview --script=view.py</code>; <code>pvbatch view.py "
           "--pictures report/paraview</code> saves pictures, which the next report shows here.</p>\n";
  }
  return text + paraview_figure(shots.back());
}

std::size_t old_paraview_pictures(const ReportInput& input) { return find_paraview_pictures(input).older; }

std::string earlier_scenes(const ReportInput& input) {
  const std::vector<fs::path> shots = paraview_pictures(input);
  if (shots.size() < 2) return "";
  constexpr std::size_t most = 4;  // beside the last one, which stands at the top of the page
  const std::size_t every = (shots.size() - 1 + most - 1) / most;
  std::string text = "<div class=\"pair\">\n";
  for (std::size_t n = 0; n + 1 < shots.size(); n += every) text += paraview_figure(shots[n]);
  return text + "</div>\n";
}

std::string which_is_which(const ReportInput& input) {
  const ProfileSet& reference = held_against(input);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t s = 0; s < input.sets.size(); ++s) {
    const ProfileSet& set = input.sets[s];
    std::vector<std::string> row{sample_of(input, s), escape(set.label), kind_of(set)};
    const std::vector<Quantity>* summary = summary_of(input, set);
    const auto number = [&](const char* name) { return summary ? number_of(*summary, name) : std::nullopt; };
    const auto cost = [&](const char* name) { return input.units.cost.number(number(name).value_or(NAN)); };
    const std::optional<double> parts = number(set.kind == SourceKind::run ? "fluid_particles" : "cells");
    row.push_back(whole(parts) + (parts ? set.kind == SourceKind::run ? " particles" : " cells" : ""));
    row.push_back(whole(number("steps")));
    row.push_back(cost("wall_seconds"));
    row.push_back(cost("cpu_seconds"));
    for (const char* curve : {"free_surface", "bed"}) {
      std::string rms = range_of_rms(input, reference.label, set.label, curve);
      if (rms == "–") rms = range_of_rms(input, set.label, reference.label, curve);
      row.push_back(&set == &reference ? "<span class=\"soft\">reference</span>" : rms);
    }
    rows.push_back(std::move(row));
  }
  if (reference.kind != SourceKind::measured) {
    rows.push_back({"", "<span class=\"soft\">no measurement</span>", "<b>measured</b>", "–", "–", "–", "–", "–", "–"});
  }
  if (!input.repeatability.empty()) {
    rows.push_back({"", "<span class=\"soft\">scatter of equal runs</span>", "", "", "", "", "",
                    range_of_scatter(input, "free_surface"), range_of_scatter(input, "bed")});
  }
  const std::string against = reference.kind == SourceKind::measured ? "the measurement" : "this run";
  std::string text = "<h2>Which is which, how far apart, and what it cost</h2>\n" + what_is_seen(input) +
                     html::table({"drawn as", "source", "method", "size", "steps",
                                  fmt::format("wall clock [{}]", input.units.cost.name),
                                  fmt::format("CPU [{}]", input.units.cost.name),
                                  fmt::format("free surface off by [{}]", input.units.height.name),
                                  fmt::format("bed off by [{}]", input.units.height.name)},
                                 rows, "lllrrrrrr", "wide overview");
  text += fmt::format(
      "<p class=\"small\">Off by: root mean square distance from {} over x, the smallest and the largest of the times "
      "compared{}. Numbers: <a href=\"errors.csv\">report/errors.csv</a>, <a href=\"../summary.csv\">summary.csv</a>. "
      "Wall-clock times mean little if the machine did other work.</p>\n",
      against,
      reference.kind == SourceKind::measured
          ? ""
          : ". There is no measurement, so these numbers say nothing about agreement with an experiment");
  return text;
}

std::string space_time(const ReportInput& input, const fs::path& pictures) {
  const BedHistory& bed = input.bed_history;
  if (bed.times == 0) return "";
  return "<h2>The bed over place and time</h2>\n" +
         figure(html::inline_png(pictures / "space_time.png", "Change of the bed over place and time"),
                fmt::format("Change of the bed's level since the start{} at {} times: brown where it has risen, "
                            "blue-green where it has sunk. The line is the water's front. Largest change: {}. Numbers: "
                            "<a href=\"data/bed_change.csv\">report/data/bed_change.csv</a>.",
                            input.resolved.info.dimension == 3
                                ? fmt::format(" in the plane y = {:g} m", input.extraction.plane_y)
                                : "",
                            bed.times, input.units.height.text(bed.largest)));
}

std::string space_view(const ReportInput& input, const SpaceScene& scene) {
  if (scene.data.empty()) return "";
  return "<h2>The run in three dimensions</h2>\n<figure id=\"scene\">\n<div class=\"canvas\"></div>\n<div "
         "class=\"controls\"><button type=\"button\">play</button><input type=\"range\" min=\"0\" step=\"1\" "
         "aria-label=\"time\"><output></output><label><input type=\"checkbox\" name=\"water\" checked> water</label>" +
         fmt::format("<span class=\"scale\">−{0} <i></i> +{0}</span></div>\n", input.units.height.text(scene.largest)) +
         fmt::format(
             "<figcaption>The bed under the water's surface at {} times{}. The bed is brown where it has risen since "
             "the start and blue-green where it has sunk. Drag to turn, wheel to zoom, shift and drag to "
             "move.</figcaption>\n"
             "</figure>\n",
             scene.frames,
             scene.thinned ? fmt::format("; surfaces thinned to at most {} triangles",
                                         html::grouped(static_cast<double>(scene.most_triangles)))
                           : "") +
         "<script type=\"application/json\" id=\"scene-data\">" + scene.data + "</script>\n<script>\n" +
         std::string(embedded::scene_script) + "</script>\n";
}

std::string hover(const ReportInput& input) {
  const PictureFrame frame = frame_around(input.sets, input.resolved.compare.from, input.resolved.compare.to);
  nlohmann::json data;
  data["area"] = {{"left", profile_area.left},
                  {"right", profile_area.right},
                  {"bottom", profile_area.bottom},
                  {"top", profile_area.top}};
  const PageUnit& height = input.units.height;
  data["unit"] = height.name;
  data["decimals"] = height.decimals;
  const double digits = std::pow(10, height.decimals + 1);
  data["x_from"] = frame.x_from;
  data["x_to"] = frame.x_to;
  data["pictures"] = nlohmann::json::array();
  for (const TimedProfile& timed : input.extraction.written) {
    nlohmann::json series = nlohmann::json::array();
    for (std::size_t c = 0; c < std::size(curves); ++c) {
      for (const ProfileSet& set : input.sets) {
        const TimedProfile* found = set.at(timed.time);
        if (found == nullptr || (found->profile.*curves[c].values).empty()) continue;
        nlohmann::json x = nlohmann::json::array();
        nlohmann::json z = nlohmann::json::array();
        for (std::size_t i = 0; i < found->profile.x.size(); ++i) {
          const double value = (found->profile.*curves[c].values)[i];
          x.push_back(std::round(1e5 * found->profile.x[i]) / 1e5);
          z.push_back(std::isnan(value) ? nlohmann::json()
                                        : nlohmann::json(std::round(value / height.size * digits) / digits));
        }
        series.push_back({{"curve", curves[c].title},
                          {"source", escape(set.label)},
                          {"colour", curve_colours[c]},
                          {"x", std::move(x)},
                          {"z", std::move(z)}});
      }
    }
    data["pictures"].push_back({{"id", id_of_profile(timed.time)}, {"series", std::move(series)}});
  }
  std::string text = data.dump();
  for (std::size_t at = 0; (at = text.find("</", at)) != std::string::npos;) text.replace(at, 2, "<\\/");
  return "<script type=\"application/json\" id=\"curves\">" + text + "</script>\n<script>\n" +
         std::string(embedded::hover_script) + "</script>\n";
}

}  // namespace thalweg::report_sections
