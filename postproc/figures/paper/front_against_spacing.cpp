#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "case/reader/case_file.hpp"
#include "common/csv.hpp"
#include "common/error.hpp"
#include "postproc/figures/paper/paper_part.hpp"
#include "postproc/figures/script_template.hpp"
#include "postproc/figures/scripts.hpp"
#include "postproc/html.hpp"
#include "postproc/report_sections.hpp"

namespace thalweg::paper {
namespace {

namespace fs = std::filesystem;

constexpr const char* heading = "<h2>Figure 6: front against spacing over an immobile bed</h2>\n";
constexpr const char* how_to_make_the_series =
    "for d in 16 8 4 2; do thalweg run cases/louvain_fixed_bed --no-foam --set numerics.spacing=\"$d mm\" --out "
    "out/louvain_fixed_bed_$d; done, then thalweg postproc out/louvain out/louvain_fixed_bed_* --figures paper";

// The fronts of one case at several spacings.
struct FrontSeries {
  std::set<std::string> case_names;
  std::set<double> times;                             // [s]
  std::map<double, std::map<double, double>> fronts;  // spacing [m] → time [s] → front [m]
};

void add_run(FrontSeries& series, const fs::path& folder) {
  const RunFolder run{folder};
  if (!fs::exists(run.resolved_case())) {
    throw InputError(folder.string() + ": is not the folder of a run; it holds no case.resolved.toml");
  }
  const Case resolved = read_case(run.resolved_case());
  const fs::path file = run.profiles() / "front.csv";
  if (!fs::exists(file)) {
    throw InputError(file.string() + ": is missing; make it with thalweg postproc " + folder.string());
  }
  const CsvTable table = CsvTable::read(file);
  const std::vector<double> times = table.numbers("time", "s");
  const std::vector<double> places = table.numbers("front", "m");
  series.case_names.insert(resolved.info.name);
  std::map<double, double>& of_time = series.fronts[resolved.numerics.spacing];
  for (const double wanted : resolved.compare.times) {
    for (std::size_t row = 0; row < times.size(); ++row) {
      if (std::abs(times[row] - wanted) > same_time || std::isnan(places[row])) continue;
      of_time[wanted] = places[row];
      series.times.insert(wanted);
    }
  }
}

FrontSeries read_series(const std::vector<fs::path>& folders) {
  FrontSeries series;
  for (const fs::path& folder : folders) add_run(series, folder);
  if (series.case_names.size() > 1) {
    throw InputError(fmt::format("the series holds runs of different cases ({}); give runs of one case",
                                 fmt::join(series.case_names, ", ")));
  }
  return series;
}

void write_table(const fs::path& file, const FrontSeries& series) {
  CsvTable table({{"spacing", "mm"}, {"time", "s"}, {"front", "m"}});
  table.comments.push_back("case " + *series.case_names.begin() +
                           "; the water's front as in profiles/front.csv of each run");
  for (const auto& [spacing, of_time] : series.fronts) {
    for (const auto& [time, front] : of_time) {
      table.add_row({csv_number(1e3 * spacing), csv_number(time), fmt::format("{:.6g}", front)});
    }
  }
  table.write(file);
}

// The table of the page: a row a spacing, a column a time.
std::string html_table(const FrontSeries& series) {
  std::vector<std::string> heads{"dp [mm]"};
  for (const double time : series.times) heads.push_back(fmt::format("front at {:g} s [m]", time));
  std::vector<std::vector<std::string>> rows;
  for (const auto& [spacing, of_time] : series.fronts) {
    rows.push_back({fmt::format("{:g}", 1e3 * spacing)});
    for (const double time : series.times) {
      const auto found = of_time.find(time);
      rows.back().push_back(found == of_time.end() ? "–" : fmt::format("{:.3f}", found->second));
    }
  }
  return html::table(heads, rows, std::string(heads.size(), 'r'));
}

fs::path write_script(const FigureWriter& writer, const fs::path& table, const FrontSeries& series) {
  std::vector<std::string> curves;
  constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#1a1a1a", "#e69f00"};
  for (const double time : series.times) {
    curves.push_back(
        fmt::format("{} using (column('spacing [mm]')):(abs(column('time [s]')-{:g})<5e-4?column('front [m]'):NaN) "
                    "with linespoints pt 7 ps 0.9 lw 1.6 lc rgb '{}' title 't = {:g} s'",
                    writer.data(table), time, colours[curves.size() % colours.size()], time));
  }
  std::vector<std::string> spacings;
  for (const auto& [spacing, of_time] : series.fronts) spacings.push_back(fmt::format("{:g}", 1e3 * spacing));
  return writer.write("fig06_front", 1000, 400,
                      fill_template(embedded::script_paper_front,
                                    {{"spacings", fmt::format("{}", fmt::join(spacings, ","))},
                                     {"finest", fmt::format("{:g}", 0.85e3 * series.fronts.begin()->first)},
                                     {"coarsest", fmt::format("{:g}", 1.18e3 * series.fronts.rbegin()->first)},
                                     {"curves", joined_plots(curves)}}));
}

}  // namespace

Part front_against_spacing(const Context& context, const std::vector<fs::path>& series_folders) {
  const FrontSeries series = read_series(series_folders);
  if (series.fronts.size() < 2) {
    return {{}, [] {
              return heading + empty_slot(std::string("runs at two spacings or more; ") + how_to_make_the_series);
            }};
  }
  const fs::path table = context.data("fig06_front.csv");
  write_table(table, series);
  return {{write_script(context.writer, table, series)},
          [&context, tabulated = html_table(series), name = *series.case_names.begin()] {
            return heading +
                   report_sections::figure(
                       html::inline_svg(context.folder / "fig06_front.svg", "fig06", "Front against spacing"),
                       fmt::format("Case {}: the water's front at the same times for each spacing. Numbers: <a "
                                   "href=\"data/fig06_front.csv\">data/fig06_front.csv</a>.",
                                   html::escape(name))) +
                   tabulated;
          }};
}

}  // namespace thalweg::paper
