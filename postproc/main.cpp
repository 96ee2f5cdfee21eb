#include <CLI/CLI.hpp>

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
  app.add_option("DIR", options.folder, "folder of the run")->required();
  app.add_option("--compare", options.compare,
                 "further profiles: a file (t0.250.csv), a folder of them, or another run; LABEL=PATH names the source")
      ->type_name("[LABEL=]PATH");
  app.add_option("--line", options.lines,
                 "3-D: a further line in plan for profiles, \"NAME=0 m,0.1 m,1 m,0.1 m\": x and y of its ends")
      ->type_name("NAME=X0,Y0,X1,Y1");
  app.add_option("--repeat", options.repeats, "folders of runs that should give the same, for the scatter of the run")
      ->type_name("DIR");
  app.add_flag("!--no-surfaces", options.surfaces, "write no surfaces/*.vtp and *.stl");
  app.add_flag("--report", options.report, "draw the pictures and write report/index.html (needs gnuplot)");
  if (const std::optional<int> answered = thalweg::parse_command_line(app, argc, argv)) return *answered;
  return static_cast<int>(thalweg::postprocess(options));
}

}  // namespace

int main(int argc, char** argv) { return thalweg::run_program(run, argc, argv); }
