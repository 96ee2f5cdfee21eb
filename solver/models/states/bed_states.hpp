#pragma once

#include <cmath>

#include "physics/transport/bed_shear.hpp"
#include "physics/transport/critical_shields.hpp"
#include "physics/transport/friction_velocity.hpp"
#include "physics/transport/lift_settling.hpp"
#include "physics/transport/slope_factor.hpp"
#include "solver/passes/time_step.hpp"

// The three states of sediment and how it changes between them. Deposits (state 1) are what the yield criterion makes
// of them; grains at the surface that the water's shear stress can move are bed load (2), those it lifts off are
// suspended (3). The surface is found from the sediment alone, its normal from the gradient of its concentration, the
// shear stress by the logarithmic law from the mean of the water in reach (docs/theory.md, "Three states").
namespace thalweg {

/// Pair sweep over the clusters that have sediment and water in reach: what each sediment particle's surroundings are.
template <int Dim>
struct BedSurfaceSweep {
  static constexpr unsigned quads = quad_place | quad_motion | quad_matter;
  template <class L>
  struct Sum {
    L fill;
    L sediment_volume;
    L fluid_volume;
    Vec<Dim, L> gradient;  // of the sediment's concentration
    L water_share;
    Vec<Dim, L> water_velocity;
    Vec<Dim, L> water_offset;
    L deposit_share;
    Vec<Dim, L> deposit_velocity;
    L settled_share;
  };

  const Record* records;
  BedSurface* bed;
  Scene<Dim> scene;

  template <class LaneT, class Sep, class L>
  HOST_DEVICE void pair(const LaneT&, const LaneT& b, const Sep& s, std::size_t, Sum<L>& sum) const {
    const L zero(0.0F);
    const L t = scene.kernel.closeness(lane_sqrt(s.r2));
    const L weight = b.volume * scene.kernel.value(t);
    const L slope = b.volume * scene.kernel.gradient(t);
    const L inside = lane_select(t > zero, b.volume, zero);

    const auto b_fluid = b.phase > L(phase_wall + 0.5F);
    const auto b_sediment = b.phase > L(phase_water + 0.5F);
    // A wall continues what lies before it: without it the grains along a wall would have a surface towards it.
    const L share = lane_select(b_fluid, lane_select(b_sediment, L(1.0F), zero), b.excess);
    sum.fill += share * weight;
    const L sediment_weight = lane_select(b_sediment, weight, zero);
    sum.sediment_volume += lane_select(b_sediment, inside, zero);
    sum.fluid_volume += lane_select(b_fluid, inside, zero);
    const L sediment_slope = share * slope;
    const L water_weight = lane_select(b_fluid, weight, zero) - sediment_weight;
    sum.water_share += water_weight;
    const auto b_suspended = b.state == L(state_suspended);
    const L settled = lane_select(b_suspended, zero, sediment_weight);
    const L deposit = lane_select(b.state == L(state_bed_load), zero, settled);
    sum.settled_share += settled;
    sum.deposit_share += deposit;
    for (int k = 0; k < Dim; ++k) {
      sum.gradient[k] += sediment_slope * s.r[k];
      sum.water_velocity[k] += water_weight * b.velocity[k];
      sum.water_offset[k] += water_weight * s.r[k];
      sum.deposit_velocity[k] += deposit * b.velocity[k];
    }
  }

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    const Record& r = records[i];
    if (r.phase != phase_sediment) return;
    BedSurface& s = bed[i];
    const float own = r.volume * scene.kernel.value(1.0F);
    s.fill = sum.fill;
    s.concentration = sum.sediment_volume / sum.fluid_volume;
    s.water_share = sum.water_share;
    s.settled_share = sum.settled_share - (r.state == state_suspended ? 0 : own);
    // What a particle is itself does not hold it.
    const bool deposit = r.state == state_deposit || r.state == state_resting;
    const float deposits = sum.deposit_share - (deposit ? own : 0);
    const bool has_deposits = deposits > 1e-3F;  // [-] of a full bed
    float length = 0;
    for (int k = 0; k < Dim; ++k) length += sum.gradient[k] * sum.gradient[k];
    length = sqrtf(length);
    // A grain by itself has no surface: its normal is upwards.
    const bool has_surface = length * static_cast<float>(scene.smoothing_length) > 0.01F;
    float height = 0;
    for (int k = 0; k < Dim; ++k) {
      const int c = axis<Dim>(k);
      s.normal[c] = has_surface ? -sum.gradient[k] / length : -scene.erosion.down[k];
      s.water_velocity[c] = sum.water_share > 0 ? sum.water_velocity[k] / sum.water_share : 0;
      if (sum.water_share > 0) height -= s.normal[c] * sum.water_offset[k] / sum.water_share;
      const float of_others = sum.deposit_velocity[k] - (deposit ? own * r.velocity[c] : 0);
      s.bed_velocity[c] = has_deposits ? of_others / deposits : 0;
    }
    s.water_height = height - 0.5F * static_cast<float>(scene.spacing);
  }
};

