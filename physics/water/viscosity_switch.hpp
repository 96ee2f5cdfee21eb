#pragma once

#include "physics/lane_math.hpp"

namespace thalweg {

/// Share of the artificial viscosity that acts on a particle [-], 0 to 1: all of it where the flow is compressed or
/// disordered, next to none where it shears, turns or is strained without change of volume,
///   f = min(1, 2 |div u|/(|div u| + |G'| + 1e-4 c/h)),   |G'|^2 = G:G - (div u)^2/Dim
/// G' is the velocity gradient without its trace. Balsara 1995 (J. Comput. Phys. 121, 357-372) compares with the curl
/// alone, which leaves the whole viscosity on waves: they have none. The factor 2 makes f = 1 in a plane shock (0.59 of
/// |div u| in the plane without it) and 0.9 where velocities are random.
/// divergence2 = (div u)^2, rest2 = |G'|^2 [1/s^2]; least = 1e-4 c/h [1/s].
HOST_DEVICE inline float viscosity_switch(float divergence2, float rest2, float least) {
  const float divergence = sqrtf(divergence2);
  const float f = 2 * divergence / (divergence + sqrtf(rest2 > 0 ? rest2 : 0) + least);
  return f < 1 ? f : 1;
}

/// The share that acts on sediment [-], whatever its flow: a bed is held in order by it while it settles. With the switch
/// a still bed crept by 0.014 spacings in place of 0.006, a wet slope below repose by 0.065 in place of 0.043. A fifth of
/// the default of 0.1 is the value at which beds were measured.
inline constexpr float viscosity_share_of_sediment = 0.2F;

}  // namespace thalweg
