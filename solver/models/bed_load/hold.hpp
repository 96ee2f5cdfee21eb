#pragma once

#include "solver/models/bed_load/drag.hpp"

// A bed is rough by its grains, not by its particles. But water pushes with its pressure on each particle that stands in
// front of it: at the steps of a sloping bed, where a neighbour is missing. Half a metre a second against 5 mm is 125 Pa,
// and the friction of such a particle is 13: whole particles ran over a stepped hump, 8 to 20 times as much as the law
// carries (bench/notes/stepped-hump.md). In nature that push is part of the shear stress, of which the law knows what it
// moves. So in a current (model.bed_surface) pressure moves nothing across gravity at a surface that stands; what it would
// give goes to the ground. Waves that break over a bed do push it as a whole: there nothing is held.
namespace thalweg {

/// Particle pass: takes from the surface of a bed the acceleration across gravity that pressures give it. All of it where
/// the bed is less steep than 0.9 of the angle of repose, nothing where it is steeper than grains stand.
template <int Dim>
struct HoldSurfacePass {
  using reads = Reads<field::matter, field::bed, field::sediment, field::rates>;
  using writes = Writes<field::rates>;

  const Record* records;
  const BedSurface* bed;
  const Sediment* sediment;
  Rates* rates;
  Vec<Dim, float> down;  // direction of gravity
  float repose;          // tangent of the slope at which grains stand

  HOST_DEVICE void operator()(Index i) const {
    const Record& r = records[i];
    if (!is_sediment(r) || r.volume == 0) return;
    const BedSurface& s = bed[i];
    if (!(s.water_share > 1e-6F) || is_in_suspension(r, s)) return;
    const float left = 10 * (1 - sediment[i].bed_slope / repose);
    const float held = left < 0 ? 0 : left > 1 ? 1 : left;
    float along = 0;
    for (int k = 0; k < Dim; ++k) along += rates[i].acceleration[axis<Dim>(k)] * down[k];
    for (int k = 0; k < Dim; ++k) {
      float& a = rates[i].acceleration[axis<Dim>(k)];
      a -= held * (a - along * down[k]);
    }
  }
};

template <int Dim, class Device>
void hold_surface(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  if (!(scene.sediment.friction_tangent > 0)) return;
  on.for_each(p.fluid_count, HoldSurfacePass<Dim>{p.record.data(), p.bed.data(), p.sediment.data(), p.rates.data(),
                                                  scene.erosion.down, scene.sediment.friction_tangent});
}

}  // namespace thalweg
