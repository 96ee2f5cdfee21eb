#include "postproc/paper_figures.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "case/reader/case_file.hpp"
#include "common/csv.hpp"
#include "common/error.hpp"
#include "common/io/particle_file.hpp"
#include "common/whole_file.hpp"
#include "postproc/figure_look.hpp"
#include "postproc/figures.hpp"
#include "postproc/gnuplot.hpp"
#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"
#include "postproc/report_style.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;
using report_sections::figure;

constexpr const char* how_to_make_the_series =
    "for d in 16 8 4 2; do thalweg run cases/louvain_fixed_bed --no-foam --set numerics.spacing=\"$d mm\" --out "
    "out/louvain_fixed_bed_$d; done, then thalweg postproc out/louvain out/louvain_fixed_bed_* --figures paper";

std::string slot(const std::string& what) {
  return "<div class=\"missing\">empty slot: " + html::escape(what) + "</div>\n";
}

// A curve's value at x, linear between its points; NaN beyond its ends and in gaps.
double value_at(const std::vector<double>& x, const std::vector<double>& z, double at) {
  const auto right = std::lower_bound(x.begin(), x.end(), at);
  if (right == x.end() || z.empty()) return Profile::missing;
  const auto i = static_cast<std::size_t>(right - x.begin());
  if (*right == at) return z[i];
  if (i == 0) return Profile::missing;
  return z[i - 1] + (z[i] - z[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
}

struct Deepest {
  double scour = 0;  // [m] below the initial bed
  double at = Profile::missing;
};

Deepest deepest_scour(const Profile& initial, const Profile& now) {
  Deepest deepest;
  for (std::size_t i = 0; i < now.bed.size(); ++i) {
    const double depth = value_at(initial.x, initial.bed, now.x[i]) - now.bed[i];
    if (depth > deepest.scour) deepest = {depth, now.x[i]};
  }
  return deepest;
}

// One part of the page: scripts to draw, and what the page says around their pictures.
struct Part {
  std::vector<fs::path> scripts;
  std::function<std::string()> html;  // after the pictures have been drawn
};

class PaperSet {
 public:
  explicit PaperSet(ReportInput& input)
      : input_(input),
        folder_(input.run.report() / "paper"),
        writer_(folder_),
        spacing_(input.extraction.info.spacing) {}

  void front_against_spacing(const std::vector<fs::path>& series);
  void start_and_profiles();
  void sections();
  void scour_against_time();
  fs::path write_page();

 private:
  [[nodiscard]] fs::path data(const char* name) const { return folder_ / "data" / name; }
  [[nodiscard]] const TimedProfile* initial() const {
    return input_.extraction.initial ? &*input_.extraction.initial : nullptr;
  }
  // "free surface 2.3 mm, bed 2.7 mm": distance of the run from a source at a time.
  [[nodiscard]] std::string rmse(const ProfileSet& reference, double time) const;
  [[nodiscard]] bool measured() const {
    return std::any_of(input_.sets.begin(), input_.sets.end(),
                       [](const ProfileSet& set) { return set.kind == SourceKind::measured; });
  }
  [[nodiscard]] std::string measured_slot() const {
    const std::string folder =
        input_.resolved.compare.references.empty() ? "reference" : input_.resolved.compare.references.front();
    return measured()
               ? ""
               : slot("measured profiles, t0.250.csv … in " + folder + "/ of the case, would be drawn here as markers");
  }

  ReportInput& input_;
  fs::path folder_;
  FigureWriter writer_;
  double spacing_;
  std::vector<Part> parts_;
};

std::string PaperSet::rmse(const ProfileSet& reference, double time) const {
  std::vector<std::string> found;
  for (const Curve& curve : curves) {
    for (const CurveError& error : input_.comparison.errors) {
      if (error.reference != reference.label || error.compared != input_.sets.front().label) continue;
      if (!error.line.empty() || error.curve != curve.name || std::abs(error.time - time) > same_time) continue;
      found.push_back(fmt::format("{} {:.1f} mm", curve.title, 1e3 * error.rmse));
    }
  }
  return fmt::format("{}", fmt::join(found, ", "));
}

void PaperSet::front_against_spacing(const std::vector<fs::path>& series) {
  const std::string heading = "<h2>Figure 6: front against spacing over an immobile bed</h2>\n";
  std::map<double, std::pair<std::string, std::map<double, double>>> fronts;  // spacing → case, time → front
  for (const fs::path& folder : series) {
    const RunFolder run{folder};
    if (!fs::exists(run.resolved_case()))
      throw InputError(folder.string() + ": is not the folder of a run; it holds no case.resolved.toml");
    const Case resolved = read_case(run.resolved_case());
    const fs::path file = run.profiles() / "front.csv";
    if (!fs::exists(file))
      throw InputError(file.string() + ": is missing; make it with thalweg postproc " + folder.string());
    const CsvTable table = CsvTable::read(file);
    const std::vector<double> times = table.numbers("time", "s");
    const std::vector<double> places = table.numbers("front", "m");
    auto& [name, of_time] = fronts[resolved.numerics.spacing];
    name = resolved.info.name;
    for (const double wanted : resolved.compare.times) {
      for (std::size_t row = 0; row < times.size(); ++row) {
        if (std::abs(times[row] - wanted) <= same_time && !std::isnan(places[row])) of_time[wanted] = places[row];
      }
    }
  }
  std::set<std::string> names;
  std::set<double> times;
  for (const auto& [spacing, run] : fronts) {
    names.insert(run.first);
    for (const auto& [time, front] : run.second) times.insert(time);
  }
  if (names.size() > 1)
    throw InputError(
        fmt::format("the series holds runs of different cases ({}); give runs of one case", fmt::join(names, ", ")));
  if (fronts.size() < 2) {
    parts_.push_back({{}, [heading] {
                        return heading + slot(std::string("runs at two spacings or more; ") + how_to_make_the_series);
                      }});
    return;
  }
  CsvTable table({{"spacing", "mm"}, {"time", "s"}, {"front", "m"}});
  table.comments.push_back("case " + *names.begin() + "; the water's front as in profiles/front.csv of each run");
  std::vector<std::vector<std::string>> rows;
  for (const auto& [spacing, run] : fronts) {
    rows.push_back({fmt::format("{:g}", 1e3 * spacing)});
    for (const double time : times) {
      const auto found = run.second.find(time);
      rows.back().push_back(found == run.second.end() ? "–" : fmt::format("{:.3f}", found->second));
      if (found != run.second.end())
        table.add_row({csv_number(1e3 * spacing), csv_number(time), fmt::format("{:.6g}", found->second)});
    }
  }
  table.write(data("fig06_front.csv"));
  std::vector<std::string> lines;
  constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#1a1a1a", "#e69f00"};
  for (const double time : times) {
    lines.push_back(
        fmt::format("{} using (column('spacing [mm]')):(abs(column('time [s]')-{:g})<5e-4?column('front [m]'):NaN) "
                    "with linespoints pt "
                    "7 ps 0.9 lw 1.6 lc rgb '{}' title 't = {:g} s'",
                    writer_.data(data("fig06_front.csv")), time, colours[lines.size() % colours.size()], time));
  }
  std::vector<std::string> tics;
  for (const auto& [spacing, run] : fronts) tics.push_back(fmt::format("{:g}", 1e3 * spacing));
  const fs::path script =
      writer_.write("fig06_front", 1000, 400,
                    fmt::format("set datafile missing NaN\nset logscale x 2\nset xtics ({})\nset xrange "
                                "[{:g}:{:g}]\nset xlabel 'dp  [mm]'\nset "
                                "ylabel 'x of the water front  [m]'\nset key outside right top Left reverse\n",
                                fmt::join(tics, ","), 0.85e3 * fronts.begin()->first, 1.18e3 * fronts.rbegin()->first),
                    fmt::format("plot {}", fmt::join(lines, ", \\\n     ")));
  std::vector<std::string> heads{"dp [mm]"};
  for (const double time : times) heads.push_back(fmt::format("front at {:g} s [m]", time));
  const std::string tabulated = html::table(heads, rows, std::string(heads.size(), 'r'));
  parts_.push_back(
      {{script}, [this, heading, tabulated, name = *names.begin()] {
         return heading +
                figure(html::inline_svg(folder_ / "fig06_front.svg", "fig06", "Front against spacing"),
                       fmt::format("Case {}: the water's front at the same times for each spacing. Numbers: <a "
                                   "href=\"data/fig06_front.csv\">data/fig06_front.csv</a>.",
                                   html::escape(name))) +
                tabulated;
       }});
}

void PaperSet::start_and_profiles() {
  const PictureFrame frame = frame_around(input_.sets, input_.resolved.compare.from, input_.resolved.compare.to);
  Part part;
  if (fs::exists(input_.run.particles())) {
    constexpr std::size_t most_points = 200'000;
    const ParticleTable start = write_particle_table(data("fig08_start.csv"), read_particles(input_.run.particles()),
                                                     input_.extraction.plane_y, most_points, true);
    part.scripts.push_back(writer_.scene(start, frame.widened(3.5 * spacing_), spacing_));
  }
  std::vector<fs::path> folders;
  for (const ProfileSet& set : input_.sets) {
    folders.push_back(folder_ / "data" / folder_name_of(set.label));
    for (const TimedProfile& timed : set.profiles) {
      write_profile(folders.back() / profile_file_name(timed.time), timed.profile, comments_in(timed.file));
    }
  }
  for (const TimedProfile& timed : input_.extraction.written) {
    part.scripts.push_back(writer_.profiles(timed.time, input_.sets, folders, frame));
  }
  part.html = [this] {
    std::string text =
        "<h2>Figures 8 to 10: the start, and profiles with their RMSE</h2>\n" +
        figure(html::inline_png(folder_ / "scene.png", "The start"), "The start, heights not exaggerated.");
    for (const TimedProfile& timed : input_.extraction.written) {
      const std::string id = report_sections::id_of_profile(timed.time);
      std::string name = profile_file_name(timed.time);
      name.resize(name.rfind('.'));
      std::string caption = fmt::format("t = {:g} s.", timed.time);
      for (std::size_t s = 1; s < input_.sets.size(); ++s) {
        const std::string distance = rmse(input_.sets[s], timed.time);
        if (!distance.empty())
          caption += fmt::format(" RMSE of SPH against {}: {}.", html::escape(input_.sets[s].label), distance);
      }
      text += figure(html::inline_svg(folder_ / (name + ".svg"), id, fmt::format("Profiles at t = {:g} s", timed.time)),
                     caption);
    }
    return text + measured_slot();
  };
  parts_.push_back(std::move(part));
}

void PaperSet::sections() {
  CsvTable levels({{"section", ""}, {"x", "m"}, {"time", "s"}, {"source", ""}, {"free_surface", "m"}, {"bed", "m"}});
  CsvTable errors(
      {{"section", ""}, {"x", "m"}, {"time", "s"}, {"reference", ""}, {"free_surface_error", "m"}, {"bed_error", "m"}});
  const double back = 10 * spacing_;
  levels.comments.push_back(fmt::format(
      "S1: middle of the tank; S2: deepest scour of the run at that time; S3: {:g} m behind its front", back));
  errors.comments.emplace_back("the run minus the reference, linear between the points of each");
  const TimedProfile* start = initial();
  std::vector<std::vector<std::string>> rows;
  for (const TimedProfile& timed : input_.extraction.written) {
    double front = Profile::missing;
    for (const FrontSample& sample : input_.extraction.fronts) {
      if (std::abs(sample.time - timed.time) <= same_time) front = sample.front;
    }
    const double tank = start != nullptr ? start->profile.x.front() / 2 : Profile::missing;  // the gate is at x = 0
    const Deepest deepest = start != nullptr ? deepest_scour(start->profile, timed.profile) : Deepest{};
    const std::pair<const char*, double> places[] = {{"S1", tank}, {"S2", deepest.at}, {"S3", front - back}};
    for (const auto& [name, x] : places) {
      if (std::isnan(x)) continue;
      double own[2] = {Profile::missing, Profile::missing};
      for (const ProfileSet& set : input_.sets) {
        const TimedProfile* found = set.at(timed.time);
        if (found == nullptr) continue;
        const double level[2] = {value_at(found->profile.x, found->profile.free_surface, x),
                                 value_at(found->profile.x, found->profile.bed, x)};
        levels.add_row({name, fmt::format("{:.4f}", x), csv_number(timed.time), set.label, csv_number(level[0]),
                        csv_number(level[1])});
        std::vector<std::string> row{name, fmt::format("{:g}", timed.time), html::typeset(fmt::format("{:.3f}", x)),
                                     html::escape(set.label)};
        for (const double value : level) row.push_back(std::isnan(value) ? "–" : fmt::format("{:.1f}", 1e3 * value));
        if (set.kind == SourceKind::run) {
          std::copy(level, level + 2, own);
          row.insert(row.end(), {"", ""});
        } else {
          const double error[2] = {own[0] - level[0], own[1] - level[1]};
          errors.add_row({name, fmt::format("{:.4f}", x), csv_number(timed.time), set.label, csv_number(error[0]),
                          csv_number(error[1])});
          for (const double value : error)
            row.push_back(std::isnan(value) ? "–" : html::typeset(fmt::format("{:+.1f}", 1e3 * value)));
        }
        rows.push_back(std::move(row));
      }
    }
  }
  levels.write(data("fig11_sections.csv"));
  errors.write(data("fig12_local_errors.csv"));

  std::string body =
      "set multiplot layout 2,3 columnsfirst margins 0.075,0.99,0.14,0.93 spacing 0.05,0.1\n"
      "set offsets graph 0.08,graph 0.08,graph 0.1,graph 0.1\nset key center right\n" +
      fmt::format("set xtics {:g}\n", tic_step(input_.extraction.last_time, 4));
  for (const char* section : {"S1", "S2", "S3"}) {
    const auto chosen = [&](const char* column, const std::string& label, const char* source_column) {
      return fmt::format("(strcol('section') eq '{}' && strcol('{}') eq {} ? 1e3*column('{} [m]') : NaN)", section,
                         source_column, gnuplot_string(label), column);
    };
    std::vector<std::string> plots[2];
    int marker = 4;
    for (const ProfileSet& set : input_.sets) {
      const int point = set.kind == SourceKind::run ? 7 : set.kind == SourceKind::measured ? 6 : marker++;
      const std::string title = section == std::string("S1") ? "title " + gnuplot_string(set.label) : "notitle";
      plots[0].push_back(fmt::format("{} using (column('time [s]')):{} with points pt {} ps 0.8 lc rgb '{}' notitle",
                                     writer_.data(data("fig11_sections.csv")),
                                     chosen("free_surface", set.label, "source"), point, curve_colours[0]));
      plots[0].push_back(fmt::format("{} using (column('time [s]')):{} with points pt {} ps 0.8 lc rgb '{}' notitle",
                                     writer_.data(data("fig11_sections.csv")), chosen("bed", set.label, "source"),
                                     point, curve_colours[1]));
      plots[0].push_back(fmt::format("keyentry with points pt {} lc rgb '#444444' {}", point, title));
      if (set.kind == SourceKind::run) continue;
      plots[1].push_back(fmt::format("{} using (column('time [s]')):{} with points pt {} ps 0.8 lc rgb '{}' notitle",
                                     writer_.data(data("fig12_local_errors.csv")),
                                     chosen("free_surface_error", set.label, "reference"), point, curve_colours[0]));
      plots[1].push_back(fmt::format("{} using (column('time [s]')):{} with points pt {} ps 0.8 lc rgb '{}' notitle",
                                     writer_.data(data("fig12_local_errors.csv")),
                                     chosen("bed_error", set.label, "reference"), point, curve_colours[1]));
    }
    body += fmt::format("set title '{}'\nset ylabel '{}'\nset xlabel ''\n", section,
                        section == std::string("S1") ? "z  [mm]" : "");
    body += fmt::format("plot {}\n", fmt::join(plots[0], ", \\\n     "));
    body += fmt::format("unset title\nset xlabel 't  [s]'\nset ylabel '{}'\n",
                        section == std::string("S1") ? "SPH - reference  [mm]" : "");
    body += plots[1].empty() ? "set multiplot next\n"
                             : fmt::format("plot 0 lc rgb '#999999' notitle, {}\n", fmt::join(plots[1], ", \\\n     "));
  }
  body += "unset multiplot\n";
  const fs::path script = folder_ / "fig11_sections.gp";
  write_whole_text(script, [&](std::ostream& stream) {
    fmt::print(stream,
               "# Draws fig11_sections.svg and .png from the CSV files it names: gnuplot fig11_sections.gp\n{}set "
               "datafile missing NaN\n",
               figure_look);
    fmt::print(
        stream,
        "set terminal svg size 1000,520 dynamic font 'Helvetica,13' noenhanced\nset output 'fig11_sections.svg'\n{}",
        body);
    fmt::print(stream,
               "set terminal pngcairo size 2000,1040 font 'sans,13' fontscale 1.9 linewidth 2 pointscale 2 "
               "noenhanced\nset output 'fig11_sections.png'\n{}",
               body);
  });
  parts_.push_back(
      {{script}, [this, rows, back] {
         return "<h2>Figures 11 and 12: three sections, and the local errors there</h2>\n" +
                figure(html::inline_svg(folder_ / "fig11_sections.svg", "fig11", "Levels and errors at three sections"),
                       fmt::format("Above: free surface (blue) and bed (orange) of each source; below: SPH minus the "
                                   "others. S1: middle of the "
                                   "tank; S2: deepest scour of the SPH run at each time; S3: {:g} mm behind its front. "
                                   "Numbers: <a "
                                   "href=\"data/fig11_sections.csv\">data/fig11_sections.csv</a>, <a "
                                   "href=\"data/fig12_local_errors.csv\">"
                                   "data/fig12_local_errors.csv</a>.",
                                   1e3 * back)) +
                html::table({"section", "t [s]", "x [m]", "source", "free surface [mm]", "bed [mm]",
                             "SPH minus it: surface [mm]", "bed [mm]"},
                            rows, "lrrlrrrr", "long wide") +
                measured_slot();
       }});
}

void PaperSet::scour_against_time() {
  const TimedProfile* start = initial();
  if (start == nullptr || start->profile.bed.empty()) return;
  CsvTable table({{"source", ""}, {"time", "s"}, {"scour", "m"}, {"scour_at", "m"}});
  table.comments.emplace_back(
      "deepest place of the bed below the run's bed at the start, from the profiles of each source");
  std::vector<TimedProfile> all;  // of the run
  for (const SnapshotProfile& snapshot : input_.extraction.along_x) all.push_back(snapshot.get());
  std::vector<std::string> lines;
  int marker = 4;
  for (const ProfileSet& set : input_.sets) {
    const bool dense = set.kind == SourceKind::run;
    const std::vector<TimedProfile> profiles = dense ? all : set.profiles;
    bool any = false;
    for (const TimedProfile& timed : profiles) {
      if (timed.profile.bed.empty()) continue;
      const Deepest deepest = deepest_scour(start->profile, timed.profile);
      table.add_row({set.label, csv_number(timed.time), fmt::format("{:.6g}", deepest.scour), csv_number(deepest.at)});
      any = true;
    }
    if (!any) continue;
    const std::string style =
        dense ? "with lines lw 2.2"
              : fmt::format("with points pt {} ps 1 lw 1.6", set.kind == SourceKind::measured ? 6 : marker++);
    lines.push_back(
        fmt::format("{} using (column('time [s]')):(strcol('source') eq {} ? 1e3*column('scour [m]') : NaN) {} lc rgb "
                    "'{}' title {}",
                    writer_.data(data("fig13_scour.csv")), gnuplot_string(set.label), style,
                    set.kind == SourceKind::run ? "#0072b2" : "#444444", gnuplot_string(set.label)));
  }
  table.write(data("fig13_scour.csv"));
  const fs::path script =
      writer_.write("fig13_scour", 1000, 400,
                    "set datafile missing NaN\nset xlabel 't  [s]'\nset ylabel 'deepest scour  [mm]'\nset key outside "
                    "right top Left reverse\nset yrange [0:*]\nset offsets 0,0,graph 0.06,0\n",
                    fmt::format("plot {}", fmt::join(lines, ", \\\n     ")));
  parts_.push_back({{script}, [this] {
                      return "<h2>Figure 13: deepest scour against time</h2>\n" +
                             figure(
                                 html::inline_svg(folder_ / "fig13_scour.svg", "fig13", "Deepest scour against time"),
                                 "Deepest place of the bed below where it was at the start. Numbers: <a "
                                 "href=\"data/fig13_scour.csv\">data/fig13_scour.csv</a>.") +
                             measured_slot();
                    }});
}

fs::path PaperSet::write_page() {
  for (const Part& part : parts_) {
    for (const fs::path& script : part.scripts) {
      if (run_gnuplot(script) == GnuplotResult::not_installed) {
        input_.warnings.emplace_back("gnuplot is not installed, so there are no pictures; apt-get install gnuplot-nox");
        break;
      }
    }
  }
  const fs::path page = folder_ / "index.html";
  write_whole_text(page, [&](std::ostream& stream) {
    stream
        << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>The paper's figures</title><style>"
        << report_style << "</style></head><body>\n"
        << report_sections::heading(input_)
        << "<p>The figures of Zhang, Xiong &amp; Liu (2024), numbered as there, from runs of this program; OpenFOAM "
           "stands in the place of "
           "their mesh code. Sources: ";
    for (std::size_t s = 0; s < input_.sets.size(); ++s)
      stream << (s > 0 ? "; " : "") << html::escape(input_.sets[s].label);
    stream << (measured() ? ".</p>\n"
                          : "; <b>nothing measured</b>, so none of this is agreement with the experiment.</p>\n");
    for (const Part& part : parts_) stream << part.html();
    stream << report_sections::provenance(input_) << "</body></html>\n";
  });
  return page;
}

}  // namespace

fs::path write_paper_figures(ReportInput& input, const std::vector<fs::path>& series) {
  PaperSet set(input);
  set.front_against_spacing(series);
  set.start_and_profiles();
  set.sections();
  set.scour_against_time();
  return set.write_page();
}

}  // namespace thalweg
