#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "case/reader/case_file.hpp"
#include "common/app/info.hpp"
#include "common/error.hpp"
#include "common/io/particle_file.hpp"
#include "common/io/run_results.hpp"
#include "common/io/series.hpp"
#include "common/memory.hpp"
#include "common/particle_words.hpp"
#include "common/run_folder.hpp"
#include "common/warnings.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json particles_object(const fs::path& file) {
  const ParticleSet p = read_particles(file);
  Json object{{"file", file.string()},
              {"case", p.info.case_name},
              {"case_hash", p.info.case_hash},
              {"version", p.info.code_version},
              {"dimension", p.info.dimension},
              {"time", p.info.time},
              {"step", p.info.step},
              {"spacing", p.info.spacing},
              {"smoothing_length", p.info.smoothing_length},
              {"bytes", fs::file_size(file)},
              {"count", p.size()}};
  const auto counts = count_by_type(p);
  const auto masses = mass_by_type(p);
  for (std::size_t type = 0; type < counts.size(); ++type)
    object["types"][type_words[type]] = {{"count", counts[type]}, {"mass", masses[type]}};
  if (p.size() == 0) return object;
  Vec3 low = p.position.front();
  Vec3 high = low;
  for (const Vec3& position : p.position) {
    low = low.cwiseMin(position);
    high = high.cwiseMax(position);
  }
  object["from"] = {low.x(), low.y(), low.z()};
  object["to"] = {high.x(), high.y(), high.z()};
  object["arrays"] = Json::array();
  for (const auto& [name, values] : p.scalars) object["arrays"].push_back(name);
  for (const auto& [name, values] : p.doubles) object["arrays"].push_back(name);
  const MemoryEstimate memory = estimate_memory(static_cast<double>(p.size()), p.info.dimension);
  object["memory"] = {{"cpu", memory.total()}, {"gpu", memory.gpu}, {"host", memory.host}};
  return object;
}

Json series_object(const fs::path& pvd) {
  Json object{{"file", pvd.string()}, {"snapshots", Json::array()}};
  for (const SeriesEntry& entry : read_series(pvd))
    object["snapshots"].push_back({{"time", entry.time}, {"file", entry.file.string()}});
  return object;
}

Json case_object(const fs::path& file) {
  const Case scene = read_case(file);
  return {{"file", file.string()},
          {"name", scene.info.name},
          {"title", scene.info.title},
          {"dimension", scene.info.dimension},
          {"spacing", scene.numerics.spacing},
          {"end", scene.output.end},
          {"hash", hash_of(scene)}};
}

Json run_object(const RunFolder& run) {
  Json object{{"folder", run.root.string()}};
  const std::size_t bare = object.size();
  if (fs::exists(run.resolved_case())) object["case"] = case_object(run.resolved_case());
  if (fs::exists(run.particles())) object["particles"] = particles_object(run.particles());
  if (fs::exists(run.snapshot_series())) object["series"] = series_object(run.snapshot_series());
  if (fs::exists(run.checkpoint())) object["checkpoint"] = particles_object(run.checkpoint());
  if (fs::exists(run.summary())) object["summary"] = Json::parse(summary_json(run));
  if (object.size() == bare)
    throw InputError(run.root.string() + ": the folder holds no run; name one that thalweg gencase has filled");
  const fs::path report = run.report() / "index.html";
  if (fs::exists(report)) object["report"] = report.string();
  object["warnings"] = warnings_of_programs(run);
  return object;
}

Json object_of(const fs::path& path) {
  if (fs::is_directory(path)) return run_object(RunFolder{path});
  if (!fs::exists(path)) throw InputError(path.string() + ": there is no such file or folder; check the name");
  if (path.extension() == ".pvd") return series_object(path);
  if (path.extension() == ".toml") return case_object(path);
  return particles_object(path);
}

}  // namespace

std::string info_json(const fs::path& file_or_folder) {
  return object_of(file_or_folder).dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace thalweg
