#pragma once

#include <filesystem>

#include "common/particles.hpp"

namespace thalweg {

/// Precision of the positions in a particle file: snapshots are for looking at, particles.vtp and checkpoints go on.
enum class PositionPrecision { single_precision, double_precision };

/// Writes VTK XML PolyData (inline binary, zlib, 64-bit header, Verts, FieldData TimeValue; docs/file-formats.md).
/// The file appears whole or not at all (temporary name, then rename). Throws RunError naming file and cause.
void write_particles(const std::filesystem::path& file, const ParticleSet& particles, PositionPrecision precision);

/// Reads what write_particles wrote, and any PolyData with `Type` and `Id` arrays (missing arrays stay empty).
/// Throws InputError "file: what is wrong; what to do".
ParticleSet read_particles(const std::filesystem::path& file);

/// Reads only the FieldData and the number of points, without the arrays.
ParticleFileInfo read_particle_info(const std::filesystem::path& file);

}  // namespace thalweg
