#pragma once

#include <string>

#include "foam_reference/case_files.hpp"

namespace thalweg::foam {

/// The files of the surface meshes of solid walls that the case names, and the dictionary that takes their inside out
/// of the mesh; empty if there are none. Throws InputError where a file cannot be read.
CaseFiles surface_files(const FoamCase& foam_case);

/// The steps of Allrun after blockMesh that use them.
std::string surface_steps(const FoamCase& foam_case);

}  // namespace thalweg::foam
