#pragma once

#include <cstdint>

#include "case/case.hpp"
#include "common/run_folder.hpp"

namespace thalweg {

/// The particles that a run starts from, as far as room on the disk depends on them.
struct DiskUse {
  double time;  // [s]
  std::uint64_t particles;
  bool on_ranks;  // a file's arrays lie beside it while it is written
};

/// Bytes that the files of a run will take: an estimate that errs to the high side.
double disk_needed(const Case& scene, const DiskUse& start);

/// Says how much a run will write and how much is free, and warns if that is much, or more than there is: a run may be
/// meant to be stopped, and a full disk ends it with all files whole. Throws InputError above the case's disk_limit.
void check_disk(const Case& scene, const RunFolder& run, const DiskUse& start);

}  // namespace thalweg