namespace bed_states {

/// Particle pass for bed_shear = nearest: the water particle closest to each grain in place of the mean.
template <int Dim>
struct NearestWaterPass {
  const Record* records;
  BedSurface* bed;
  ClusterList list;
  Scene<Dim> scene;

  HOST_DEVICE void operator()(Index i) const {
    if (records[i].phase != phase_sediment || !(bed[i].water_share > 0)) return;
    float nearest2 = scene.support() * scene.support();
    Index nearest = list.count;
    const Index cluster = i / cluster_size;
    for (Index e = list.begin[cluster]; e < list.begin[cluster + 1]; ++e) {
      const Index j = list.entries[e];
      if (records[j].phase != phase_water) continue;
      float r2 = 0;
      for (int k = 0; k < Dim; ++k) {
        const float d = scene.distance(k, records[j].place[axis<Dim>(k)], records[i].place[axis<Dim>(k)]);
        r2 += d * d;
      }
      if (r2 < nearest2) nearest2 = r2, nearest = j;
    }
    if (nearest == list.count) return;
    for (int c = 0; c < 3; ++c) bed[i].water_velocity[c] = records[nearest].velocity[c];
    bed[i].water_height = sqrtf(nearest2);
  }
};

template <int Dim>
HOST_DEVICE Vec<Dim, float> pick(const float* xyz) {
  Vec<Dim, float> v{};
  for (int k = 0; k < Dim; ++k) v[k] = xyz[axis<Dim>(k)];
  return v;
}

/// Particle pass: shear stress, its critical value, and the state they lead to. True where a resting particle was
/// moved.
template <int Dim>
struct StatePass {
  Record* records;
  Sediment* sediment;
  BedSurface* bed;
  Scene<Dim> scene;
  const StepState* state;

