#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "postproc/surface_field.hpp"

namespace thalweg {

enum class SurfaceKind { free_surface, bed, motionless_bed };
inline constexpr std::array<SurfaceKind, 3> surface_kinds{SurfaceKind::free_surface, SurfaceKind::bed,
                                                          SurfaceKind::motionless_bed};
/// "free_surface", as in the names of files.
const char* name_of(SurfaceKind kind);

/// A surface with its arrays (docs/file-formats.md): triangles in 3-D, polylines in 2-D.
struct Surface {
  SurfaceKind kind;
  vtkSmartPointer<vtkPolyData> data;
};

/// The surfaces the set has, contoured with VTK where the field of a body crosses 1/2: without sediment only the free
/// surface. Drops and floating grains are left out; what lies inside walls is cut off; a floor bare of sediment under
/// water belongs to the beds. `initial` is the map of the run's first snapshot, from which the bed's change counts.
std::vector<Surface> make_surfaces(const ParticleSet& particles, const CellList& cells, const SurfaceField& field,
                                   const LevelMap& initial);

/// Writes a surface with the facts of its snapshot, whole or not at all. Throws RunError.
void write_surface(const std::filesystem::path& file, const Surface& surface, const ParticleFileInfo& info);
/// The triangles alone, binary, in metres.
void write_stl(const std::filesystem::path& file, const Surface& surface);

}  // namespace thalweg
