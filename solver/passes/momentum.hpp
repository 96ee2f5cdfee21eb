#pragma once

#include <type_traits>

#include "physics/pair_terms.hpp"
#include "solver/passes/sweep.hpp"

namespace thalweg {

namespace field {
/// The work quad during the sums of forces, where beds lend pressure (Scene::has_drift): of sediment, the pressure that the
/// water over it meets [Pa].
inline constexpr Field lent_pressure{"LentPressure", quad_work};
}  // namespace field

/// Pair sweep: acceleration by pressure, artificial viscosity, water's own viscosity and gravity,
///   rho_a du_a/dt = - sum_b V_b (P_a + P_b + Pi_ab) grad W + sum_b V_b 2 mu_w F u_ab + rho_a g
/// the paper's (7) with m_b/(rho_a rho_b) = V_b/rho_a and Pi_ab reduced by viscosity_switch.hpp; forces m_a du_a/dt are
/// antisymmetric pair by pair. The viscosity of sediment, and between water and sediment, is left to models/implicit/. Walls are frictionless for water here; what
/// it feels of them is added by models (stage::AddForces).
///
/// `lends`: between water and sediment the sediment has the pressure that the work quad lends it (models/bed_load).
template <int Dim, bool lends = false>
struct MomentumSweep {
  using Read = Fields<field::place, field::flow, field::matter>;
  using neighbours = std::conditional_t<lends, Read::With<field::lent_pressure>, Read>;
  using reads = neighbours;
  using writes = Writes<field::rates>;
  static constexpr unsigned kernel = kernel_gradient;
  template <class L>
  struct Sum {
    Vec<Dim, L> force;  // per volume of a [N/m^3]
  };

  const Record* records;
  Rates* rates;
  Scene<Dim> scene;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L inverse = lane_reciprocal(g.r2 + L(scene.singularity));
    const Vec<Dim, L> u = a.velocity - b.velocity;
    const L weight = b.volume * g.F;

    const auto same = same_phase(a, b);
    const L rho0 = lane_select(is_sediment(a), L(scene.sediment_density), L(scene.water_density));
    const L acting = L(0.5F * scene.artificial_viscosity) * (a.dissipation + b.dissipation);
    const L strength = lane_select(same, rho0 * acting, L(0.0F));
    const L along = -(weight * (pressures(a, b) + artificial_viscous_pressure(dot(u, g.r), inverse, strength)));

    // Twice the viscosity: doubling is exact, so that its place in the product does not matter. All of it but `same` is
    // known before the loop over b.
    const L eta2 = lane_select(same, lane_select(is_water(a), L(2.0F) * L(scene.water_viscosity), L(0.0F)), L(0.0F));
    const L drag = weight * eta2;
    for (int k = 0; k < Dim; ++k) sum.force[k] += along * g.r[k] + drag * u[k];
  }

  /// The sum of the two pressures [Pa].
  template <class LaneT>
  HOST_DEVICE static auto pressures(const LaneT& a, const LaneT& b) {
    if constexpr (lends) {
      const auto of_a = lane_select(is_water(b), lane_select(is_sediment(a), a.work[0], a.pressure), a.pressure);
      const auto of_b = lane_select(is_water(a), lane_select(is_sediment(b), b.work[0], b.pressure), b.pressure);
      return of_a + of_b;
    } else {
      return a.pressure + b.pressure;
    }
  }

  /// At rest the sum and gravity cancel: they do so in the precision of the sum.
  template <class Real>
  HOST_DEVICE void end(Index i, const Sum<Real>& sum) const {
    const Record& r = records[i];
    if (is_resting(r)) return;
    const float specific_volume = 1 / (scene.density_at_rest(r.kind) * (1 + r.excess));
    for (int k = 0; k < Dim; ++k) {
      rates[i].acceleration[axis<Dim>(k)] = static_cast<float>(scene.gravity[k] + sum.force[k] * specific_volume);
    }
  }
};

template <int Dim, class Device>
void compute_accelerations(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  const MomentumSweep<Dim> body{p.record.data(), p.rates.data(), scene};
  if (!p.any_resting && !scene.has_drift) return sweep(on, p, scene, p.all_fluid(), body);
  sweep(on, p, scene, p.pure_water(), body);
  if (scene.has_drift) {
    sweep(on, p, scene, p.near_sediment(), MomentumSweep<Dim, true>{p.record.data(), p.rates.data(), scene});
  } else {
    sweep(on, p, scene, p.near_sediment(), body);
  }
}

}  // namespace thalweg
