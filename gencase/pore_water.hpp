#pragma once

#include "gencase/filling.hpp"

namespace thalweg::gencase {

/// Splits the bed, which was filled as one fluid, into grains and pore water (model.seepage = "mixture"). n is the
/// porosity.
/// - Sediment particles keep the mass of the grains, (1 - n) rho_grain of their volume.
/// - Particles of pore water with the mass n rho_w of their volume are added in the same places, after all others.
/// - Pressures become those of the water at rest under its own weight, for both sets.
/// - The grains' density, (1 - n) rho_grain at rest, is compressed by the submerged weight of the grains above.
/// `gravity` [m/s^2] along the lattice's columns, signed; `sound_speed` [m/s]. Returns the number of added particles.
std::size_t split_into_mixture(const Case& scene, const std::vector<PlacedShape>& shapes, const Filling& filling,
                               double gravity, double sound_speed, ParticleSet& particles);

}  // namespace thalweg::gencase
