#pragma once

#include "physics/lane_math.hpp"

// Terms of the pair sums. Each takes numbers or packs of numbers (L) and has no branch, so that a sweep can run several
// pairs at once. r = x_a - x_b [m], u = u_a - u_b [m/s], grad W = F r with F <= 0 [1/m^(Dim+2)]; the other symbols are
// those of docs/theory.md.
namespace thalweg {

/// Density diffusion of Fourtakas et al. 2019 (Comput. Fluids 190, 346-361) on density excesses d = rho/rho0 - 1 of one
/// phase, per unit of 2 delta h c V_b:
///   -[(d_b - d_a) - d_H] (r . grad W)/r^2 = -[(d_b - d_a) - d_H] F,   d_H = -(g . r)/c^2
/// d_H is the excess difference of a hydrostatic column, linearised: its error is below 1e-3 of itself at laboratory
/// depths. Without it a bed creeps for ever (2.7e-4 m/s against 1.9e-5 measured).
/// Excesses [-]; gravity_dot_r_over_c2 = g . r/c^2 [-].
template <class L>
HOST_DEVICE inline L density_diffusion(const L& d_a, const L& d_b, const L& gravity_dot_r_over_c2, const L& F) {
  return -((d_b - d_a) + gravity_dot_r_over_c2) * F;
}

/// Artificial viscosity of Monaghan 1992 between approaching particles, as the pressure it adds to P_a + P_b [Pa]:
///   -rho0 alpha c mu,   mu = h min(0, u.r)/(r^2 + eps)
/// u_dot_r = u . r [m^2/s], inverse_r2_eps = 1/(r^2 + eps) [1/m^2], strength = rho0 alpha c h [Pa s].
/// Zero for receding pairs.
template <class L>
HOST_DEVICE inline L artificial_viscous_pressure(const L& u_dot_r, const L& inverse_r2_eps, const L& strength) {
  return -(strength * lane_min(u_dot_r, L(0)) * inverse_r2_eps);
}

/// Viscous exchange coefficient of a pair, Morris et al. 1997 with a viscosity of each particle:
///   k_ab = V_a V_b (eta_a + eta_b) (-r . grad W)/r^2 = -V_a V_b (eta_a + eta_b) F >= 0  [kg/s],
/// The force on a is -k_ab (u_a - u_b). k is symmetric, so that momentum is conserved, and positive, so that energy is
/// dissipated. The customary r^2 + 0.01 h^2 in the denominator is not needed, because F is finite at r = 0; it would
/// cost 0.8 % of the viscosity at h = 2 dp (tests/solver/passes/taylor_green_test.cpp).
/// Volumes V [m^3]; eta_sum = eta_a + eta_b [Pa s].
template <class L>
HOST_DEVICE inline L viscous_coefficient(const L& V_a, const L& V_b, const L& eta_sum, const L& F) {
  return -V_a * V_b * eta_sum * F;
}

/// Viscosity [Pa s] of a pair of water and sediment, in place of (eta_a + eta_b)/2. It stands for the rough-wall shear
/// layer between the two:
///   mu_w + C rho_w (kappa/2)^2 |u_ab| dp,   kappa = 0.41, C = 0.4
/// The mixing length is of the order of the spacing dp [m], so that the shear stress at the interface is quadratic in
/// the velocity difference |u_ab| [m/s] across it. C = 0.4 is calibrated, not derived (docs/theory.md).
template <class L>
HOST_DEVICE inline L interface_viscosity(const L& water_viscosity, const L& water_density, const L& speed_difference,
                                         const L& spacing) {
  constexpr float mixing = 0.4F * 0.205F * 0.205F;  // C (kappa/2)^2
  return water_viscosity + L(mixing) * water_density * speed_difference * spacing;
}

}  // namespace thalweg
