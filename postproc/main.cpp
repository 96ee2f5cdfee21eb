#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <vector>

#include "common/command_line.hpp"
#include "common/error.hpp"
#include "postproc/postprocess.hpp"

namespace {

int run(int argc, char** argv) {
  thalweg::PostprocessOptions options;
  CLI::App app{
      "Extracts surfaces, profiles and their series from a run's snapshots, compares them with a mesh model and with "
      "measurements, and writes a report.",
      "thalweg-postproc"};
  std::vector<std::filesystem::path> folders;
  std::string figures;
  app.add_option("DIR", folders, "folder of the run; with --figures also those of a series of runs of one case")
      ->required();
  app.add_option("--compare", options.compare,
                 "further profiles: a file (t0.250.csv), a folder of them, or another run; LABEL=PATH names the source")
      ->type_name("[LABEL=]PATH");
  app.add_option("--line", options.lines,
                 "3-D: a further line in plan for profiles, \"NAME=0 m,0.1 m,1 m,0.1 m\": x and y of its ends")
      ->type_name("NAME=X0,Y0,X1,Y1");
  app.add_option("--repeat", options.repeats,
                 "folders of further runs of the same case, for the scatter between equal runs")
      ->type_name("DIR");
  app.add_option("--bed-survey", options.bed_survey,
                 "write the bed of the last snapshot to this CSV file, as a survey for the bed of another case");
  app.add_flag("!--no-surfaces", options.surfaces, "write no surfaces/*.vtp and *.stl");
  app.add_flag("--report", options.report, "draw the pictures and write report/index.html (needs gnuplot)");
  app.add_flag("--3d", options.in_space,
               "the report with a 3-D view of bed and free surface, and a slider for the time");
  app.add_flag("--movie", options.movie, "draw every snapshot: movie/*.png, and movie.mp4 where ffmpeg is installed");
  app.add_option("--figures", figures, "the figures of the source paper from this run, in report/paper (needs gnuplot)")
      ->check(CLI::IsMember({"paper"}));
  if (const std::optional<int> answered = thalweg::parse_command_line(app, argc, argv)) return *answered;
  options.folder = folders.front();
  options.series.assign(folders.begin() + 1, folders.end());
  options.paper_figures = !figures.empty();
  if (!options.series.empty() && !options.paper_figures) {
    throw thalweg::InputError("more than one folder is for --figures; to compare runs, thalweg postproc " +
                              options.folder.string() + " --compare " + options.series.front().string());
  }
  return static_cast<int>(thalweg::postprocess(options));
}

}  // namespace

int main(int argc, char** argv) { return thalweg::run_program(run, argc, argv); }
