#pragma once

#include <filesystem>

#include "common/particles.hpp"

namespace thalweg {

/// Precision of the positions in a particle file: single for snapshots, which are looked at, double for particles.vtp
/// and checkpoints, from which a run goes on.
enum class PositionPrecision { single_precision, double_precision };

/// Writes all arrays and facts of `particles` as VTK XML PolyData (inline binary, zlib, 64-bit header, Verts, FieldData
/// TimeValue; docs/file-formats.md). The file appears whole or not at all (temporary name, then rename). Throws
/// RunError naming file and cause: an array that does not fit the number of particles, two arrays of one name, a disk
/// that is full.
void write_particles(const std::filesystem::path& file, const ParticleSet& particles, PositionPrecision precision);

/// Reads what write_particles wrote, and any PolyData with `Type` and `Id` arrays. Missing arrays stay empty; arrays of
/// other names than the members' go into `scalars` (float) or `doubles` (any other type).
/// Throws InputError "file: what is wrong; what to do".
ParticleSet read_particles(const std::filesystem::path& file);

/// Reads only the FieldData and the number of points, without the arrays.
ParticleFileInfo read_particle_info(const std::filesystem::path& file);

}  // namespace thalweg
