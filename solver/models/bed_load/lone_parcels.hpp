#pragma once

#include "solver/models/bed_load/drag.hpp"

// A parcel in suspension is a lump of bed, as large as a spacing. The grains it stands for are spread over far more water
// when no other parcel is near. Its whole weight on the water in reach makes that water fall with it, as it does around a
// cloud of that size: parcels of 0.2 mm grains fell at 1.79, 1.37 and 1.05 of their settling velocity at 10, 5 and 2.5 mm.
namespace thalweg {

/// Share of a parcel in suspension that is by itself [-]: 1 without other sediment in reach, 0 where that fills as much of the
/// kernel as the parcel. own_value: W(0) [1/m^dim].
HOST_DEVICE inline float lone_share(const Record& r, const BedSurface& s, float own_value) {
  const float share = 2 - s.fill / (r.volume * own_value);  // s.fill counts the parcel itself
  return share < 0 ? 0 : share < 1 ? share : 1;
}

/// Particle pass: takes from parcels in suspension the weight under water that is not theirs to lay on the water in reach.
/// They sink as before, by their drift (drift.hpp). It is taken from parcels that fall, all of it from half of w_s on: the work
/// that gravity does on grains that sink is lost around them, but water that carries them up does that work.
template <int Dim>
struct LoneParcelPass {
  using reads = Reads<field::flow, field::matter, field::bed, field::drift, field::rates>;
  using writes = Writes<field::rates>;

  const Record* records;
  const BedSurface* bed;
  const Drift* drift;
  Rates* rates;
  Vec<Dim, float> down;  // direction of gravity
  float weight;          // acceleration of a parcel by its weight under water [m/s^2]
  float slow;            // half of the settling velocity [m/s]
  float own_value;       // W(0) [1/m^dim]

  HOST_DEVICE void operator()(Index i) const {
    const Record& r = records[i];
    const BedSurface& s = bed[i];
    if (!is_sediment(r) || r.volume == 0 || !is_in_suspension(r, s)) return;
    float fall = 0;  // [m/s]
    for (int k = 0; k < Dim; ++k) fall += down[k] * (r.velocity[axis<Dim>(k)] + drift[i].velocity[axis<Dim>(k)]);
    if (!(fall > 0)) return;
    const float share = (fall < slow ? fall / slow : 1) * lone_share(r, s, own_value);
    for (int k = 0; k < Dim; ++k) rates[i].acceleration[axis<Dim>(k)] -= share * weight * down[k];
  }
};

template <int Dim, class Device>
void lighten_lone_parcels(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  const float under_water = scene.bed_load.submerged_weight / scene.sediment_density;
  on.for_each(p.fluid_count,
              LoneParcelPass<Dim>{p.record.data(), p.bed.data(), p.drift.data(), p.rates.data(), scene.erosion.down,
                                  under_water, 0.5F * scene.erosion.settling_velocity, scene.kernel.value(1.0F)});
}

}  // namespace thalweg
