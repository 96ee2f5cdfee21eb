#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "common/particles.hpp"
#include "common/position_precision.hpp"
#include "common/whole_file.hpp"

namespace thalweg {

/// Writes all arrays and facts of `particles` as VTK XML PolyData (inline binary, zlib, 64-bit header, Verts, FieldData
/// TimeValue; docs/file-formats.md). The file appears whole or not at all (temporary name, then rename). Throws
/// RunError naming file and cause: an array that does not fit the number of particles, two arrays of one name, a disk
/// that is full. `texts` go into the field data, under their names.
void write_particles(const std::filesystem::path& file, const ParticleSet& particles, PositionPrecision precision,
                     const std::map<std::string, std::string>& texts = {}, const WholeFile& how = {});

/// Reads what write_particles wrote, and any PolyData with `Type` and `Id` arrays. Missing arrays stay empty; arrays of
/// other names than the members' go into `scalars` (float) or `doubles` (any other type).
/// `texts` receives all texts of the field data. Throws InputError "file: what
/// is wrong; what to do", also for a file whose seal (file_seal.hpp) does not fit it.
ParticleSet read_particles(const std::filesystem::path& file, std::map<std::string, std::string>* texts = nullptr);

/// Reads only the FieldData and the number of points, without the arrays.
ParticleFileInfo read_particle_info(const std::filesystem::path& file);

}  // namespace thalweg
