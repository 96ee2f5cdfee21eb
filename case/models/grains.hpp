#pragma once

#include "physics/bed/grains.hpp"

namespace thalweg {

struct Case;

/// Grains and water of a case that has sediment.
Grains grains_of(const Case& of);

/// Height over the bed [m] at which grains pass between bed and water: suspended_load.reference_level, or the bed's
/// roughness.
double reference_level_of(const Case& of);

/// Volume share of grains [-] that a flat bed holds ready at the reference level under a friction velocity [m/s]: pick-up
/// over settling velocity, not more than the bed itself has.
double reference_concentration(const Grains& of, double friction_velocity);

}  // namespace thalweg
