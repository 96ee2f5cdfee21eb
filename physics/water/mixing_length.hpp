#pragma once

#include <cmath>

#include "physics/host_device.hpp"
#include "physics/water/von_karman.hpp"

namespace thalweg {

// Eddy viscosity of a current over walls and beds, from Prandtl's mixing length (1925, Z. angew. Math. Mech. 5, 136-139):
//   nu_t = l^2 |S|,   |S| = sqrt(2 D:D),   l = kappa d sqrt(max(0, 1 - d/H)),   kappa = 0.41
// d [m] is the distance to the nearest wall or bed, H [m] the depth of the water. In steady uniform flow the shear stress
// is rho u*^2 (1 - z/H). With this l the flow that carries it has du/dz = u*/(kappa z): a logarithmic profile up to the
// surface, and nu_t = kappa u* z (1 - z/H), the parabola of the open channel.
// Limits: the length is that of shear layers along walls. It knows no memory, no wakes and no jets.

/// Mixing length l [m] at the distance d [m] from the nearest wall or bed, in water of the depth H [m]; 0 beyond H.
/// d = 25 mm, H = 100 mm: 8.877 mm.
template <class Real>
HOST_DEVICE inline Real mixing_length(Real distance, Real depth) {
  using std::sqrt;
  if (!(distance > 0 && distance < depth)) return 0;
  return von_karman<Real> * distance * sqrt(1 - distance / depth);
}

/// Kinematic eddy viscosity nu_t [m^2/s] of a mixing length l [m] and a rate of strain |S| [1/s].
template <class Real>
HOST_DEVICE inline Real eddy_viscosity(Real length, Real rate) {
  return length * length * rate;
}

}  // namespace thalweg
