#pragma once

#include <cmath>

#include "physics/pair_terms.hpp"
#include "physics/sediment/mohr_coulomb.hpp"
#include "solver/state/particles.hpp"

namespace thalweg {

/// Pair sweep: rate of the density excess, the paper's (6) in the volume form that is right across a jump of density,
///   d(excess_a)/dt = (1 + excess_a) sum_b V_b u_ab.grad W + 2 delta h c sum_{b of a's phase} V_b psi_ab
/// with psi the density diffusion of pair_terms.hpp.
template <int Dim>
struct ContinuitySweep {
  static constexpr unsigned quads = quad_place | quad_motion | quad_matter;
  template <class L>
  struct Sum {
    L compression;
    L diffusion;
  };

  const Record* records;
  Rates* rates;
  Scene<Dim> scene;

  template <class LaneT, class Sep, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const Sep& s, std::size_t, Sum<L>& sum) const {
    const L weight = b.volume * scene.kernel.gradient(scene.kernel.closeness(lane_sqrt(s.r2)));
    sum.compression += weight * dot(a.velocity - b.velocity, s.r);
    sum.diffusion += diffusion(a, b, s, weight);
  }

  /// V_b psi_ab of particles of one phase; weight = V_b F.
  template <class LaneT, class Sep, class L>
  HOST_DEVICE L diffusion(const LaneT& a, const LaneT& b, const Sep& s, const L& weight) const {
    L g_dot_r = s.r[0] * L(scene.gravity[0]);
    for (int k = 1; k < Dim; ++k) g_dot_r = g_dot_r + s.r[k] * L(scene.gravity[k]);
    const L per_c2(1 / (scene.sound_speed * scene.sound_speed));
    return lane_select(a.phase == b.phase, density_diffusion(a.excess, b.excess, g_dot_r * per_c2, weight), L(0.0F));
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const { end(i, sum.compression, sum.diffusion); }

  HOST_DEVICE void end(Index i, float compression, float diffusion) const {
    if (is_resting(records[i])) return;
    rates[i].excess_rate = (1 + records[i].excess) * compression + scene.diffusion * diffusion;
  }
};

/// The same sweep where sediment is about: takes the velocity gradient along. The gradient
///   G = sum_b V_b (u_b - u_a) (x) grad W   is corrected by   B = sum_b V_b (x_b - x_a) (x) grad W,   grad u = G B^-1
/// (exact for a linear velocity field), from which gdot = sqrt(2 D:D), D the deviatoric symmetric part. The compression
/// is -tr G.
template <int Dim>
struct ContinuityAndStrainSweep {
  static constexpr unsigned quads = ContinuitySweep<Dim>::quads;
  static constexpr int symmetric = Dim * (Dim + 1) / 2;
  template <class L>
  struct Sum {
    L diffusion;
    L gradient[Dim][Dim];  // G[i][j] = d u_i / d x_j before correction
    L moment[symmetric];   // B, upper triangle row by row
  };

  ContinuitySweep<Dim> continuity;
  Sediment* sediment;

  template <class LaneT, class Sep, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const Sep& s, std::size_t, Sum<L>& sum) const {
    const Scene<Dim>& scene = continuity.scene;
    const L weight = b.volume * scene.kernel.gradient(scene.kernel.closeness(lane_sqrt(s.r2)));
    sum.diffusion += continuity.diffusion(a, b, s, weight);
    add_gradients(b.velocity - a.velocity, s, weight, sum);
  }

  /// u = u_b - u_a, weight = V_b F.
  template <class Sep, class L>
  HOST_DEVICE static void add_gradients(const Vec<Dim, L>& u, const Sep& s, const L& weight, Sum<L>& sum) {
    int m = 0;
    for (int j = 0; j < Dim; ++j) {
      const L weighted = weight * s.r[j];  // grad W = F r
      for (int i = 0; i < Dim; ++i) sum.gradient[i][j] += weighted * u[i];
      for (int i = j; i < Dim; ++i) sum.moment[m++] += -weighted * s.r[i];  // x_b - x_a = -r
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

  /// Where too little of the neighbourhood is there to correct (an isolated grain), the plain sum is used.
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

/// Pure water takes the light sweep, clusters with sediment in reach the one with the velocity gradient; so does the
/// resting sediment that moving neighbours may wake.
template <int Dim, class Device>
void compute_density_rates(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  const ContinuitySweep<Dim> water{p.record.data(), p.rates.data(), scene};
  on.template sweep<Dim>(p.list(), p.pure_water(), p.record.data(), scene.lattice.quantum, water);
  if (!scene.has_sediment) return;
  for (const ClusterRange range : {p.near_sediment(), p.any_resting ? p.shore() : ClusterRange{nullptr, 0}}) {
    on.template sweep<Dim>(p.list(), range, p.record.data(), scene.lattice.quantum,
                           ContinuityAndStrainSweep<Dim>{water, p.sediment.data()});
  }
}

}  // namespace thalweg
