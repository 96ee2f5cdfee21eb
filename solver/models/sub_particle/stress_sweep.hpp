#pragma once

#include <type_traits>

#include "physics/water/sub_particle_stress.hpp"
#include "solver/models/sub_particle/arrays.hpp"
#include "solver/passes/sweep.hpp"
#include "solver/passes/velocity_gradient.hpp"

namespace thalweg {

/// Pair sweep: sub-particle stress of the water, from its velocity gradient over water neighbours alone. Sediment and
/// walls do not enter the gradient: their velocities say nothing of the shear within the water beside them.
///
/// The forces of the stress (StressForceSweep) take the power sum_a V_a tau_a : G_a out of the flow, G_a being the
/// gradient before its correction. Inside the water the two gradients agree within a percent; where half of the
/// neighbours are missing the power may come out negative, and then the particle has no stress. So the stress takes
/// energy out, particle by particle, and never adds any.
template <int Dim>
struct SubParticleStressSweep {
  using neighbours = Neighbours<field::place, field::flow, field::matter>;
  using reads = Reads<field::place, field::flow, field::matter>;
  using writes = Writes<field::stress_diagonal, field::sub_particle>;
  static constexpr unsigned kernel = kernel_gradient;
  template <class L>
  struct Sum {
    GradientSum<Dim, L> velocity;
  };

  Record* records;
  SubParticle* sub_particle;
  float water_density;  // [kg/m^3] at rest
  float spacing;        // [m]

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    sum.velocity.add(b.velocity - a.velocity, g, lane_select(is_water(b), b.volume * g.F, L(0.0F)));
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    Record& r = records[i];
    SubParticle& out = sub_particle[i];
    out = {};
    for (float& w : r.work) w = 0;
    if (!is_water(r) || r.volume == 0) return;
    float gradient[Dim][Dim];
    corrected_gradient(sum.velocity, gradient);
    const SubParticleStress<Dim> stress = sub_particle_stress<Dim>(gradient, spacing);
    if (!(dissipation(stress, sum.velocity.gradient) > 0)) return;
    const float density = water_density * (1 + r.excess);
    for (int k = 0; k < Dim; ++k) r.work[axis<Dim>(k)] = density * stress.diagonal[k];
    for (int m = 0; m < stress.off_diagonals; ++m) out.off_diagonal[m] = density * stress.off_diagonal[m];
    out.eddy_viscosity = stress.eddy_viscosity;
  }
};

/// Particle pass: the other components into the work quad.
template <int Dim>
struct OffDiagonalPass {
  using reads = Reads<field::sub_particle>;
  using writes = Writes<field::stress_off_diagonal>;

  Record* records;
  const SubParticle* sub_particle;

  HOST_DEVICE void operator()(Index i) const {
    for (int m = 0; m < Dim * (Dim - 1) / 2; ++m) records[i].work[axis<Dim>(m)] = sub_particle[i].off_diagonal[m];
  }
};

/// Pair sweep: adds the accelerations by a part of the stress,
///   rho_a du_a/dt += sum_{b water} V_b (tau_a + tau_b) . grad W
/// the paper's (7) with m_b/(rho_a rho_b) = V_b/rho_a, as the pressure is summed (momentum.hpp); forces are
/// antisymmetric pair by pair.
template <int Dim, const Field& part>
struct StressForceSweep {
  using neighbours = Neighbours<field::place, field::matter, part>;
  using reads = Reads<field::place, field::matter, part, field::rates>;
  using writes = Writes<field::rates>;
  static constexpr unsigned kernel = kernel_gradient;
  template <class L>
  struct Sum {
    Vec<Dim, L> force;  // per volume of a [N/m^3]
  };

  const Record* records;
  Rates* rates;
  float water_density;  // [kg/m^3] at rest

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L weight = lane_select(is_water(b), b.volume * g.F, L(0.0F));
    // Types, not addresses: GCC compares no addresses at compile time under its sanitizer of undefined behaviour.
    if constexpr (std::is_same_v<Fields<part>, Fields<field::stress_diagonal>>) {
      for (int k = 0; k < Dim; ++k) sum.force[k] += weight * (a.work[k] + b.work[k]) * g.r[k];
    } else {
      int m = 0;
      for (int i = 0; i < Dim; ++i) {
        for (int j = i + 1; j < Dim; ++j) {
          const L along = weight * (a.work[m] + b.work[m]);
          sum.force[i] += along * g.r[j];
          sum.force[j] += along * g.r[i];
          ++m;
        }
      }
    }
  }

  template <class Real>
  HOST_DEVICE void end(Index i, const Sum<Real>& sum) const {
    const Record& r = records[i];
    if (!is_water(r)) return;
    const float specific_volume = 1 / (water_density * (1 + r.excess));
    for (int k = 0; k < Dim; ++k) {
      rates[i].acceleration[axis<Dim>(k)] += static_cast<float>(sum.force[k] * specific_volume);
    }
  }
};

/// Adds the accelerations by the sub-particle stress. Walls and sediment take none: what passes between them and the
/// water is the business of model.wall_friction and of the viscosity between water and sediment (models/implicit/).
template <int Dim, class Device>
void add_sub_particle_stress(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  Record* records = p.record.data();
  SubParticle* sub_particle = p.sub_particle.data();
  const auto over_water = [&](const auto& body) {
    if (!p.any_resting) return sweep(on, p, scene, p.all_fluid(), body);
    sweep(on, p, scene, p.pure_water(), body);
    sweep(on, p, scene, p.near_sediment(), body);
  };
  const auto spacing = static_cast<float>(scene.spacing);
  over_water(SubParticleStressSweep<Dim>{records, sub_particle, scene.water_density, spacing});
  over_water(StressForceSweep<Dim, field::stress_diagonal>{records, p.rates.data(), scene.water_density});
  on.for_each(p.fluid_count, OffDiagonalPass<Dim>{records, sub_particle});
  over_water(StressForceSweep<Dim, field::stress_off_diagonal>{records, p.rates.data(), scene.water_density});
}

}  // namespace thalweg
