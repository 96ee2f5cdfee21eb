#pragma once

#include <cmath>

#include "physics/transport/bed_shear.hpp"
#include "physics/transport/critical_shields.hpp"
#include "physics/transport/friction_velocity.hpp"
#include "physics/transport/lift_settling.hpp"
#include "physics/transport/slope_factor.hpp"
#include "physics/transport/wall_stress.hpp"
#include "solver/models/bed/arrays.hpp"
#include "solver/models/states/bed_surface.hpp"
#include "solver/models/states/scene.hpp"
#include "solver/state/step_state.hpp"

// The three states of sediment and how it changes between them. Deposits (state 1) obey the yield criterion; grains at
// the surface that the water's shear stress can move are bed load (2), those it lifts off are suspended (3).
namespace thalweg {

namespace bed_states {

template <int Dim>
HOST_DEVICE Vec<Dim, float> pick(const float* xyz) {
  Vec<Dim, float> v{};
  for (int k = 0; k < Dim; ++k) v[k] = xyz[axis<Dim>(k)];
  return v;
}

}  // namespace bed_states

/// Velocity of the water along the bed's surface, less that of the particle [m/s].
template <int Dim>
HOST_DEVICE Vec<Dim, float> speed_along_bed(const Record& r, const BedSurface& s) {
  const Vec<Dim, float> n = bed_states::pick<Dim>(s.normal);
  const Vec<Dim, float> u = bed_states::pick<Dim>(s.water_velocity) - bed_states::pick<Dim>(r.velocity);
  return u - dot(u, n) * n;
}

namespace bed_states {

/// Particle pass: shear stress, its critical value, and the state they lead to. A particle at rest that the water would
/// move is due to wake.
template <int Dim>
struct StatePass {
  using reads = Reads<field::flow, field::matter, field::sediment, field::bed>;
  using writes = Writes<field::matter, field::sediment, field::bed>;

  Record* records;
  Sediment* sediment;
  BedSurface* bed;
  Scene<Dim> scene;
  const StepState* state;

  HOST_DEVICE void operator()(Index i) const {
    Record& r = records[i];
    if (!is_sediment(r)) return;
    BedSurface& s = bed[i];
    const ErosionScene<Dim>& law = scene.erosion;
    const float last_critical = s.critical_stress;
    s.shear_stress = s.critical_stress = 0;
    const bool moving = r.kind == kind::bed_load || r.kind == kind::suspended;
    const bool at_water = s.water_share > 0;
    // A grain that moves has to be buried deeper before it counts as part of the bed again.
    const float most_fill = law.surface_fill + (moving ? law.fill_hysteresis : 0);
    const bool surface = at_water && s.fill < most_fill;
    if (!surface && !moving) return;

    const Vec<Dim, float> u = pick<Dim>(r.velocity);
    const Vec<Dim, float> over_bed = u - pick<Dim>(s.bed_velocity);
    // The stress on the bed, not on a grain that goes with the water; the print takes the grain's velocity.
    // Where bed load drifts over its skeleton, u is the skeleton's already.
    Shields shields;
    const bool of_bed = moving && !law.as_printed && !law.by_law;
    if (surface) shields = shields_of(s, of_bed ? pick<Dim>(s.bed_velocity) : u);
    s.shear_stress = shields.stress;
    s.critical_stress = shields.critical_stress;
    // The print's bed load that is buried goes on to yield at the last stress that could move it.
    if (law.as_printed && !surface) s.critical_stress = last_critical;
    if (r.kind == kind::bed_load) {
      r.kind = from_bed_load(s, surface, over_bed, shields);
      return;
    }
    if (r.kind == kind::suspended) {
      if (settles(s, at_water, u, over_bed)) r.kind = kind::bed_load, s.time_below_threshold = 0;
      return;
    }
    if (!(shields.stress > shields.critical_stress)) return;
    sediment[i].time_below_yield = 0;  // one that rests wakes with the others that are due to (models/rest)
    if (is_resting(r)) return;
    r.kind = kind::bed_load;
    s.time_below_threshold = 0;
  }

  struct Shields {
    float stress = 0;           // tau_b [Pa]
    float critical_stress = 0;  // [Pa]
    float number = 0;           // [-]
    float critical_number = 0;  // [-] of a flat bed
  };

