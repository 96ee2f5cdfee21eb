#include "postproc/snapshots.hpp"

#include <algorithm>

#include "common/error.hpp"
#include "common/io/particle_file.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

SnapshotList scan_folder(const fs::path& folder) {
  SnapshotList list;
  if (!fs::is_directory(folder)) return list;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".vtp" || name.starts_with('.')) continue;
    try {
      list.entries.push_back({read_particle_info(entry.path()).time, entry.path()});
    } catch (const InputError& error) {
      list.warnings.emplace_back(std::string("skipped: ") + error.what());
      list.damaged = true;
    }
  }
  std::sort(list.entries.begin(), list.entries.end(), [](const SeriesEntry& a, const SeriesEntry& b) {
    return std::pair(a.time, a.file) < std::pair(b.time, b.file);
  });
  return list;
}

}  // namespace

SnapshotList find_snapshots(const RunFolder& run) {
  SnapshotList list;
  std::string trouble = run.snapshot_series().string() + ": is missing";
  if (fs::exists(run.snapshot_series())) {
    try {
      list.entries = read_series(run.snapshot_series());
      for (SeriesEntry& entry : list.entries) entry.file = run.snapshot_series().parent_path() / entry.file;
      trouble = list.entries.empty() ? run.snapshot_series().string() + ": lists no snapshot" : "";
    } catch (const InputError& error) {
      trouble = error.what();
    }
  }
  if (!trouble.empty()) {
    list = scan_folder(run.snapshots());
    if (list.entries.empty() && list.warnings.empty()) {
      throw InputError(run.root.string() + ": holds no snapshots; compute them with thalweg-solver " +
                       run.root.string());
    }
    list.warnings.insert(list.warnings.begin(),
                         trouble + "; the times were taken from the files in " + run.snapshots().string());
  }
  return list;
}

ParticleSet first_readable(const std::vector<SeriesEntry>& entries) {
  for (const SeriesEntry& entry : entries) {
    try {
      return read_particles(entry.file);
    } catch (const InputError&) {
      if (&entry == &entries.back()) throw;
    }
  }
  throw InputError("there is no snapshot; compute the run again");
}

}  // namespace thalweg
