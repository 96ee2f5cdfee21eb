#include "postproc/snapshot_files.hpp"

#include <fmt/format.h>

#include <string>

#include "common/version.hpp"
#include "postproc/line_profile.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> comments_of(const SnapshotResults& results, const std::string& place) {
  const ParticleFileInfo& info = results.profiles.info;
  std::vector<std::string> comments{
      fmt::format("case {}, t = {:g} s, step {}, particle spacing {:g} m, smoothing length {:g} m", info.case_name,
                  info.time, info.step, info.spacing, info.smoothing_length),
      fmt::format("written by thalweg-postproc {} from a run of thalweg {} on the case with hash {}", version(),
                  info.code_version, info.case_hash),
      fmt::format(
          "method: 0.5 crossing of the kernel sum of volume (Wendland C2, h = {:g} m) on a grid of {:g} m, bodies "
          "connected to the floor only, highest crossing in each column",
          info.smoothing_length, info.spacing / 2),
      fmt::format("moving_bed: upper edge of the sediment at rest ({}); layers below {:g} spacing count as absent",
                  results.measures.rest_criterion, least_layer)};
  if (!place.empty()) comments.push_back(place);
  return comments;
}

}  // namespace

fs::path SnapshotFiles::surface(SurfaceKind kind, const char* extension) const {
  return surface_stem.parent_path() / (name_of(kind) + surface_stem.filename().string() + extension);
}

SnapshotFiles files_at(double time, const RunFolder& run, const MeasureSettings& settings) {
  const fs::path name = profile_file_name(time);
  SnapshotFiles files{run.profiles() / "all" / name, {}, run.surfaces() / ("_" + name.stem().string())};
  for (const ProfileLine& line : settings.lines) files.lines.push_back(run.profiles() / line.name / name);
  return files;
}

void write(const SnapshotResults& results, const RunFolder& run, const MeasureSettings& settings) {
  const SnapshotFiles files = files_at(results.measures.time, run, settings);
  const ParticleFileInfo& info = results.profiles.info;
  const std::string plane = info.dimension == 3 ? fmt::format("in the plane y = {:g} m", settings.profile.plane_y) : "";
  write_profile(files.profile, results.profiles.along_x, comments_of(results, plane));
  for (std::size_t n = 0; n < settings.lines.size(); ++n) {
    write_profile(files.lines[n], results.profiles.lines[n], comments_of(results, description_of(settings.lines[n])));
  }
  for (const Surface& surface : results.surfaces) {
    write_surface(files.surface(surface.kind, ".vtp"), surface, info);
    if (info.dimension == 3) write_stl(files.surface(surface.kind, ".stl"), surface);
  }
}

}  // namespace thalweg
