#include "postproc/postprocess.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <iterator>
#include <nlohmann/json.hpp>

#include "case/models/surface_bed.hpp"
#include "case/reader/case_file.hpp"
#include "common/app/scour/scene.hpp"
#include "common/console.hpp"
#include "common/run_folder.hpp"
#include "common/warnings.hpp"
#include "common/whole_file.hpp"
#include "postproc/comparison.hpp"
#include "postproc/embedded.hpp"
#include "postproc/extraction_run.hpp"
#include "postproc/line_profile.hpp"
#include "postproc/movie.hpp"
#include "postproc/paper_figures.hpp"
#include "postproc/report.hpp"
#include "postproc/report_sources.hpp"
#include "postproc/run_records.hpp"
#include "postproc/snapshots.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

RunFolder existing_run(const fs::path& folder) {
  if (!fs::is_directory(folder)) {
    throw InputError(folder.string() +
                     ": there is no such folder; give the folder of a run (thalweg run CASE --out DIR)");
  }
  const RunFolder run{folder};
  if (!fs::exists(run.resolved_case())) {
    throw InputError(folder.string() +
                     ": is not the folder of a run, it holds no case.resolved.toml; make one with "
                     "thalweg-gencase CASE --out " +
                     folder.string());
  }
  return run;
}

// A sentence on a run whose snapshots end before the case does.
std::string shortfall_of(const RunFolder& run, const Case& resolved, double last_time) {
  const double end = resolved.output.end;
  if (last_time >= end * (1 - 1e-6)) return "";
  const double bed_end = resolved.surface_bed.end;
  if (bed_end > 0 && bed_time_at(read_scour(resolved, run.history()), last_time) >= bed_end) return "";
  const std::string reached = fmt::format("t = {:g} s of {:g} s", last_time, end);
  if (!fs::exists(run.diverged())) return "The results end at " + reached + ": the run was stopped, or it goes on";
  return "This run failed after " + reached + "; its particles then are in " + run.diverged().filename().string();
}

ExtractionOptions extraction_options(const PostprocessOptions& options, const Case& resolved) {
  ExtractionOptions extraction{{}, options.surfaces};
  for (const std::string& line : options.lines) {
    extraction.lines.push_back(parse_line(line));
    if (resolved.info.dimension == 2) throw InputError("--line " + line + ": a 2-D run has one profile, along x");
  }
  return extraction;
}

void print_extraction(const ExtractionRun& extraction, const RunFolder& run) {
  say(fmt::format("{} snapshots{}, {} profiles in {}", extraction.fronts.size(),
                  extraction.reused > 0 ? fmt::format(" ({} as an earlier pass left them)", extraction.reused) : "",
                  extraction.written.size(), run.profiles().string()));
}

void print_comparison(const ReportInput& input) {
  for (const std::string& note : input.reference_notes) say(note);
  if (const std::string table = table_of(input.comparison); !table.empty()) say(table);
  for (const std::string& remark : input.comparison.remarks) say("  " + remark);
}

// False if there is no frame.
bool draw_movie(ReportInput& input) {
  const Movie movie = make_movie(input.run, input.resolved);
  if (movie.frames > 0) {
    say(fmt::format("\nmovie: {} frames in {}{}", movie.frames, (input.run.root / "movie").string(),
                    movie.film.empty() ? "" : ", " + movie.film.string()));
  }
  input.warnings.insert(input.warnings.end(), movie.warnings.begin(), movie.warnings.end());
  return movie.frames > 0;
}

