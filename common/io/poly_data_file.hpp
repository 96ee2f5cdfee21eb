#pragma once

#include <vtkPolyData.h>

#include <filesystem>

#include "common/particles.hpp"

namespace thalweg {

/// Adds a single number to the field data.
void add_fact(vtkPolyData* data, const char* name, float value);

/// Adds what `info` says to the field data, under the names of docs/file-formats.md.
void add_facts(vtkPolyData* data, const ParticleFileInfo& info);

/// Writes VTK XML PolyData as all our files are (inline binary, zlib, 64-bit headers), whole or not at all. Throws
/// RunError naming file and cause.
void write_poly_data(const std::filesystem::path& file, vtkPolyData* data);

}  // namespace thalweg
