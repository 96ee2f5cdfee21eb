#pragma once

#include "common/particles.hpp"
#include "gencase/filling.hpp"

namespace thalweg::gencase {

/// What a relaxation did. Unevenness: h |sum_j V grad W_ij|, 0 for a particle evenly surrounded [-].
struct Relaxation {
  int sweeps = 0;
  std::int64_t particles = 0;  // that may move
  std::int64_t too_near = 0;   // that stood less than half a spacing from the walls' skin
  double before = 0;           // root mean square of their unevenness once those had stepped back
  double after = 0;
  double farthest = 0;  // [m] that one of them went
};

/// Fits fluid to curved and oblique walls. The lattice runs through walls and fluid alike, so that kernel sums are even
/// at once, but the walls' true skin cuts it anywhere: particles nearer to it than half a spacing step back to half a
/// spacing, then those whose kernel meets walls and no free surface shift down the gradient of the kernel sum (particle
/// shifting, Lind et al. 2012, J. Comput. Phys. 231, 1499-1523), never nearer to the skin and at most a spacing in all.
/// Those that see walls and the free surface step back only.
/// Ends after `sweeps` or when a sweep gains less than a thousandth. Beside flat walls that the lattice fits nothing
/// moves. Pressures, densities and masses follow the new heights: `gravity` [m/s^2] along the lattice's columns,
/// `sound_speed` [m/s].
Relaxation relax(ParticleSet& particles, const std::vector<PlacedShape>& shapes, const SkinSearch& skin,
                 const Filling& filling, int sweeps, double gravity, double sound_speed);

}  // namespace thalweg::gencase
