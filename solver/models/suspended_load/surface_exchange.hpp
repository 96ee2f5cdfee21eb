#pragma once

#include <cmath>

#include "physics/transport/critical_shields.hpp"
#include "physics/transport/slope_factor.hpp"
#include "solver/models/surface_bed/arrays.hpp"
#include "solver/models/suspended_load/exchange.hpp"
#include "solver/models/wall_stress/arrays.hpp"

// Grains between the water and a bed that is a surface (models/surface_bed): walls, whose surface the columns' elements are.
namespace thalweg {

/// Water a over the element of the wall particle b.
template <int Dim>
HOST_DEVICE inline OverBed over_element(const Record& a, const Record& b, const WallElement& element,
                                        const Scene<Dim>& scene) {
  Vec<Dim, float> normal;
  for (int k = 0; k < Dim; ++k) normal[k] = element.normal[axis<Dim>(k)];
  return place_over_bed(a, b, normal, element.depth, scene);
}

/// Particle pass over the walls: what the surface of each column holds ready, as BedSourcePass does for a bed of
/// particles, under the shear stress of the step. Ground without grains takes what settles and gives nothing.
template <int Dim>
struct SurfaceSourcePass {
  using neighbours = Neighbours<field::place, field::matter>;
  using reads = Reads<field::place, field::matter, field::bed_place, field::wall_element, field::wall_shear>;
  using writes = Writes<field::suspended>;

  const Record* records;
  const BedPlace* places;
  const WallElement* elements;
  const WallShear* shear;
  Suspended* suspended;
  ClusterList list;
  Scene<Dim> scene;
  Index first;  // wall particle

  HOST_DEVICE void operator()(Index n) const {
    const Index i = first + n;
    Suspended& out = suspended[i];
    out = Suspended{};
    const BedPlace& place = places[i];
    const WallElement& element = elements[i];
    if (place.column < -0.5F || !(element.area > 0) || records[i].volume == 0) return;
    if (!place.is_bed() && place.is_floor < 0.5F) return;
    const SuspendedLoadConstants& law = scene.suspended_load;
    float in_layer = 0;
    float in_reach = 0;
    const Index cluster = list.cluster_of(i);
    for (Index e = list.begin[cluster]; e < list.begin[cluster + 1]; ++e) {
      const Index j = list.entries[e];
      if (j == list.none || records[j].volume == 0 || !is_water(records[j])) continue;
      in_layer += over_element(records[j], records[i], element, scene).weight;
      const Vec<Dim, float> r = scene.separation(records[j].place, records[i].place);
      in_reach += records[j].volume * scene.kernel.value(scene.kernel.closeness(sqrtf(dot(r, r))));
    }
    if (!(in_layer > 0)) return;
    out.exposed = element.area * (in_reach < law.contact ? in_reach / law.contact : 1) / in_layer;
    const Vec<3, float> stress{{shear[i].of[0], shear[i].of[1], shear[i].of[2]}};
    const float size = sqrtf(dot(stress, stress));
    if (!(size > 0)) return;
    out.friction = sqrtf(size / scene.water_density);
    if (!place.is_bed()) return;
    const float on_grains = scene.surface_bed.grain_stress * size;
    const float critical = critical_stress(element, stress, sqrtf(on_grains / scene.water_density));
    const float ready = pick_up_of(scene, on_grains, critical) / law.settling_velocity;
    out.reference = ready < law.packing ? ready : law.packing;
  }

 private:
  /// Shear stress at which the grains on the element begin to move [Pa].
  [[nodiscard]] HOST_DEVICE float critical_stress(const WallElement& element, const Vec<3, float>& flow,
                                                  float friction_velocity) const {
    const ErosionScene<Dim>& grains = scene.erosion;
    const Vec<3, float> normal{{element.normal[0], element.normal[1], element.normal[2]}};
    const Vec<3, float> down{{0, 0, -1}};
    const float slope = slope_factor(normal, flow, down, scene.surface_bed.tan_friction, grains.lift_ratio);
    const float flat = grains.critical_shields > 0
                           ? grains.critical_shields
                           : critical_shields_number(friction_velocity * grains.diameter * scene.water_density /
                                                     scene.water_viscosity);
    return grains.grain_weight * flat * (slope > 0.05F ? slope : 0.05F);  // as physics/bed/grains.hpp: van Rijn divides
  }
};

/// Particle pass over walls and water alike: the grains that they exchange (grains_to_water()). What the water gains its
/// column loses; one particle of a column has a surface.
template <int Dim>
struct SurfaceExchangePass {
  using neighbours = Neighbours<field::place, field::matter, field::wall_element, field::suspended>;
  using reads =
      Reads<field::place, field::matter, field::bed_place, field::wall_element, field::suspended, field::grains>;
  using writes = Writes<field::grains>;

  const Record* records;
  const BedPlace* places;
  const WallElement* elements;
  const Suspended* suspended;
  double* grains;
  double* lifted;  // [m^dim] of each column, so far
  ClusterList list;
  const StepState* state;
  Scene<Dim> scene;

  HOST_DEVICE void operator()(Index i) const {
    if (records[i].volume == 0) return;
    const bool water = is_water(records[i]);
    if (!water && !(suspended[i].exposed > 0)) return;
    double flux = 0;
    const Index cluster = list.cluster_of(i);
    for (Index e = list.begin[cluster]; e < list.begin[cluster + 1]; ++e) {
      const Index j = list.entries[e];
      if (j == list.none || records[j].volume == 0 || is_water(records[j]) == water) continue;
      const Index bed = water ? j : i;
      if (!(suspended[bed].exposed > 0)) continue;
      const Index wet = water ? i : j;
      const OverBed over = over_element(records[wet], records[bed], elements[bed], scene);
      flux += double(grains_to_water(scene.suspended_load, suspended[bed], suspended[wet], over));
    }
    if (flux == 0) return;
    const double moved = state->step.dt * flux;
    if (water) {
      grains[i] += moved;
    } else {
      lifted[static_cast<Index>(places[i].column)] += moved;
    }
  }
};

/// Exchanges grains between water and a bed that is a surface for the time of the step. `lifted` [m^dim] of each column.
template <int Dim, class Device>
void exchange_with_surface(Device& on, Particles<Device>& p, const Scene<Dim>& scene, const StepState* state,
                           typename Device::template Buffer<double>& lifted) {
  using Source = SurfaceSourcePass<Dim>;
  const Source source{
      p.record.data(), p.bed_place.data(), p.wall_element.data(), p.wall_shear.data(), p.suspended.data(), p.list(),
      scene,           p.fluid_count};
  on.for_each(p.count - p.fluid_count,
              declare<typename Source::neighbours, typename Source::reads, typename Source::writes>(
                  [=] HOST_DEVICE(Index i) { source(i); }));
  using Pass = SurfaceExchangePass<Dim>;
  const Pass pass{p.record.data(),
                  p.bed_place.data(),
                  p.wall_element.data(),
                  p.suspended.data(),
                  p.grains.data(),
                  lifted.data(),
                  p.list(),
                  state,
                  scene};
  on.for_each(p.count, declare<typename Pass::neighbours, typename Pass::reads, typename Pass::writes>(
                           [=] HOST_DEVICE(Index i) { pass(i); }));
}

}  // namespace thalweg
