#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <filesystem>
#include <string>

#include "common/particles.hpp"
#include "common/whole_file.hpp"

namespace thalweg {

/// Adds a number, a text, or a point [m] as one entry of three components, to the field data.
void add_fact(vtkPolyData* data, const char* name, float value);
void add_fact(vtkPolyData* data, const char* name, std::int64_t value);
void add_fact(vtkPolyData* data, const char* name, const std::string& value);
void add_fact(vtkPolyData* data, const char* name, const Vec3& value);

/// Adds the facts of `info` that every file of a scene has to the field data, under the names of docs/file-formats.md.
/// The lattice node is left to particle files.
void add_facts(vtkPolyData* data, const ParticleFileInfo& info);

/// Reads VTK XML PolyData of any program. Throws InputError "file: what is wrong; what to do".
vtkSmartPointer<vtkPolyData> read_poly_data(const std::filesystem::path& file);

/// VTK XML PolyData in the encoding of all our files (inline binary, zlib, 64-bit headers), without their seal. Throws RunError
/// naming the file it is for, and cause.
std::string poly_data_text(const std::filesystem::path& file, vtkPolyData* data);

/// Writes the same, sealed, whole or not at all.
void write_poly_data(const std::filesystem::path& file, vtkPolyData* data, const WholeFile& how = {});

}  // namespace thalweg
