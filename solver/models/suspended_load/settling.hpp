#pragma once

#include "physics/sediment/suspension_viscosity.hpp"
#include "physics/transport/suspended_load.hpp"
#include "solver/models/mixing_length/arrays.hpp"
#include "solver/models/sub_particle/arrays.hpp"
#include "solver/models/suspended_load/arrays.hpp"
#include "solver/models/suspended_load/scene.hpp"
#include "solver/passes/sweep.hpp"
#include "solver/state/step_state.hpp"

// Grains in the water: what they do to it, and how they sink and spread from particle to particle.
namespace thalweg {

/// Particle pass: concentration and inertia that follow from the grains.
template <int Dim>
struct ConcentrationPass {
  using reads = Reads<field::place, field::matter, field::mass, field::grains>;
  using writes = Writes<field::suspended, field::loaded_mass>;

  const Record* records;
  const float* mass;
  const double* grains;
  Suspended* suspended;
  float* loaded_mass;
  Scene<Dim> scene;

  HOST_DEVICE void operator()(Index i) const {
    const SuspendedLoadConstants& law = scene.suspended_load;
    loaded_mass[i] = mass[i];
    if (records[i].volume == 0) return;
    if (is_water(records[i])) {
      const double at_rest = double(mass[i]) / double(scene.water_density);
      const auto C = static_cast<float>(grains[i] / at_rest);
      suspended[i].concentration = C;
      loaded_mass[i] = mass[i] * (1 + law.excess_density * C);
    } else {
      const double packed = double(law.packing) * double(mass[i]) / double(scene.sediment_density);
      suspended[i].concentration = static_cast<float>(1 + grains[i] / packed);
    }
  }
};

/// Pair sweep: Vand's viscosity of the water with its grains, less that of clear water, as it acts between water,
///   rho_a du_a/dt += sum_{b water} V_b (mu_a + mu_b - 2 mu_w) F u_ab
/// and the inertia of the grains: all forces but gravity accelerate water and grains together, a = g + (a_w - g)/(1 + s C),
/// a_w what they would do to water alone.
template <int Dim>
struct MixtureForceSweep {
  using neighbours = Neighbours<field::place, field::flow, field::matter, field::added_viscosity>;
  using reads = Reads<field::place, field::flow, field::matter, field::added_viscosity, field::suspended, field::rates>;
  using writes = Writes<field::rates>;
  static constexpr unsigned kernel = kernel_gradient;
  template <class L>
  struct Sum {
    Vec<Dim, L> force;  // per volume of a [N/m^3]
  };

  const Record* records;
  const Suspended* suspended;
  Rates* rates;
  Scene<Dim> scene;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L added = lane_select(is_water(b), b.volume * g.F * (a.work[0] + b.work[0]), L(0.0F));
    for (int k = 0; k < Dim; ++k) sum.force[k] += added * (a.velocity[k] - b.velocity[k]);
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    const Record& r = records[i];
    const float C = suspended[i].concentration;
    if (!is_water(r) || r.volume == 0) return;
    const float per_mass = 1 / (scene.water_density * (1 + r.excess));
    const float share = 1 / (1 + scene.suspended_load.excess_density * C);
    for (int k = 0; k < Dim; ++k) {
      float& a = rates[i].acceleration[axis<Dim>(k)];
      a = scene.gravity[k] + (a + sum.force[k] * per_mass - scene.gravity[k]) * share;
    }
  }
};

/// Pair sweep over the water: grains that sink and that eddies mix, as volumes that pairs exchange,
///   dG_a/dt = sum_{b water} 2 V_a V_b (-F) J_ab,   J_ab of flux_of_grains(), D_ab of mean_diffusivity()
/// Each pair for itself is at rest in the profile that settling and mixing balance in, so that the profile does not
/// depend on how particles lie, nor on what is missing of a support at the surface. What one gains the other loses. Grains
/// sink slower among others, and not into water that is as full of them as a bed.
template <int Dim>
struct SettlingSweep {
  using neighbours = Neighbours<field::place, field::matter, field::load_of_water>;
  using reads = Reads<field::place, field::matter, field::load_of_water, field::grains>;
  using writes = Writes<field::grains>;
  static constexpr unsigned kernel = kernel_gradient;
  template <class L>
  struct Sum {
    L gain;  // of grains [m^dim/s]
  };

