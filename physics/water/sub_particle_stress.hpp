#pragma once

#include <cmath>

#include "physics/host_device.hpp"

namespace thalweg {

// Stress by the eddies of water that are too small for the particles: Smagorinsky's closure (1963, Mon. Weather Rev. 91,
// 99-164) in the form of the sub-particle stress (Gotoh, Shibahara & Sakai 2001, Comput. Fluid Dyn. J. 9, 339-347;
// Dalrymple & Rogers 2006, Coastal Eng. 53, 141-147), the paper's (7):
//   tau_ij/rho = nu_t (2 S_ij - 2/3 S_kk d_ij) - 2/3 C_I D^2 |S|^2 d_ij
//   nu_t = (C_s D)^2 |S|,   |S| = sqrt(2 S:S),   S_ij = (d u_i/d x_j + d u_j/d x_i)/2
// D [m] is the spacing of the particles. The last term is the pressure of the small eddies. In the plane S has no
// components across it, and the stress across it is not needed. A constant nu_t has no wall damping: the law is meant
// for eddies in space, away from walls.
namespace sub_particle {
inline constexpr float smagorinsky = 0.12F;  // C_s [-]
inline constexpr float isotropic = 0.0066F;  // C_I [-] (Blin, Hadjadj & Vervisch 2003)
}  // namespace sub_particle

/// The stress over the density [m^2/s^2], a symmetric tensor, and the viscosity that makes it.
template <int Dim>
struct SubParticleStress {
  static constexpr int off_diagonals = Dim * (Dim - 1) / 2;
  float diagonal[Dim];                // xx, zz in the plane; xx, yy, zz in space
  float off_diagonal[off_diagonals];  // xz in the plane; xy, xz, yz in space
  float eddy_viscosity;               // nu_t [m^2/s]
};

/// The sub-particle stress of a velocity gradient [1/s], gradient[i][j] = d u_i/d x_j, with particles `spacing` apart
/// [m]. Simple shear of 10 1/s at 5 mm: |S| = 10 1/s, nu_t = 3.6e-6 m^2/s, off-diagonal 3.6e-5 m^2/s^2, diagonal
/// -1.1e-5 m^2/s^2.
template <int Dim>
HOST_DEVICE inline SubParticleStress<Dim> sub_particle_stress(const float (&gradient)[Dim][Dim], float spacing) {
  float trace = 0;
  float squares = 0;  // S:S
  for (int i = 0; i < Dim; ++i) {
    trace += gradient[i][i];
    for (int j = 0; j < Dim; ++j) {
      const float s = 0.5F * (gradient[i][j] + gradient[j][i]);
      squares += s * s;
    }
  }
  const float rate = sqrtf(2 * squares);  // |S|
  const float length = sub_particle::smagorinsky * spacing;
  const float nu = length * length * rate;
  const float eddy_pressure = 2.0F / 3 * sub_particle::isotropic * spacing * spacing * rate * rate;
  SubParticleStress<Dim> stress{};
  stress.eddy_viscosity = nu;
  int m = 0;
  for (int i = 0; i < Dim; ++i) {
    stress.diagonal[i] = nu * (2 * gradient[i][i] - 2.0F / 3 * trace) - eddy_pressure;
    for (int j = i + 1; j < Dim; ++j) stress.off_diagonal[m++] = nu * (gradient[i][j] + gradient[j][i]);
  }
  return stress;
}

/// The power that a stress takes out of a flow of this velocity gradient, tau_ij/rho d u_i/d x_j [m^2/s^3].
template <int Dim>
HOST_DEVICE inline float dissipation(const SubParticleStress<Dim>& stress, const float (&gradient)[Dim][Dim]) {
  float power = 0;
  int m = 0;
  for (int i = 0; i < Dim; ++i) {
    power += stress.diagonal[i] * gradient[i][i];
    for (int j = i + 1; j < Dim; ++j) power += stress.off_diagonal[m++] * (gradient[i][j] + gradient[j][i]);
  }
  return power;
}

}  // namespace thalweg