// False if a picture could not be drawn although gnuplot is there.
bool make_report(ReportInput& input, bool in_space) {
  const RunFolder& run = input.run;
  input.in_space = in_space;
  input.history = read_history(run.history());
  input.openings = read_openings(input.resolved, run.history());
  input.scour = read_scour(input.resolved, run.history());
  input.scour_checks = read_scour_checks(run, input.scour);
  input.formulas = formula_rows_of(read_scene(input.resolved));
  input.series = models::SurfaceBedOfCase::is_on(input.resolved)
                     ? series_of_columns(find_snapshots(run).entries, input.scour)
                     : series_of(input.extraction);
  input.answer = deepest_scour(input.extraction, input.scour);
  input.band = band_of(run, input.series, input.scour_checks, input.repeatability);
  input.map = make_run_bed_map(input.resolved, run, input.extraction);
  input.computed = read_computed(run);
  input.stations = velocity_stations(input.resolved, find_snapshots(run).entries);
  input.timing = read_timing(run.timing());
  input.summary = read_quantities(run.summary());
  input.methods = read_methods(run);
  input.units = units_of(input);
  write_costs(run.report() / "cost.csv", input.methods);
  for (const auto& file : {run.history(), run.timing(), run.summary()}) {
    if (!fs::exists(file)) input.warnings.push_back(file.string() + ": is missing; the report leaves its part out");
  }
  const bool drawn = write_report(input);
  say(fmt::format("\nreport: {}", (run.report() / "index.html").string()));
  return drawn;
}

/// The bed of the last snapshot as a survey, from which another case fills its bed.
void write_last_bed(const ReportInput& input, const fs::path& file) {
  const BedMap map = make_run_bed_map(input.resolved, input.run, input.extraction).map;
  if (!map.has_bed()) throw InputError(input.run.root.string() + ": has no bed; leave --bed-survey out");
  write_bed_survey(file, map, input.resolved.domain.from, input.resolved.domain.to);
  say(fmt::format("the bed at t = {:g} s: {}", map.time, file.string()));
}

/// The pass as --json tells it.
std::string result_of(const ReportInput& input, bool with_report) {
  nlohmann::ordered_json result{
      {"folder", input.run.root.string()},           {"case", input.resolved.info.name},
      {"snapshots", input.extraction.fronts.size()}, {"profiles", input.run.profiles().string()},
      {"time", input.extraction.last_time},          {"warnings", input.warnings}};
  if (with_report) result["report"] = (input.run.report() / "index.html").string();
  return result.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

Exit postprocess(const PostprocessOptions& options) {
  const RunFolder run = existing_run(options.folder);
  if (!options.bed_survey.empty() && options.bed_survey.extension() != ".csv") {
    throw InputError("--bed-survey " + options.bed_survey.string() +
                     ": a survey is read by its ending; let the name end in .csv");
  }
  remove_dead_parts(run.root);
  keep_log(run, "postproc");
  ReportInput input;
  input.run = run;
  input.resolved = read_case(run.resolved_case());
  input.compare_arguments = options.compare;
  std::vector<ProfileSet> named = read_named_sets(options.compare);  // before the work: a wrong name costs no waiting

  const ExtractionOptions extraction = extraction_options(options, input.resolved);
  input.extraction = extract_run(run, input.resolved, extraction);
  input.shortfall = shortfall_of(run, input.resolved, input.extraction.last_time);
  if (!input.shortfall.empty()) input.warnings.push_back(input.shortfall);
  input.warnings.insert(input.warnings.end(), input.extraction.warnings.begin(), input.extraction.warnings.end());
  for (std::string& warning : warnings_of_programs(run)) input.warnings.push_back(std::move(warning));
  write_whole_text(run.view_script(), [](std::ostream& stream) { stream << embedded::view_script; });
  print_extraction(input.extraction, run);
  if (!options.bed_survey.empty()) write_last_bed(input, options.bed_survey);

  input.sets.push_back(
      {run_label, SourceKind::run, run.profiles(), input.extraction.written, input.extraction.initial});
  add_mesh_models(input);
  std::move(named.begin(), named.end(), std::back_inserter(input.sets));
  add_measurements(input);
  compare_sources(input, extraction.lines, options.repeats);
  print_comparison(input);
  write_errors(run.report(), input.comparison);

  bool complete = !input.extraction.damaged;
  if (options.paper_figures) complete = write_paper_figures(input, options.series) && complete;
  if (options.movie) complete = draw_movie(input) && complete;
  if (options.report || options.in_space) complete = make_report(input, options.in_space) && complete;
  for (const std::string& warning : input.warnings) warn(warning);
  set_result(result_of(input, options.report || options.in_space));
  return complete ? Exit::done : Exit::run_failed;
}

}  // namespace thalweg
