#pragma once

#include <cmath>

#include "physics/transport/lift_settling.hpp"
#include "physics/transport/suspended_load.hpp"
#include "physics/water/von_karman.hpp"
#include "solver/models/states/bed_states.hpp"
#include "solver/models/suspended_load/arrays.hpp"
#include "solver/models/suspended_load/bed_change.hpp"
#include "solver/models/suspended_load/scene.hpp"

// Grains between the bed and the water over it.
namespace thalweg {

/// The place of water over a particle of the bed.
struct OverBed {
  float weight = 0;  // of the water among all that the particle exchanges grains with [-]; 0: none
  float height = 0;  // over the surface [m]
};

/// Water a over the particle b of the bed. Grains are exchanged with the layer next to the surface,
///   weight V_a W_ab max(0, 1 - z/(1.5 dp)),
/// because the eddies above are those of the whole depth, which a particle of the bed does not know.
///
/// normal: unit vector of the surface, out of the bed; depth: of the particle's middle below the surface [m].
template <int Dim>
HOST_DEVICE inline OverBed place_over_bed(const Record& a, const Record& b, const Vec<Dim, float>& normal, float depth,
                                          const Scene<Dim>& scene) {
  const Vec<Dim, float> r = scene.separation(a.place, b.place);
  const float r2 = dot(r, r);
  if (!(r2 < scene.support() * scene.support())) return {};
  const auto dp = static_cast<float>(scene.spacing);
  const float least = 0.25F * dp;  // the lowest water lies half a spacing high
  const float over = dot(r, normal) - depth;
  OverBed out;
  out.height = over > least ? over : least;
  const float near = 1 - out.height / (1.5F * dp);
  if (near > 0) out.weight = near * a.volume * scene.kernel.value(scene.kernel.closeness(sqrtf(r2)));
  return out;
}

/// Water a over the particle b of a bed of particles, whose surface lies half a spacing over it.
template <int Dim>
HOST_DEVICE inline OverBed over_bed(const Record& a, const Record& b, const BedSurface& surface,
                                    const Scene<Dim>& scene) {
  const float half = 0.5F * static_cast<float>(scene.spacing);
  return place_over_bed(a, b, bed_states::pick<Dim>(surface.normal), half, scene);
}

/// Volume of grains that leaves the bed per second and area [m/s] under a shear stress [Pa], where it begins to move at the
/// critical one [Pa].
template <int Dim>
HOST_DEVICE inline float pick_up_of(const Scene<Dim>& scene, float shear_stress, float critical_stress) {
  const ErosionScene<Dim>& grains = scene.erosion;
  const float theta = shear_stress / grains.grain_weight;
  const float critical = critical_stress / grains.grain_weight;
  switch (scene.suspended_load.pick_up) {
    case PickUp::van_rijn:
      return van_rijn_pick_up(theta, critical, grains.dimensionless_diameter, grains.diameter, grains.grain_density,
                              scene.water_density, grains.gravity);
    case PickUp::mastbergen:
      return lift_velocity(theta, critical, grains.dimensionless_diameter, grains.diameter, grains.grain_density,
                           scene.water_density, grains.gravity);
  }
  return 0;
}

/// Volume of grains that goes from a particle of the bed to water over it [m^dim/s]:
///   A J weight/sum of the weights,   J of flux_from_bed() at the height of the water over the surface.
HOST_DEVICE inline float grains_to_water(const SuspendedLoadConstants& law, const Suspended& bed,
                                         const Suspended& water, const OverBed& over) {
  if (!(over.weight > 0) || water.diffusivity < 0) return 0;  // of_opening
  const float C = water.concentration;
  // The eddies that a model of turbulence knows say how deep the water is; without one it counts as deep.
  const float of_wall = von_karman<float> * bed.friction * over.height;
  const float known = water.diffusivity;
  const float share = known > 0.5F * of_wall && known < of_wall ? known / of_wall : 1;
  const float J = flux_from_bed(bed.reference, C, law.settling_velocity * hindered_share(C), bed.friction, over.height,
                                law.reference_level, share);
  return bed.exposed * over.weight * J;
}

/// Particle pass: the concentration that a particle of the bed's surface holds ready at the reference level, the pick-up
/// over the settling velocity C_r = E/w, the friction velocity, and its area over the weight of the water next to it. A
/// particle that has no grains left holds none ready.
template <int Dim>
struct BedSourcePass {
  using neighbours = Neighbours<field::place, field::matter>;
  using reads = Reads<field::place, field::matter, field::bed, field::role>;
  using writes = Writes<field::suspended>;

