#pragma once

#include "physics/lane_math.hpp"

namespace thalweg {

/// Share of the artificial viscosity that acts on a particle [-], 0 to 1: all of it where the flow is compressed or
/// disordered, next to none where it shears, turns or is strained without change of volume,
///   f = min(1, 2 |div u|/(|div u| + |G'| + 1e-4 c/h)),   |G'|^2 = G:G - (div u)^2/Dim
/// G' is the velocity gradient without its trace. Balsara 1995 (J. Comput. Phys. 121, 357-372) compares with the curl
/// alone, which leaves the whole viscosity on waves: they have none. The factor 2 makes f = 1 in a plane shock (0.59 of
/// |div u| in the plane without it) and 0.9 where velocities are random.
/// Limit: for kernels of h >= 1.9 dp. With 1.5 dp the lattice needs all of the viscosity to stay in order: at alpha = 0.02
/// a still bed crept by 0.014 spacings in 4 s with the switch, by 0.006 without, and an impact rang twice as loud (0.18
/// against 0.10 rho g H).
/// divergence2 = (div u)^2, rest2 = |G'|^2 [1/s^2]; least = 1e-4 c/h [1/s].
HOST_DEVICE inline float viscosity_switch(float divergence2, float rest2, float least) {
  const float divergence = sqrtf(divergence2);
  const float f = 2 * divergence / (divergence + sqrtf(rest2 > 0 ? rest2 : 0) + least);
  return f < 1 ? f : 1;
}

/// The least smoothing ratio h/dp [-] with which a scene has the switch.
inline constexpr double least_ratio_of_viscosity_switch = 1.9;

}  // namespace thalweg
