#pragma once

#include <string>
#include <vector>

#include "foam_reference/current.hpp"

namespace thalweg::foam {

/// Conditions of a field at an inlet or outlet: the entries of its patch in 0.orig.
///   inlet    the share of water by the inlet's surface (all of it, up to a level, or as the cells next to the plane);
///            the velocity in the share's and the profile's proportion, so that the flow rate is the case's; k and omega
///            of the profile
///   fall     water leaves at atmospheric pressure, as through an open face
///   level    hydrostatic pressure under the level; what flows back in is what stands next to the plane
///   pump     the inlets' flow rate leaves, in proportion to the share of water next to the plane
std::string alpha_at(const FoamCase& foam_case, const OpeningPatch& patch);
std::string velocity_at(const FoamCase& foam_case, const OpeningPatch& patch);
std::string pressure_at(const FoamCase& foam_case, const OpeningPatch& patch);
std::string k_at(const FoamCase& foam_case, const OpeningPatch& patch);
std::string omega_at(const FoamCase& foam_case, const OpeningPatch& patch);

/// Values over time as an expression of OpenFOAM: linear between the rows, constant before and after; `steady` without
/// rows. Of "time()", or another variable.
std::string over_time(const std::vector<double>& times, const std::vector<double>& values, double steady,
                      const std::string& variable = "time()");

}  // namespace thalweg::foam
