#include "solver/program/disk.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>

#include "common/error.hpp"
#include "common/memory.hpp"
#include "common/units.hpp"
#include "solver/program/schedule.hpp"

namespace thalweg {
namespace {

// Bytes a particle, compressed. Louvain at 5 mm has 34 in a snapshot of a three-state bed in full motion and 86 in a
// checkpoint; a third coordinate and further models add to it.
constexpr double snapshot_bytes = 45;
constexpr double checkpoint_bytes = 120;
constexpr double many_snapshots = 10'000;
constexpr double checkpoints = 3;  // two are kept while a third is written

double snapshots_left(const Case& scene, double from) {
  const std::vector<double> times = snapshot_times(scene);
  return static_cast<double>(std::count_if(times.begin(), times.end(), [&](double t) { return t >= from; }));
}

}  // namespace

double disk_needed(const Case& scene, const DiskUse& start) {
  const double kept = checkpoints + (start.on_ranks ? 1 : 0);
  const double bytes = snapshots_left(scene, start.time) * snapshot_bytes + kept * checkpoint_bytes;
  return bytes * static_cast<double>(start.particles);
}

void check_disk(const Case& scene, const RunFolder& run, const DiskUse& start) {
  std::error_code unknown;
  const auto space = std::filesystem::space(run.root, unknown);
  if (unknown) return;
  const auto free = static_cast<double>(space.available);
  const double needed = disk_needed(scene, start);
  const double snapshots = snapshots_left(scene, start.time);
  spdlog::info("{:.0f} snapshots to come, about {}; {} are free", snapshots, format_bytes(needed), format_bytes(free));
  if (snapshots > many_snapshots) {
    spdlog::warn("every snapshot ends a time step: {:.0f} of them slow the run down; lengthen output.interval (now {})",
                 snapshots, format_quantity(scene.output.interval, "s"));
  }
  if (scene.output.disk_limit > 0 && needed > scene.output.disk_limit) {
    throw InputError(fmt::format(
        "{}: the files of the run will take about {}, and output.disk_limit is {}; lengthen output.interval (now {}), "
        "or raise the limit",
        run.root.string(), format_bytes(needed), format_bytes(scene.output.disk_limit),
        format_quantity(scene.output.interval, "s")));
  }
  if (needed > free / 2) {
    spdlog::warn(
        "{}: the files of the run will take {} of the free space; lengthen output.interval (now {}), or make room",
        run.root.string(), needed > free ? "more than all" : "more than half",
        format_quantity(scene.output.interval, "s"));
  }
}

}  // namespace thalweg
