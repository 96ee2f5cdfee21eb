#include <fmt/format.h>

#include "common/csv.hpp"
#include "postproc/figures/paper/paper_part.hpp"
#include "postproc/figures/script_template.hpp"
#include "postproc/figures/scripts.hpp"
#include "postproc/gnuplot.hpp"
#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"

namespace thalweg::paper {
namespace {

namespace fs = std::filesystem;

// The profiles of a source; of the run those of all snapshots.
std::vector<TimedProfile> profiles_of(const ReportInput& input, const ProfileSet& set) {
  if (set.kind != SourceKind::run) return set.profiles;
  std::vector<TimedProfile> all;
  for (const SnapshotProfile& snapshot : input.extraction.along_x) all.push_back(snapshot.get());
  return all;
}

// Adds a source's scour at all its times; false if it has no bed.
bool add_source(CsvTable& table, const std::string& label, const std::vector<TimedProfile>& profiles,
                const Profile& start) {
  bool any = false;
  for (const TimedProfile& timed : profiles) {
    if (timed.profile.bed.empty()) continue;
    const DeepestScour deepest = deepest_scour(start, timed.profile);
    table.add_row({label, csv_number(timed.time), fmt::format("{:.6g}", deepest.depth), csv_number(deepest.at)});
    any = true;
  }
  return any;
}

}  // namespace

std::optional<Part> scour_against_time(const Context& context) {
  const TimedProfile* start = context.initial();
  if (start == nullptr || start->profile.bed.empty()) return std::nullopt;
  const fs::path file = context.data("fig13_scour.csv");
  CsvTable table({{"source", ""}, {"time", "s"}, {"scour", "m"}, {"scour_at", "m"}});
  table.comments.emplace_back(
      "deepest place of the bed below the run's bed at the start, from the profiles of each source");
  std::vector<std::string> lines;
  int marker = 4;
  for (const ProfileSet& set : context.input.sets) {
    if (!add_source(table, set.label, profiles_of(context.input, set), start->profile)) continue;
    const bool is_run = set.kind == SourceKind::run;
    const std::string style =
        is_run ? "with lines lw 2.2"
               : fmt::format("with points pt {} ps 1 lw 1.6", set.kind == SourceKind::measured ? 6 : marker++);
    lines.push_back(
        fmt::format("{} using (column('time [s]')):(strcol('source') eq {} ? 1e3*column('scour [m]') : NaN) {} lc rgb "
                    "'{}' title {}",
                    context.writer.data(file), gnuplot_string(set.label), style, is_run ? "#0072b2" : source_colour,
                    gnuplot_string(set.label)));
  }
  table.write(file);
  const fs::path script = context.writer.write(
      "fig13_scour", 1000, 400, fill_template(embedded::script_paper_scour, {{"curves", joined_plots(lines)}}));
  return Part{{script}, [&context] {
                return "<h2>Figure 13: deepest scour against time</h2>\n" +
                       report_sections::figure(
                           html::inline_svg(context.folder / "fig13_scour.svg", "fig13", "Deepest scour against time"),
                           "Deepest place of the bed below where it was at the start. Numbers: <a "
                           "href=\"data/fig13_scour.csv\">data/fig13_scour.csv</a>.") +
                       context.measured_slot();
              }};
}

}  // namespace thalweg::paper