  const Record* records;
  double* grains;
  const StepState* state;
  Scene<Dim> scene;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT& a, const LaneT& b, const PairGeometry<Dim, L>& g, std::size_t, Sum<L>& sum) const {
    const L zero(0.0F);
    const SuspendedLoadConstants& law = scene.suspended_load;
    L above = L(scene.erosion.down[0]) * g.r[0];  // height of b over a [m]
    for (int k = 1; k < Dim; ++k) above = above + L(scene.erosion.down[k]) * g.r[k];
    const L C_below = lane_select(above > zero, a.work[0], b.work[0]);
    const L room = lane_min(L(1.0F), lane_max(zero, L(5.0F) - C_below * L(5.0F / law.packing)));
    const L speed = L(law.settling_velocity) * hindered_share(L(0.5F) * (a.work[0] + b.work[0])) * room;
    const L D = mean_diffusivity(lane_max(a.work[1], zero), lane_max(b.work[1], zero));
    const L J = flux_of_grains(a.work[0], b.work[0], speed * above, D);
    const L exchange = L(-2.0F) * (a.volume * b.volume) * g.F;
    const L moves = lane_select(lane_min(a.work[1], b.work[1]) < zero, zero, exchange * J);
    sum.gain += lane_select(is_water(b), moves, zero);
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    if (!is_water(records[i]) || records[i].volume == 0) return;
    grains[i] += state->step.dt * double(sum.gain);
  }
};

/// Particle pass: diffusivity of the grains, that of the eddies that a turbulence model finds and the scene's own.
///
/// The lowest water has neighbours on one side only, so that it sees the shear of the current's profile a spacing dp over
/// the wall, u*/(kappa dp), instead of u*/(kappa z) at its own height z. The grains need the latter: without it the lowest
/// row's mixing is half of what it should be.
template <int Dim>
struct DiffusivityPass {
  using reads = Reads<field::matter, field::sub_particle, field::eddies, field::role>;
  using writes = Writes<field::suspended>;

  const Record* records;
  const Role* roles;                // nullptr without openings
  const SubParticle* sub_particle;  // nullptr without this model of turbulence
  const Eddies* eddies;             // nullptr without that one
  Suspended* suspended;
  Scene<Dim> scene;

  HOST_DEVICE void operator()(Index i) const {
    const SuspendedLoadConstants& law = scene.suspended_load;
    suspended[i].diffusivity = 0;
    if (!is_water(records[i])) return;
    if (roles != nullptr && roles[i] == Role::prescribed) {
      suspended[i].diffusivity = of_opening;
      return;
    }
    float of_eddies = 0;
    if (sub_particle != nullptr) of_eddies = sub_particle[i].eddy_viscosity;
    if (eddies != nullptr) {
      const auto dp = static_cast<float>(scene.spacing);
      const float z = eddies[i].wall_distance;
      of_eddies = eddies[i].viscosity * (z > 0.25F * dp && z < dp ? dp / z : 1);
    }
    suspended[i].diffusivity = law.diffusivity + of_eddies / law.schmidt;
  }
};

/// Finds concentrations and inertia.
template <int Dim, class Device>
void find_concentrations(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  on.for_each(p.fluid_count, ConcentrationPass<Dim>{p.record.data(), p.mass.data(), p.grains.data(), p.suspended.data(),
                                                    p.loaded_mass.data(), scene});
}

/// Adds to the accelerations what the grains change.
template <int Dim, class Device>
void add_mixture_forces(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  Record* records = p.record.data();
  const Suspended* suspended = p.suspended.data();
  const float water = scene.water_viscosity;
  const Index fluid = p.fluid_count;
  on.for_each(p.count,
              declare<Reads<field::matter, field::suspended>, Writes<field::added_viscosity>>([=] HOST_DEVICE(Index i) {
                for (float& w : records[i].work) w = 0;
                if (i >= fluid || !is_water(records[i])) return;
                records[i].work[0] = suspension_viscosity(water, suspended[i].concentration) - water;
              }));
  sweep(on, p, scene, p.all_fluid(), MixtureForceSweep<Dim>{records, suspended, p.rates.data(), scene});
}

/// Lets the grains sink and spread for the time of the step.
template <int Dim, class Device>
void settle(Device& on, Particles<Device>& p, const Scene<Dim>& scene, const StepState* state) {
  Record* records = p.record.data();
  const Suspended* suspended = p.suspended.data();
  const Index fluid = p.fluid_count;
  on.for_each(p.count,
              declare<Reads<field::matter, field::suspended>, Writes<field::load_of_water>>([=] HOST_DEVICE(Index i) {
                for (float& w : records[i].work) w = 0;
                if (i >= fluid || !is_water(records[i])) return;
                records[i].work[axis<Dim>(0)] = suspended[i].concentration;
                records[i].work[axis<Dim>(1)] = suspended[i].diffusivity;
              }));
  sweep(on, p, scene, p.all_fluid(), SettlingSweep<Dim>{records, p.grains.data(), state, scene});
}

}  // namespace thalweg
