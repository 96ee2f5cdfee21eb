#pragma once

#include "common/particles.hpp"
#include "gencase/filling.hpp"

namespace thalweg::gencase {

/// Result of a relaxation. The unevenness of a particle is h |sum_j V grad W_ij| [-], 0 if its neighbours surround it
/// evenly.
struct Relaxation {
  int sweeps = 0;
  std::int64_t particles = 0;  // that may be shifted
  std::int64_t too_near = 0;   // that stood less than half a spacing from the walls' skin
  double before = 0;           // root mean square of the unevenness, after the particles too near had stepped back
  double after = 0;            // the same after the last sweep
  double farthest = 0;         // [m] longest way of a particle
};

/// Fits fluid to curved and oblique walls. The lattice runs through walls and fluid alike, so that kernel sums are even
/// from the start, but the walls' true skin cuts it anywhere. Therefore:
/// 1. Particles nearer to the skin than half a spacing step back to half a spacing.
/// 2. Particles whose kernel reaches walls and no free surface are shifted down the gradient of the kernel sum
///    (particle shifting, Lind et al. 2012, J. Comput. Phys. 231, 1499-1523), never nearer to the skin than half a
///    spacing and by at most a spacing in all. Particles whose kernel reaches walls and the free surface are not
///    shifted.
/// 3. Pressures, densities and masses follow the new heights.
/// It ends after `sweeps` shifts or when one lowers the unevenness by less than a thousandth. Beside flat walls on the
/// lattice nothing moves. `gravity` [m/s^2] along the lattice's columns, signed; `sound_speed` [m/s].
Relaxation relax(ParticleSet& particles, const std::vector<PlacedShape>& shapes, const SkinSearch& skin,
                 const Filling& filling, int sweeps, double gravity, double sound_speed);

}  // namespace thalweg::gencase
