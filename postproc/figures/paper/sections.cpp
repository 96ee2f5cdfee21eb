#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "common/csv.hpp"
#include "postproc/figures/paper/paper_part.hpp"
#include "postproc/figures/script_template.hpp"
#include "postproc/figures/scripts.hpp"
#include "postproc/figures/tic_step.hpp"
#include "postproc/gnuplot.hpp"
#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"

namespace thalweg::paper {
namespace {

namespace fs = std::filesystem;

// Free surface and bed at one place [m].
using Levels = std::array<double, 2>;
constexpr Levels no_levels{Profile::missing, Profile::missing};

// The tables of the figure and of the page, filled row by row.
struct SectionTables {
  CsvTable levels{{{"section", ""}, {"x", "m"}, {"time", "s"}, {"source", ""}, {"free_surface", "m"}, {"bed", "m"}}};
  CsvTable errors{
      {{"section", ""}, {"x", "m"}, {"time", "s"}, {"reference", ""}, {"free_surface_error", "m"}, {"bed_error", "m"}}};
  std::vector<std::vector<std::string>> rows;  // of the page

  // All sources at one section and time; `own` are the run's levels, which come first.
  void add(const char* section, double x, double time, const std::vector<ProfileSet>& sets) {
    Levels own = no_levels;
    for (const ProfileSet& set : sets) {
      const TimedProfile* found = set.at(time);
      if (found == nullptr) continue;
      const Profile& profile = found->profile;
      const Levels level{value_at(profile.x, profile.free_surface, x), value_at(profile.x, profile.bed, x)};
      levels.add_row(
          {section, fmt::format("{:.4f}", x), csv_number(time), set.label, csv_number(level[0]), csv_number(level[1])});
      std::vector<std::string> row{section, fmt::format("{:g}", time), html::typeset(fmt::format("{:.3f}", x)),
                                   html::escape(set.label)};
      for (const double value : level) row.push_back(std::isnan(value) ? "–" : fmt::format("{:.1f}", 1e3 * value));
      if (set.kind == SourceKind::run) {
        own = level;
        row.insert(row.end(), {"", ""});
      } else {
        add_error(section, x, time, set.label, {own[0] - level[0], own[1] - level[1]}, row);
      }
      rows.push_back(std::move(row));
    }
  }

