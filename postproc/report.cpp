#include "postproc/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "common/csv.hpp"
#include "common/io/particle_file.hpp"
#include "common/whole_file.hpp"
#include "postproc/figures/figure_writer.hpp"
#include "postproc/figures/method_figures.hpp"
#include "postproc/gnuplot.hpp"
#include "postproc/html.hpp"
#include "postproc/report_scripts.hpp"
#include "postproc/report_sections.hpp"
#include "postproc/report_style.hpp"
#include "postproc/space_time.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

// The curves of every source as they are drawn, in one format, so that the report's folder can travel alone.
std::vector<fs::path> write_curves(const ReportInput& input) {
  std::vector<fs::path> folders;
  std::set<std::string> taken;
  for (const ProfileSet& set : input.sets) {
    std::string name = folder_name_of(set.label);
    while (!taken.insert(name).second) name += "_";
    folders.push_back(input.run.report() / "data" / name);
    for (const TimedProfile& timed : set.profiles) {
      std::vector<std::string> comments{set.label + ", copied for the pictures from " + timed.file.string()};
      for (const std::string& line : comments_in(timed.file)) comments.push_back(line);
      write_profile(folders.back() / profile_file_name(timed.time), timed.profile, comments);
    }
  }
  return folders;
}

// The front of every source at the times of its profiles, found as the run's own.
void write_fronts(const fs::path& file, const ReportInput& input) {
  const double least_depth = least_layer * input.extraction.info.spacing;
  std::vector<CsvColumn> columns{{"time", "s"}};
  for (const ProfileSet& set : input.sets) columns.push_back({set.label, "m"});
  CsvTable table(columns);
  table.comments.push_back(fmt::format("largest x with more than {:g} m of water over the bed", least_depth));
  for (const TimedProfile& row : input.extraction.written) {
    std::vector<std::string> cells{csv_number(row.time)};
    for (const ProfileSet& set : input.sets) {
      const TimedProfile* timed = set.at(row.time);
      const bool is_model = set.kind == SourceKind::run || set.kind == SourceKind::mesh;
      const MissingColumn missing = is_model ? MissingColumn::dry : MissingColumn::unknown;
      const double front = timed != nullptr ? water_front(timed->profile, least_depth, missing) : Profile::missing;
      cells.push_back(std::isnan(front) ? "" : fmt::format("{:.5f}", front));
    }
    table.add_row(std::move(cells));
  }
  table.write(file);
}

std::vector<fs::path> write_scripts(const ReportInput& input, const fs::path& pictures) {
  const std::vector<fs::path> data = write_curves(input);
  const fs::path fronts = input.run.report() / "fronts.csv";
  write_fronts(fronts, input);
  const PictureFrame frame = frame_around(input.sets, input.resolved.compare.from, input.resolved.compare.to);
  const FigureWriter writer(pictures);
  std::vector<fs::path> scripts;
  for (const TimedProfile& timed : input.extraction.written) {
    scripts.push_back(writer.profiles(timed.time, input.sets, data, frame, input.units.height));
  }
  if (has_front(input.extraction)) {
    scripts.push_back(writer.front(input.run.profiles() / "front.csv", fronts, input.sets));
  }
  if (input.history.rows > 0) {
    scripts.push_back(writer.energies(input.run.history(), !input.history.internal_energy.empty(),
                                      input.resolved.info.dimension == 2 ? "J/m" : "J"));
  }
  for (fs::path& script : bed_scripts(input, pictures)) scripts.push_back(std::move(script));
  if (!input.openings.openings.empty()) {
    const fs::path table = input.run.report() / "data" / "openings.csv";
    write_openings(table, input.openings, input.resolved.info.dimension);
    scripts.push_back(writer.discharges(table, input.openings, input.resolved.info.dimension == 2 ? "m^2/s" : "m^3/s"));
    if (report_sections::has_levels(input.openings))
      scripts.push_back(writer.levels_at_openings(table, input.openings, input.units.height));
  }
  if (!input.stations.empty()) {
    const fs::path table = input.run.report() / "data" / "stations.csv";
    write_velocity_stations(table, input.stations);
    std::vector<MeshStations> meshes;
    for (const MeshModel& mesh : input.meshes) {
      if (mesh.stations.empty()) continue;
      meshes.push_back(
          {mesh.label, table.parent_path() / fmt::format("stations-mesh{}.csv", meshes.size() + 1), mesh.stations});
      write_velocity_stations(meshes.back().table, mesh.stations);
    }
    scripts.push_back(writer.stations(table, input.stations, meshes, input.units.height));
  }
  constexpr std::size_t most_points = 200'000;  // more than a picture resolves
  const ParticleTable table =
      write_particle_table(input.run.report() / "data" / "particles.csv",
                           read_particles(input.extraction.last_snapshot), input.extraction.plane_y, most_points);
  for (fs::path& script : method_scripts(input.methods, input.sets.front(), frame, input.run, input.units.height)) {
    scripts.push_back(std::move(script));
  }
  const double spacing = input.extraction.info.spacing;
  if (!table.kinds.empty()) scripts.push_back(writer.particles(table, frame, spacing));
  if (fs::exists(input.run.particles())) {
    const ParticleTable start =
        write_particle_table(input.run.report() / "data" / "scene.csv", read_particles(input.run.particles()),
                             input.extraction.plane_y, most_points, true);
    scripts.push_back(writer.scene(start, frame.widened(3.5 * spacing), spacing));
  }
  if (input.bed_history.times > 0) {
    scripts.push_back(writer.space_time(input.bed_history.file, input.run.profiles() / "front.csv", frame, spacing,
                                        std::max(input.bed_history.largest, spacing), input.units.height));
  }
  return scripts;
}

}  // namespace

