#pragma once

#include <cmath>

#include "physics/host_device.hpp"

// Diffusion of the excess pore pressure p_e [Pa] through a bed (Terzaghi 1925):
//   dp_e/dt = c_v lap p_e,   p_e = 0 where the bed drains
namespace thalweg {

/// Coefficient of consolidation c_v = K E/(rho g) [m^2/s] from the hydraulic conductivity K [m/s], the oedometer
/// modulus E [Pa] and the unit weight of water rho g [N/m^3].
/// Derivation: the filter velocity -K grad(p_e)/(rho g) drains a volume of the bed, which shrinks by dp_e/E.
/// K = 1e-6 m/s, E = 1 MPa: 1.02e-4 m^2/s.
template <class Real>
HOST_DEVICE inline Real consolidation_coefficient(Real conductivity, Real modulus, Real unit_weight) {
  return conductivity * modulus / unit_weight;
}

/// Depth x of a particle below a drained plane surface over the smoothing length h [-], from the share m of its kernel
/// that lies above the surface [-]:
///   x/h = 1.24 - 1.74 sqrt(m),   m = 1 - sum V W over sediment and walls,   0.1 < m < 0.5
/// A fit to the half-space integral of Wendland's kernel, good to 0.04 h. Not below a tenth of h.
template <class Real>
HOST_DEVICE inline Real depth_below_surface(Real share_above) {
  using std::sqrt;
  const Real x = Real(1.24) - Real(1.74) * sqrt(share_above);
  return x > Real(0.1) ? x : Real(0.1);
}

/// Thresholds [-] above which a particle loses pressure through the surface: the share of its kernel above the surface,
/// and h |sum V grad W|. A particle at the depth 0.7 h reaches both, and a disordered one far below does not. The loss
/// of deeper particles is left out, so that the method is of first order in h.
inline constexpr float least_share_above = 0.1F;
inline constexpr float least_surface_gradient = 0.3F;

/// Number of stages s with which the Runge-Kutta-Legendre method RKL1 (Meyer, Balsara & Aslam 2014, J. Comput. Phys.
/// 257, 594-626) is stable over a step as long as `steps` explicit limits: the least s with steps <= (s^2 + s)/2.
inline int legendre_stages(double steps) {
  int s = 1;
  while (0.5 * s * (s + 1.0) < steps) ++s;
  return s;
}

}  // namespace thalweg
