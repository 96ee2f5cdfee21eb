#pragma once

#include <functional>
#include <string>

#include "foam_reference/openings.hpp"
#include "foam_reference/wall_patches.hpp"

namespace thalweg::foam {

/// Entries of all patches of a field. Those for empty and cyclic patches follow from the mesh.
std::string boundary(const FoamCase& foam_case, const std::function<std::string(const WallPatch&)>& at_walls,
                     const std::string& at_open, const std::function<std::string(const OpeningPatch&)>& at_openings);

/// A file of 0.orig: the field's one value inside, and its patches.
std::string field_file(const FoamCase& foam_case, const std::string& foam_class, const std::string& name,
                       const std::string& purpose, const std::string& dimensions, const std::string& value,
                       const std::string& patches);

/// k, omega and nut; none without wall functions.
CaseFiles turbulence_fields(const FoamCase& foam_case);

/// Cs of nutkRoughWallFunction for Nikuradse's roughness [m] at a friction velocity [m/s], viscosity [m^2/s].
double roughness_constant(double roughness, double friction_velocity, double viscosity);

}  // namespace thalweg::foam