  const Record* records;
  const Role* roles;  // nullptr without openings
  const BedSurface* bed;
  Suspended* suspended;
  ClusterList list;
  Scene<Dim> scene;

  HOST_DEVICE void operator()(Index i) const {
    const Record& r = records[i];
    Suspended& out = suspended[i];
    out.reference = out.friction = out.exposed = 0;
    if (!is_sediment(r) || r.volume == 0) return;
    if (roles != nullptr && roles[i] == Role::prescribed) return;  // an inlet's bed load
    const BedSurface& s = bed[i];
    const SuspendedLoadConstants& law = scene.suspended_load;
    const bool in_bed = r.kind != kind::suspended && s.settled_share > 1e-3F;
    const bool surface = s.water_share > 1e-6F && s.fill < scene.erosion.surface_fill + scene.erosion.fill_hysteresis;
    if (!in_bed || !surface) return;
    const float weight = weight_of_water(i);
    if (!(weight > 0)) return;
    const float wet = s.water_share < law.contact ? s.water_share / law.contact : 1;
    out.exposed = law.area * wet / weight;
    if (!(s.shear_stress > 0) || !(out.concentration > bed_change::least_left)) return;
    out.friction = sqrtf(s.shear_stress / scene.water_density);
    const float ready = pick_up_of(scene, s.shear_stress, s.critical_stress) / law.settling_velocity;
    out.reference = ready < law.packing ? ready : law.packing;
  }

 private:
  [[nodiscard]] HOST_DEVICE float weight_of_water(Index i) const {
    float sum = 0;
    const Index cluster = list.cluster_of(i);
    for (Index e = list.begin[cluster]; e < list.begin[cluster + 1]; ++e) {
      const Index j = list.entries[e];
      if (j == list.none || records[j].volume == 0 || !is_water(records[j])) continue;
      sum += over_bed(records[j], records[i], bed[i], scene).weight;
    }
    return sum;
  }
};

/// Particle pass over bed and water alike: the grains that they exchange (grains_to_water()). What the water gains the bed
/// loses, pair by pair.
template <int Dim>
struct BedExchangePass {
  using neighbours = Neighbours<field::place, field::matter, field::bed, field::suspended>;
  using reads = Reads<field::place, field::matter, field::bed, field::suspended, field::grains>;
  using writes = Writes<field::grains>;

  const Record* records;
  const BedSurface* bed;
  const Suspended* suspended;
  double* grains;
  ClusterList list;
  const StepState* state;
  Scene<Dim> scene;

  HOST_DEVICE void operator()(Index i) const {
    if (records[i].volume == 0) return;
    const bool water = is_water(records[i]);
    if (!water && !(suspended[i].exposed > 0)) return;
    double gain = 0;
    const Index cluster = list.cluster_of(i);
    for (Index e = list.begin[cluster]; e < list.begin[cluster + 1]; ++e) {
      const Index j = list.entries[e];
      if (j == list.none || records[j].volume == 0) continue;
      if (water && is_sediment(records[j]) && suspended[j].exposed > 0) gain += double(flux(j, i));
      if (!water && is_water(records[j])) gain -= double(flux(i, j));
    }
    if (gain != 0) grains[i] += state->step.dt * gain;
  }

 private:
  /// Volume of grains that goes from particle b of the bed to water a [m^dim/s].
  [[nodiscard]] HOST_DEVICE float flux(Index b, Index a) const {
    const OverBed over = over_bed(records[a], records[b], bed[b], scene);
    return grains_to_water(scene.suspended_load, suspended[b], suspended[a], over);
  }
};

/// Exchanges grains between bed and water for the time of the step.
template <int Dim, class Device>
void exchange_with_bed(Device& on, Particles<Device>& p, const Scene<Dim>& scene, const StepState* state) {
  using Source = BedSourcePass<Dim>;
  const Source source{p.record.data(), p.roles(), p.bed.data(), p.suspended.data(), p.list(), scene};
  on.for_each(p.fluid_count, declare<typename Source::neighbours, typename Source::reads, typename Source::writes>(
                                 [=] HOST_DEVICE(Index i) { source(i); }));
  using Pass = BedExchangePass<Dim>;
  const Pass pass{p.record.data(), p.bed.data(), p.suspended.data(), p.grains.data(), p.list(), state, scene};
  on.for_each(p.fluid_count, declare<typename Pass::neighbours, typename Pass::reads, typename Pass::writes>(
                                 [=] HOST_DEVICE(Index i) { pass(i); }));
}

}  // namespace thalweg
