#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "case/case.hpp"
#include "common/particle_source.hpp"
#include "common/particles.hpp"
#include "common/ranks.hpp"
#include "solver/simulation/input.hpp"

namespace thalweg {

/// The beginning of one of several ranks.
struct RankStart {
  AnyScene scene;
  ParticleSet particles;         // its share
  std::int64_t first_block = 0;  // of sums, in which the share begins
  std::shared_ptr<SurfaceBed> surface_bed{};
  std::optional<GpuMemory> gpu_memory{};
};

/// Makes the scene out of `particles`, which the first rank alone has, and deals them out: a rank is sent its share and
/// never has more. A bed that is a surface is the exception: every rank makes its columns out of all particles. Called by all
/// ranks. `may_use_gpus`, of which the first rank's counts: the memory that each GPU needs is estimated too, from all
/// particles. Throws InputError on all of them for what the solver cannot run; the first one's says why.
RankStart deal_out(const Case& of, const ParticleSet& particles, Ranks& ranks, bool may_use_gpus);

/// The same of particles that the first rank reads range by range, and keeps none of but its share: `source` there, nullptr on the
/// others. Of scenes that deals_in_ranges() is true for. Two particles with one id or in one place are refused, too, `file` being
/// named.
RankStart deal_out_in_ranges(const Case& of, ParticleSource* source, const std::string& file, Ranks& ranks);

}  // namespace thalweg
