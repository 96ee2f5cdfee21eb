#pragma once

#include "physics/pair_terms.hpp"
#include "solver/state/particles.hpp"

namespace thalweg {

/// Pair sweep: acceleration by pressure, artificial viscosity, water's own viscosity and gravity,
///   rho_a du_a/dt = - sum_b V_b (P_a + P_b + Pi_ab) grad W + sum_b V_b 2 mu_w F u_ab + rho_a g
/// the paper's (7) with m_b/(rho_a rho_b) = V_b/rho_a; forces m_a du_a/dt are antisymmetric pair by pair. The viscosity
/// of sediment, and between water and sediment, is left to models/implicit/viscosity.hpp. With wall_friction, water
/// beside a wall has the viscosity of smooth_wall_viscosity in place of mu_w; without it walls are frictionless for
/// water.
template <int Dim, bool wall_friction>
struct MomentumSweep {
  static constexpr unsigned quads = quad_place | quad_motion | quad_matter;
  template <class L>
  struct Sum {
    Vec<Dim, L> force;  // per volume of a [N/m^3]
  };

  const Record* records;
  Rates* rates;
  Scene<Dim> scene;

  template <class LaneT, class Sep, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const Sep& s, std::size_t, Sum<L>& sum) const {
    const L inverse = lane_reciprocal(s.r2 + L(scene.singularity));
    const L F = scene.kernel.gradient(scene.kernel.closeness(lane_sqrt(s.r2)));
    const Vec<Dim, L> u = a.velocity - b.velocity;
    const L weight = b.volume * F;

    const auto same_phase = a.phase == b.phase;
    const L rho0 = lane_select(a.phase > L(phase_water + 0.5F), L(scene.sediment_density), L(scene.water_density));
    const L strength = lane_select(same_phase, rho0 * L(scene.artificial_viscosity), L(0.0F));
    const L along = -(weight * (a.pressure + b.pressure + artificial_viscous_pressure(dot(u, s.r), inverse, strength)));

    const auto a_water = a.phase < L(phase_water + 0.5F);
    L eta = lane_select(same_phase & a_water, L(scene.water_viscosity), L(0.0F));
    if constexpr (wall_friction) {
      const auto b_wall = b.phase < L(phase_wall + 0.5F);
      const L at_wall =
          smooth_wall_viscosity(L(scene.water_viscosity), L(scene.water_density), lane_sqrt(dot(u, u)),
                                L(static_cast<float>(0.5 * scene.spacing)), L(scene.quarter_root_viscosity));
      eta = lane_select(a_water & b_wall, at_wall, eta);
    }
    const L drag = weight * L(2.0F) * eta;
    for (int k = 0; k < Dim; ++k) sum.force[k] += along * s.r[k] + drag * u[k];
  }

  /// At rest the sum and gravity cancel: they do so in the precision of the sum.
  template <class Real>
  HOST_DEVICE void end(Index i, const Sum<Real>& sum) const {
    const Record& r = records[i];
    if (is_resting(r)) return;
    const float specific_volume = 1 / (scene.density_at_rest(r.phase) * (1 + r.excess));
    for (int k = 0; k < Dim; ++k) {
      rates[i].acceleration[axis<Dim>(k)] = static_cast<float>(scene.gravity[k] + sum.force[k] * specific_volume);
    }
  }
};

template <int Dim, class Device>
void compute_accelerations(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  const auto sweep_over = [&](ClusterRange range, const auto& body) {
    on.template sweep<Dim>(p.list(), range, p.record.data(), scene.lattice.quantum, body);
  };
  const auto sweep = [&](const auto& body) {
    if (!p.any_resting) return sweep_over(p.all_fluid(), body);
    sweep_over(p.pure_water(), body);
    sweep_over(p.near_sediment(), body);
  };
  if (scene.wall_friction) {
    sweep(MomentumSweep<Dim, true>{p.record.data(), p.rates.data(), scene});
  } else {
    sweep(MomentumSweep<Dim, false>{p.record.data(), p.rates.data(), scene});
  }
}

}  // namespace thalweg