bool write_report(ReportInput& input) {
  // Those of an earlier run would pass for this one's where gnuplot cannot draw.
  for (const char* made : {"pictures", "data"}) fs::remove_all(input.run.report() / made);
  input.bed_history = write_bed_history(input.run.report() / "data" / "bed_change.csv", input);
  const fs::path pictures = input.run.report() / "pictures";
  if (const std::size_t old = report_sections::old_paraview_pictures(input); old > 0) {
    input.warnings.push_back(
        fmt::format("pictures in report/paraview that are older than the snapshots are left out ({}); draw them again: "
                    "pvbatch view.py --pictures report/paraview",
                    old));
  }
  const bool drawn = draw_pictures(write_scripts(input, pictures), input.warnings);
  SpaceScene space;
  if (input.in_space) {
    space = make_space_scene(input);
    if (!space.why_not.empty()) input.warnings.push_back(space.why_not);
  }
  namespace part = report_sections;
  const std::string title = input.resolved.info.title.empty() ? input.resolved.info.name : input.resolved.info.title;
  write_whole_text(input.run.report() / "index.html", [&](std::ostream& page) {
    page << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" << html::escape(title)
         << "</title>\n<style>" << report_style << "</style>\n</head>\n<body>\n";
    const bool bed = input.answer.has_value();
    // The first screen: what was asked, the answer, and its course over time.
    page << part::heading(input) << part::question(input) << part::answer(input)
         << (bed ? part::scour(input, pictures)
                 : part::openings(input, pictures) + part::front_and_energies(input, pictures));
    if (!input.warnings.empty()) page << part::remarks(input);
    page << part::scene(input, pictures) << part::bed_map(input, pictures) << part::sections(input, pictures)
         << part::bed_shear(input, pictures) << part::space_view(input, space)
         << (bed ? part::openings(input, pictures) : "") << part::formulas(input) << part::conclusions(input)
         << part::which_is_which(input) << part::profiles(input, pictures) << part::errors(input) << part::cost(input)
         << part::methods(input, pictures);
    if (bed) page << part::front_and_energies(input, pictures);
    page << part::stations(input, pictures) << part::space_time(input, pictures) << part::particles(input, pictures)
         << part::run_numbers(input) << part::model(input);
    if (input.warnings.empty()) page << part::remarks(input);
    page << part::provenance(input) << part::hover(input) << "</body>\n</html>\n";
  });
  return drawn;
}

}  // namespace thalweg
