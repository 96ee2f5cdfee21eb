#pragma once

#include <cmath>

#include "physics/sediment/mohr_coulomb.hpp"
#include "solver/models/bed/arrays.hpp"
#include "solver/passes/continuity.hpp"

namespace thalweg {

/// Pair sweep over clusters with sediment in reach: density rate and velocity gradient. The gradient
///   G = sum_b V_b (u_b - u_a) (x) grad W   is corrected by   B = sum_b V_b (x_b - x_a) (x) grad W,   grad u = G B^-1
/// (exact for a linear velocity field), from which gdot = sqrt(2 D:D), D the deviatoric symmetric part. The compression
/// is -tr G.
template <int Dim>
struct ContinuityAndStrainSweep {
  using neighbours = Neighbours<field::place, field::flow, field::matter>;
  using reads = Reads<field::place, field::flow, field::matter>;
  using writes = Writes<field::rates, field::sediment>;
  static constexpr unsigned kernel = kernel_gradient;
  static constexpr int symmetric = Dim * (Dim + 1) / 2;
  template <class L>
  struct Sum {
    L diffusion;
    L gradient[Dim][Dim];  // G[i][j] = d u_i / d x_j before correction
    L moment[symmetric];   // B, upper triangle row by row
  };

  ContinuitySweep<Dim> continuity;
  Sediment* sediment;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L weight = b.volume * g.F;
    sum.diffusion += pair_diffusion(a, b, g, weight, same_phase(a, b), continuity.scene);
    add_gradients(b.velocity - a.velocity, g, weight, sum);
  }

  /// u = u_b - u_a, weight = V_b F.
  template <class L>
  HOST_DEVICE static void add_gradients(const Vec<Dim, L>& u, const PairGeometry<Dim, L>& g, const L& weight,
                                        Sum<L>& sum) {
    int m = 0;
    for (int j = 0; j < Dim; ++j) {
      const L weighted = weight * g.r[j];  // grad W = F r
      for (int i = 0; i < Dim; ++i) sum.gradient[i][j] += weighted * u[i];
      for (int i = j; i < Dim; ++i) sum.moment[m++] += -weighted * g.r[i];  // x_b - x_a = -r
    }
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    float compression = 0;
    for (int k = 0; k < Dim; ++k) compression -= sum.gradient[k][k];
    continuity.end(i, compression, sum.diffusion);
    const StrainRate strain = strain_rate(sum);
    sediment[i].strain_rate = strain.magnitude;
    sediment[i].lode_sine = strain.lode_sine;
  }

  struct StrainRate {
    float magnitude;  // gdot [1/s]
    float lode_sine;  // of three Lode angles [-]
  };

  /// The plain sum is used if too little of the neighbourhood is there to correct it (an isolated grain).
  HOST_DEVICE static StrainRate strain_rate(const Sum<float>& sum) {
    float inverse[Dim][Dim];
    invert(sum.moment, inverse);
    float gradient[Dim][Dim];
    for (int i = 0; i < Dim; ++i) {
      for (int j = 0; j < Dim; ++j) {
        gradient[i][j] = 0;
        for (int k = 0; k < Dim; ++k) gradient[i][j] += sum.gradient[i][k] * inverse[k][j];
      }
    }
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

  /// Inverse of the symmetric moment; the identity where it is close to singular (determinant below 0.05, 1 inside).
  HOST_DEVICE static void invert(const float (&m)[symmetric], float (&inverse)[Dim][Dim]) {
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
};

/// Density rates of all fluid. Pure water takes the light sweep; clusters with sediment in reach take the one with the
/// velocity gradient, and so does the resting sediment that moving neighbours may wake.
template <int Dim, class Device>
void compute_density_rates(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  compute_water_density_rates(on, p, scene);
  if (!scene.has_sediment) return;
  const ContinuitySweep<Dim> water{p.record.data(), p.rates.data(), scene};
  const ContinuityAndStrainSweep<Dim> with_strain{water, p.sediment.data()};
  sweep(on, p, scene, p.near_sediment(), with_strain);
  if (p.any_resting) sweep(on, p, scene, p.rest_front(), with_strain);
}

}  // namespace thalweg
