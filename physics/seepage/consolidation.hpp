#pragma once

#include <cmath>

#include "physics/host_device.hpp"

// Diffusion of excess pore pressure p_e through a bed (Terzaghi 1925): dp_e/dt = c_v lap p_e, p_e = 0 where the bed
// drains.
namespace thalweg {

/// Coefficient of consolidation c_v = K E / (rho g) [m^2/s] from hydraulic conductivity K [m/s], oedometer modulus E
/// [Pa] and the unit weight of water rho g [N/m^3]. K = 1e-6 m/s, E = 1 MPa: 1.02e-4 m^2/s.
template <class Real>
HOST_DEVICE inline Real consolidation_coefficient(Real conductivity, Real modulus, Real unit_weight) {
  return conductivity * modulus / unit_weight;
}

/// Depth of a particle below a drained plane surface over h [-], from the share m of its kernel that lies above,
///   m = 1 - sum V W over sediment and walls,  0.1 < m < 0.5:   x/h = 1.24 - 1.74 sqrt(m),
/// a fit to the half-space integral of Wendland's kernel, good to 0.04 h. Not below a tenth of h.
template <class Real>
HOST_DEVICE inline Real depth_below_surface(Real share_above) {
  using std::sqrt;
  const Real x = Real(1.24) - Real(1.74) * sqrt(share_above);
  return x > Real(0.1) ? x : Real(0.1);
}

/// A particle loses pressure through the surface if this share of its kernel lies above it and h |sum V grad W| is
/// above that: at x = 0.7 h both integrals are, and particles in disorder far below do not reach both. What deeper ones
/// would lose is left out, which makes the method one of first order in h.
inline constexpr float least_share_above = 0.1F;
inline constexpr float least_surface_gradient = 0.3F;

/// Stages of the Runge-Kutta-Legendre method RKL1 (Meyer, Balsara & Aslam 2014, J. Comput. Phys. 257, 594-626) that
/// make a step of `steps` explicit limits stable: steps <= (s^2 + s)/2.
inline int legendre_stages(double steps) {
  int s = 1;
  while (0.5 * s * (s + 1.0) < steps) ++s;
  return s;
}

}  // namespace thalweg
