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
// Away from walls that length is too large: a jet 15 mm thick over a floor would be mixed eight times too much. Eddies turn
// over with the velocity l |S|, and in free shear layers beside still water that is a quarter of the speed |u|, whichever
// layer it is. From measured rates of growth, where u is half of the largest: 0.23 in a mixing layer (Goertler's sigma 11:
// nu_t = 0.0128 U delta, |S| = U/delta), 0.28 in a plane jet (nu_t = 0.032 U b, |S| = 0.62 U/b), 0.25 in a plane wall jet
// (nu_t = 0.022 U b, |S| = 0.69 U/b). So l |S| is at most |u|/4. A current over a wall has |u| > 4 u* = 4 l |S| but for the
// lowest sixth of its roughness, and keeps its length.
// Limits: it knows no memory; |u| is that over walls at rest.

/// Mixing length l [m] at the distance d [m] from the nearest wall or bed, in water of the depth H [m]; 0 beyond H.
/// d = 25 mm, H = 100 mm: 8.877 mm.
template <class Real>
HOST_DEVICE inline Real mixing_length(Real distance, Real depth) {
  using std::sqrt;
  if (!(distance > 0 && distance < depth)) return 0;
  return von_karman<Real> * distance * sqrt(1 - distance / depth);
}

/// Kinematic eddy viscosity nu_t [m^2/s] of a mixing length l [m] and a rate of strain |S| [1/s] in water of the speed
/// |u| [m/s].
template <class Real>
HOST_DEVICE inline Real eddy_viscosity(Real length, Real rate, Real speed) {
  const Real turning = length * rate;
  const Real most = Real(0.25) * speed;
  return turning <= most ? length * turning : most * most / rate;
}

}  // namespace thalweg
