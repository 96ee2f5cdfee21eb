#pragma once

#include "physics/bed/grains.hpp"

namespace thalweg {

struct Case;

/// Grains and water of a case that has sediment.
Grains grains_of(const Case& of);

/// Height over the bed [m] at which grains pass between bed and water: suspended_load.reference_level, or the bed's
/// roughness.
double reference_level_of(const Case& of);

/// Share of the shear stress on the bed that moves grains [-]: surface_bed.grain_stress, 1 for beds of particles.
double grain_stress_of(const Case& of);

/// Settling velocity [m/s] of a grain that the water carries: of suspended_load.diameter, or of the bed's grains.
double suspended_settling_velocity(const Case& of);

/// Volume share of grains [-] that a flat bed holds ready at the reference level under the friction velocity [m/s] of the
/// stress that moves grains: pick-up over settling velocity [m/s], not more than the bed itself has.
double reference_concentration(const Grains& of, double friction_velocity, double settling_velocity);

}  // namespace thalweg
