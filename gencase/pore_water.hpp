#pragma once

#include "gencase/filling.hpp"

namespace thalweg::gencase {

/// Makes a bed of one fluid, as filled, into grains and pore water (model.seepage = "mixture"): the sediment's
/// particles keep the grains' mass, (1 - n) rho_grain of the volume, and pore water of n rho_w is added in their
/// places, behind all others. Pressures and densities become those of rest: the water's from its own weight, in
/// sediment that of the water; the packing compressed by the submerged weight of the grains above, in a density that is
/// that of the grains with their share of the pores. `gravity` [m/s^2] along the lattice's columns, signed; returns how
/// many were added.
std::size_t split_into_mixture(const Case& scene, const std::vector<PlacedShape>& shapes, const Filling& filling,
                               double gravity, double sound_speed, ParticleSet& particles);

}  // namespace thalweg::gencase