 private:
  void add_error(const char* section, double x, double time, const std::string& reference, const Levels& error,
                 std::vector<std::string>& row) {
    errors.add_row(
        {section, fmt::format("{:.4f}", x), csv_number(time), reference, csv_number(error[0]), csv_number(error[1])});
    for (const double value : error) {
      row.push_back(std::isnan(value) ? "–" : html::typeset(fmt::format("{:+.1f}", 1e3 * value)));
    }
  }
};

double front_at(const ExtractionRun& extraction, double time) {
  double front = Profile::missing;
  for (const FrontSample& sample : extraction.fronts) {
    if (std::abs(sample.time - time) <= same_time) front = sample.front;
  }
  return front;
}

SectionTables make_tables(const Context& context, double back) {
  SectionTables tables;
  tables.levels.comments.push_back(fmt::format(
      "S1: middle of the tank; S2: deepest scour of the run at that time; S3: {:g} m behind its front", back));
  tables.errors.comments.emplace_back("the run minus the reference, linear between the points of each");
  const TimedProfile* start = context.initial();
  const ReportInput& input = context.input;
  for (const TimedProfile& timed : input.extraction.written) {
    const double tank = start != nullptr ? start->profile.x.front() / 2 : Profile::missing;  // the gate is at x = 0
    const DeepestScour deepest = start != nullptr ? deepest_scour(start->profile, timed.profile) : DeepestScour{};
    const double behind_front = front_at(input.extraction, timed.time) - back;
    for (const auto& [name, x] : {std::pair{"S1", tank}, {"S2", deepest.at}, {"S3", behind_front}}) {
      if (!std::isnan(x)) tables.add(name, x, timed.time, input.sets);
    }
  }
  return tables;
}

// The two panels of a section: levels above, errors below.
std::string section_panels(const std::string& section, const std::vector<ProfileSet>& sets, const std::string& levels,
                           const std::string& errors) {
  const bool first = section == "S1";  // it has the titles of all
  std::vector<std::string> level_plots;
  std::vector<std::string> error_plots;
  int marker = 4;
  for (const ProfileSet& set : sets) {
    const int point = set.kind == SourceKind::run ? 7 : set.kind == SourceKind::measured ? 6 : marker++;
    const auto points = [&](const std::string& file, const char* column, const char* source_column,
                            const char* colour) {
      return fmt::format(
          "{} using (column('time [s]')):(strcol('section') eq '{}' && strcol('{}') eq {} ? 1e3*column('{} [m]') : "
          "NaN) with points pt {} ps 0.8 lc rgb '{}' notitle",
          file, section, source_column, gnuplot_string(set.label), column, point, colour);
    };
    level_plots.push_back(points(levels, "free_surface", "source", curve_colours[0]));
    level_plots.push_back(points(levels, "bed", "source", curve_colours[1]));
    level_plots.push_back(fmt::format("keyentry with points pt {} lc rgb '#444444' {}", point,
                                      first ? "title " + gnuplot_string(set.label) : "notitle"));
    if (set.kind == SourceKind::run) continue;
    error_plots.push_back(points(errors, "free_surface_error", "reference", curve_colours[0]));
    error_plots.push_back(points(errors, "bed_error", "reference", curve_colours[1]));
  }
  const std::string plot_errors =
      error_plots.empty() ? "set multiplot next" : "plot 0 lc rgb '#999999' notitle, " + joined_plots(error_plots);
  return fill_template(embedded::script_paper_section, {{"section", section},
                                                        {"level_title", first ? "z  [mm]" : ""},
                                                        {"error_title", first ? "SPH - reference  [mm]" : ""},
                                                        {"levels", joined_plots(level_plots)},
                                                        {"plot_errors", plot_errors}});
}

fs::path write_script(const Context& context, const fs::path& levels, const fs::path& errors) {
  const FigureWriter& writer = context.writer;
  std::string panels;
  for (const char* section : {"S1", "S2", "S3"}) {
    panels += section_panels(section, context.input.sets, writer.data(levels), writer.data(errors));
  }
  const std::string tics = fmt::format("{:g}", tic_step(context.input.extraction.last_time, 4));
  return writer.write_multiplot(
      "fig11_sections", 1000, 520, "set datafile missing NaN\n",
      fill_template(embedded::script_paper_sections, {{"time_tics", tics}, {"panels", panels}}));
}

}  // namespace

Part sections(const Context& context) {
  const double back = 10 * context.spacing;
  const SectionTables tables = make_tables(context, back);
  const fs::path levels = context.data("fig11_sections.csv");
  const fs::path errors = context.data("fig12_local_errors.csv");
  tables.levels.write(levels);
  tables.errors.write(errors);
  return {{write_script(context, levels, errors)}, [&context, rows = tables.rows, back] {
            return "<h2>Figures 11 and 12: three sections, and the local errors there</h2>\n" +
                   report_sections::figure(
                       html::inline_svg(context.folder / "fig11_sections.svg", "fig11",
                                        "Levels and errors at three sections"),
                       fmt::format("Above: free surface (blue) and bed (orange) of each source; below: SPH minus the "
                                   "others. S1: middle of the tank; S2: deepest scour of the SPH run at each time; "
                                   "S3: {:g} mm behind its front. Numbers: <a "
                                   "href=\"data/fig11_sections.csv\">data/fig11_sections.csv</a>, <a "
                                   "href=\"data/fig12_local_errors.csv\">data/fig12_local_errors.csv</a>.",
                                   1e3 * back)) +
                   html::table({"section", "t [s]", "x [m]", "source", "free surface [mm]", "bed [mm]",
                                "SPH minus it: surface [mm]", "bed [mm]"},
                               rows, "lrrlrrrr", "long wide") +
                   context.measured_slot();
          }};
}

}  // namespace thalweg::paper