  HOST_DEVICE bool operator()(Index i) const {
    Record& r = records[i];
    if (r.phase != phase_sediment) return false;
    BedSurface& s = bed[i];
    const ErosionScene<Dim>& law = scene.erosion;
    s.shear_stress = s.critical_stress = 0;
    const bool moving = r.state == state_bed_load || r.state == state_suspended;
    const bool at_water = s.water_share > 0;
    // A grain that moves has to be buried deeper before it counts as part of the bed again.
    const float most_fill = law.surface_fill + (moving ? law.fill_hysteresis : 0);
    const bool surface = at_water && s.fill < most_fill;
    if (!surface && !moving) return false;

    const Vec<Dim, float> u = pick<Dim>(r.velocity);
    const Vec<Dim, float> over_bed = u - pick<Dim>(s.bed_velocity);
    // The stress on the bed, not on a grain that goes with the water; the print takes the grain's velocity.
    Shields shields;
    if (surface) shields = shields_of(s, moving && !law.as_printed ? pick<Dim>(s.bed_velocity) : u);
    s.shear_stress = shields.stress;
    s.critical_stress = shields.critical_stress;
    switch (static_cast<int>(r.state)) {
      case static_cast<int>(state_bed_load):
        r.state = from_bed_load(s, surface, over_bed, shields);
        break;
      case static_cast<int>(state_suspended):
        if (settles(s, at_water, u, over_bed)) r.state = state_bed_load, s.calm = 0;
        break;
      default:
        if (!(shields.stress > shields.critical_stress)) return false;
        const bool rested = is_resting(r);
        r.state = state_bed_load;
        s.calm = 0;
        sediment[i].calm = 0;
        return rested;
    }
    return false;
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
    if (law.bed_shear == BedShear::paper) {
      // As printed: the sum over the water without dividing by its share.
      const Vec<Dim, float> du = tangential(s.water_share * water - u, n);
      out.stress = bed_shear_stress_of_difference(scene.water_density, sqrtf(dot(du, du)));
      friction = sqrtf(out.stress / scene.water_density);
    } else {
      const Vec<Dim, float> du = tangential(water - u, n);
      const auto dp = static_cast<float>(scene.spacing);
      const float least = 0.5F * dp;
      const float z =
          s.water_height > least ? (s.water_height < scene.support() ? s.water_height : scene.support()) : least;
      const float nu = scene.water_viscosity / scene.water_density;
      friction = friction_velocity(sqrtf(dot(du, du)), z, nu, law.roughness).friction_velocity;
      out.stress = bed_shear_stress(scene.water_density, friction);
    }
    out.number = shields_number(out.stress, law.grain_weight);
    out.critical_number =
        law.critical_shields > 0
            ? law.critical_shields
            : critical_shields_number(friction * law.diameter * scene.water_density / scene.water_viscosity);
    const float k = slope_factor(n, water - u, law.down, scene.sediment.friction_tangent, law.lift_ratio);
    out.critical_stress = k * critical_stress_of_flat_bed(out.critical_number, law.grain_weight);
    return out;
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
    if (dilute && shields.number > shields.critical_number && rise > lift) return state_suspended;
    if (law.as_printed) return state_bed_load;  // the print has no way back

    if (!surface) return s.calm = 0, state_deposit;
    const bool calm = shields.stress < law.return_stress * shields.critical_stress && speed < law.return_speed;
    s.calm = calm ? s.calm + static_cast<float>(state->step.dt) : 0;
    return s.calm > law.return_time ? (s.calm = 0, state_deposit) : state_bed_load;
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

/// Sees to it that particles out of the water's reach have no surface; after the neighbour lists have been made anew.
template <class Device>
void clear_bed_surface(Device& on, Particles<Device>& p) {
  BedSurface* bed = p.bed.data();
  on.for_each(p.fluid_count, [=] HOST_DEVICE(Index i) {
    const float calm = bed[i].calm;
    bed[i] = {};
    bed[i].calm = calm;
  });
}

/// Finds the bed's surface and lets sediment change its state; counts what it wakes.
template <int Dim, class Device>
void update_bed_states(Device& on, Particles<Device>& p, const Scene<Dim>& scene, StepState* state) {
  const ClusterList list = p.list();
  const ClusterRange at_water = p.at_bed_surface();
  BedSurface* bed = p.bed.data();
  on.template sweep<Dim>(list, at_water, p.record.data(), scene.lattice.quantum,
                         BedSurfaceSweep<Dim>{p.record.data(), bed, scene});
  if (scene.erosion.bed_shear == BedShear::nearest) {
    const bed_states::NearestWaterPass<Dim> nearest{p.record.data(), bed, list, scene};
    on.for_each(at_water.count, [=] HOST_DEVICE(Index n) {
      const Index c = at_water[n];
      for (Index i = list.first(c); i < list.last(c); ++i) nearest(i);
    });
  }
  const bed_states::StatePass<Dim> pass{p.record.data(), p.sediment.data(), bed, scene, state};
  on.reduce_then(
      p.fluid_count, Index{0}, [=] HOST_DEVICE(Index i) { return pass(i) ? Index{1} : Index{0}; },
      [] HOST_DEVICE(Index a, Index b) { return a + b; }, [=] HOST_DEVICE(Index woken) { state->woken += woken; });
}

}  // namespace thalweg