  /// u: velocity of the bed [m/s].
  HOST_DEVICE Shields shields_of(const BedSurface& s, const Vec<Dim, float>& u) const {
    const ErosionScene<Dim>& law = scene.erosion;
    const Vec<Dim, float> n = pick<Dim>(s.normal);
    const Vec<Dim, float> water = pick<Dim>(s.water_velocity);
    Shields out;
    float friction = 0;  // u* [m/s]
    const float nu = scene.water_viscosity / scene.water_density;
    if (law.bed_shear == BedShear::paper) {
      // As printed: the sum over the water without dividing by its share.
      const Vec<Dim, float> du = tangential(s.water_share * water - u, n);
      out.stress = bed_shear_stress_of_difference(scene.water_density, sqrtf(dot(du, du)));
      // The grain Reynolds number takes the friction velocity of the logarithmic law, (17) to (19).
      const Vec<Dim, float> mean = tangential(water - u, n);
      friction = friction_velocity(sqrtf(dot(mean, mean)), height_of_water(s), nu, law.roughness).friction_velocity;
    } else {
      const Vec<Dim, float> du = tangential(water - u, n);
      const auto dp = static_cast<float>(scene.spacing);
      const float z = height_of_water(s);
      const float speed = sqrtf(dot(du, du));
      const float mean = s.water_height > 0.1F * dp ? s.water_height : 0.1F * dp;
      friction = law.by_law ? wall_friction_velocity(speed, mean, s.log_height, nu, law.roughness)
                            : friction_velocity(speed, z, nu, law.roughness).friction_velocity;
      out.stress = bed_shear_stress(scene.water_density, friction);
    }
    out.number = shields_number(out.stress, law.grain_weight);
    out.critical_number =
        law.critical_shields > 0
            ? law.critical_shields
            : critical_shields_number(friction * law.diameter * scene.water_density / scene.water_viscosity);
    const float k = slope_factor(n, water - u, law.down, scene.sediment.friction_tangent, law.lift_ratio);
    out.critical_stress = k * critical_stress_of_flat_bed(out.critical_number, law.grain_weight);
    if (law.by_law) out.critical_stress += law.cohesion;
    return out;
  }

  /// Mean height of the water over the bed, between half a spacing and the support [m].
  [[nodiscard]] HOST_DEVICE float height_of_water(const BedSurface& s) const {
    const float least = 0.5F * static_cast<float>(scene.spacing);
    if (!(s.water_height > least)) return least;
    return s.water_height < scene.support() ? s.water_height : scene.support();
  }

  HOST_DEVICE static Vec<Dim, float> tangential(const Vec<Dim, float>& v, const Vec<Dim, float>& n) {
    return v - dot(v, n) * n;
  }

  HOST_DEVICE float from_bed_load(BedSurface& s, bool surface, const Vec<Dim, float>& over_bed,
                                  const Shields& shields) const {
    const ErosionScene<Dim>& law = scene.erosion;
    const float speed = sqrtf(dot(over_bed, over_bed));
    const float lift = lift_velocity(shields.number, shields.critical_number, law.dimensionless_diameter, law.diameter,
                                     law.grain_density, scene.water_density, law.gravity);
    const float rise = law.as_printed ? speed : dot(over_bed, pick<Dim>(s.normal));
    const bool dilute = s.water_share > 0 && s.concentration <= law.dilute;
    if (dilute && shields.number > shields.critical_number && rise > lift) return kind::suspended;
    if (law.as_printed) return kind::bed_load;  // the print has no way back

    if (!surface) return s.time_below_threshold = 0, kind::deposit;
    const bool calm = shields.stress < law.return_stress * shields.critical_stress && speed < law.return_speed;
    s.time_below_threshold = calm ? s.time_below_threshold + static_cast<float>(state->step.dt) : 0;
    return s.time_below_threshold > law.return_time ? (s.time_below_threshold = 0, kind::deposit) : kind::bed_load;
  }

  HOST_DEVICE bool settles(const BedSurface& s, bool at_water, const Vec<Dim, float>& u,
                           const Vec<Dim, float>& over_bed) const {
    const ErosionScene<Dim>& law = scene.erosion;
    if (!at_water) return true;
    const bool slow = dot(over_bed, over_bed) < law.settling_velocity * law.settling_velocity;
    if (law.as_printed) return s.concentration > law.dilute || slow;
    const bool sinks = dot(u - pick<Dim>(s.water_velocity), law.down) > 0;
    return s.concentration > law.dense || (slow && sinks && s.settled_share > 0);
  }
};

}  // namespace bed_states

/// Takes the surface from all particles, which those in the water's reach get back; due when the lists are new.
template <class Device>
void clear_bed_surface(Device& on, Particles<Device>& p) {
  BedSurface* bed = p.bed.data();
  on.for_each(p.fluid_count, declare<Reads<field::bed>, Writes<field::bed>>([=] HOST_DEVICE(Index i) {
                const float time = bed[i].time_below_threshold;
                bed[i] = {};
                bed[i].time_below_threshold = time;
              }));
}

/// Finds the bed's surface and lets sediment change its state.
template <int Dim, class Device>
void update_bed_states(Device& on, Particles<Device>& p, const Scene<Dim>& scene, StepState* state) {
  const ClusterList list = p.list();
  const ClusterRange at_water = p.at_bed_surface();
  BedSurface* bed = p.bed.data();
  sweep(on, p, scene, at_water, BedSurfaceSweep<Dim>{p.record.data(), bed, scene});
  if (scene.erosion.bed_shear == BedShear::nearest) {
    for_each_member(on, list, at_water, NearestWaterPass<Dim>{p.record.data(), bed, list, scene});
  }
  on.for_each(p.fluid_count, bed_states::StatePass<Dim>{p.record.data(), p.sediment.data(), bed, scene, state});
}

}  // namespace thalweg
