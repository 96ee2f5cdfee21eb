#pragma once

#include <string>

#include "foam_reference/case_files.hpp"

namespace thalweg::foam {

/// Surface meshes of solid walls as the case names them, and the dictionary that takes their inside out of the mesh;
/// nothing without. Throws InputError.
CaseFiles surface_files(const FoamCase& foam_case);

/// What Allrun does with them after blockMesh.
std::string surface_steps(const FoamCase& foam_case);

}  // namespace thalweg::foam
