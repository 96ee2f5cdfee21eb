#pragma once

#include <cmath>

#include "physics/sediment/mohr_coulomb.hpp"
#include "physics/vec.hpp"
#include "solver/state/pair_geometry.hpp"

namespace thalweg {

/// Sums for the velocity gradient of a particle. The gradient
///   G = sum_b V_b (u_b - u_a) (x) grad W   is corrected by   B = sum_b V_b (x_b - x_a) (x) grad W,   grad u = G B^-1
/// which is exact for a linear velocity field, whatever part of the surroundings is summed. The compression is -tr G.
template <int Dim, class L>
struct GradientSum {
  static constexpr int symmetric = Dim * (Dim + 1) / 2;
  L gradient[Dim][Dim];  // G[i][j] = d u_i / d x_j before correction
  L moment[symmetric];   // B, upper triangle row by row

  /// u = u_b - u_a, weight = V_b F.
  HOST_DEVICE void add(const Vec<Dim, L>& u, const PairGeometry<Dim, L>& g, const L& weight) {
    int m = 0;
    for (int j = 0; j < Dim; ++j) {
      const L weighted = weight * g.r[j];  // grad W = F r
      for (int i = 0; i < Dim; ++i) gradient[i][j] += weighted * u[i];
      for (int i = j; i < Dim; ++i) moment[m++] += -weighted * g.r[i];  // x_b - x_a = -r
    }
  }
};

/// Inverse of the symmetric moment B; the identity where it is close to singular (determinant below 0.05, 1 inside),
/// because too little of the surroundings is there to correct with (an isolated grain).
template <int Dim>
HOST_DEVICE inline void invert_moment(const float (&m)[Dim * (Dim + 1) / 2], float (&inverse)[Dim][Dim]) {
  constexpr float least_determinant = 0.05F;
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) inverse[i][j] = i == j ? 1.0F : 0.0F;
  }
  if constexpr (Dim == 2) {
    const float det = m[0] * m[2] - m[1] * m[1];
    if (det < least_determinant) return;
    inverse[0][0] = m[2] / det;
    inverse[1][1] = m[0] / det;
    inverse[0][1] = inverse[1][0] = -m[1] / det;
  } else {
    const float xx = m[0], xy = m[1], xz = m[2], yy = m[3], yz = m[4], zz = m[5];
    const float cxx = yy * zz - yz * yz, cxy = xz * yz - xy * zz, cxz = xy * yz - xz * yy;
    const float det = xx * cxx + xy * cxy + xz * cxz;
    if (det < least_determinant) return;
    inverse[0][0] = cxx / det;
    inverse[0][1] = inverse[1][0] = cxy / det;
    inverse[0][2] = inverse[2][0] = cxz / det;
    inverse[1][1] = (xx * zz - xz * xz) / det;
    inverse[1][2] = inverse[2][1] = (xy * xz - xx * yz) / det;
    inverse[2][2] = (xx * yy - xy * xy) / det;
  }
}

/// The corrected velocity gradient, grad[i][j] = d u_i / d x_j [1/s].
template <int Dim>
HOST_DEVICE inline void corrected_gradient(const GradientSum<Dim, float>& sum, float (&grad)[Dim][Dim]) {
  float inverse[Dim][Dim];
  invert_moment<Dim>(sum.moment, inverse);
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) {
      grad[i][j] = 0;
      for (int k = 0; k < Dim; ++k) grad[i][j] += sum.gradient[i][k] * inverse[k][j];
    }
  }
}

/// The parts of a rate of strain that the rheology reads.
struct StrainRate {
  float magnitude;  // gdot [1/s]
  float lode_sine;  // of three Lode angles [-]
};

/// The rate of strain of a velocity gradient: gdot = sqrt(2 D:D), D its deviatoric symmetric part.
template <int Dim>
HOST_DEVICE inline StrainRate strain_rate(const float (&gradient)[Dim][Dim]) {
  float trace = 0;
  for (int i = 0; i < Dim; ++i) trace += gradient[i][i];
  float d[Dim][Dim];
  float squares = 0;  // D:D
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) {
      d[i][j] = 0.5F * (gradient[i][j] + gradient[j][i]) - (i == j ? trace / Dim : 0);
      squares += d[i][j] * d[i][j];
    }
  }
  StrainRate strain{sqrtf(2 * squares), 0};
  if constexpr (Dim == 3) {
    const float det = d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[1][2]) -
                      d[0][1] * (d[0][1] * d[2][2] - d[1][2] * d[0][2]) +
                      d[0][2] * (d[0][1] * d[1][2] - d[1][1] * d[0][2]);
    strain.lode_sine = sine_of_three_lode_angles(det, squares / 2);
  }
  return strain;
}

}  // namespace thalweg
