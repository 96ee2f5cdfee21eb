#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "solver/program/checkpoint_file.hpp"

// A run goes on from a checkpoint of its own case only. Device, instruction set and number of threads are no part of a
// case and may differ.
namespace thalweg {

/// A key, or a table with all its keys, that may change at a restart.
struct RestartRule {
  const char* key;
  bool asked;  // only if --restart-anyway names the key
  const char* reason;
};

/// The keys that may change. All others decide what the particles are or which arrays they have.
inline constexpr std::array restart_rules{
    RestartRule{"case.name", false, "a name"},
    RestartRule{"case.title", false, "a text"},
    RestartRule{"case.source", false, "a text"},
    RestartRule{"output", false, "what is written, and when"},
    RestartRule{"compare", false, "read by postproc"},
    RestartRule{"line", false, "read by postproc"},
    RestartRule{"foam", false, "read by the mesh model"},
    RestartRule{"gauge", true, "gauges.csv gets other columns; the rows so far are put aside"},
    RestartRule{"materials.water.viscosity", true, "another fluid from here on"},
    RestartRule{"numerics.accuracy", true, "a level of the keys below"},
    RestartRule{"numerics.cfl", true, "other time steps"},
    RestartRule{"numerics.density_diffusion", true, "another scheme from here on"},
    RestartRule{"numerics.artificial_viscosity", true, "another scheme from here on"},
    RestartRule{"numerics.acoustic_damper", true, "another scheme from here on"},
    RestartRule{"numerics.viscosity", true, "another solver of the same equation"},
    RestartRule{"numerics.viscous_tolerance", true, "another residual"},
    RestartRule{"numerics.viscous_iterations", true, "another limit"},
    RestartRule{"numerics.list_skin", true, "other lists of the same neighbours"},
    RestartRule{"numerics.excluded_limit", true, "another limit"},
    RestartRule{"numerics.precision", true, "other rounding"},
    RestartRule{"surface_bed.factor", true, "another pace of the bed from here on"},
    RestartRule{"surface_bed.step", true, "other steps of the bed from here on"},
    RestartRule{"version", true, "the version of Thalweg that wrote the checkpoint"},
};

/// Throws InputError naming the keys that differ between the checkpoint's case and `now`, unless they may change and
/// `anyway` names those that have to be asked for; or naming a word of `anyway` that is no such key.
void check_restart(const std::filesystem::path& file, const Checkpoint& from, const Case& now,
                   const std::vector<std::string>& anyway);

}  // namespace thalweg
