#pragma once

#include <cmath>

#include "solver/models/bed_load/arrays.hpp"
#include "solver/models/bed_load/scene.hpp"
#include "solver/models/states/bed_states.hpp"

namespace thalweg {

/// Particle pass: the coefficient of the drag between water and each particle of sediment. A surface particle drags as
/// its shear stress says,
///   K = tau_b A min(1, S/S_0)/|U|
/// U the water's velocity along the bed less the skeleton's, A the area of a particle, S the share of water in reach, S_0
/// that of half a layer of water: a bed with less over it is partly dry. A suspended or lone particle drags so that
/// its submerged weight sinks at the settling velocity of its grains,
///   K = V (rho_bed - rho_w) g/w_s
template <int Dim>
struct BedDragPass {
  using reads = Reads<field::place, field::flow, field::matter, field::bed>;
  using writes = Writes<field::drift>;

  const Record* records;
  const BedSurface* bed;
  Drift* drift;
  Scene<Dim> scene;

  HOST_DEVICE void operator()(Index i) const {
    const Record& r = records[i];
    drift[i].drag = 0;
    if (!is_sediment(r)) return;
    const BedSurface& s = bed[i];
    if (!(s.water_share > 1e-6F)) return;
    const bool lone = !(s.settled_share > 1e-3F);
    const float K = r.kind == kind::suspended || lone ? of_settling(r) : of_surface(r, s);
    drift[i].drag = K / s.water_share;
  }

 private:
  [[nodiscard]] HOST_DEVICE float of_settling(const Record& r) const {
    return 20 * r.volume * scene.bed_load.submerged_weight / scene.erosion.settling_velocity;
  }

  [[nodiscard]] HOST_DEVICE float of_surface(const Record& r, const BedSurface& s) const {
    if (!(s.shear_stress > 0)) return 0;
    const Vec<Dim, float> u = speed_along_bed<Dim>(r, s);
    const float speed = sqrtf(dot(u, u));
    if (!(speed > 1e-6F)) return 0;  // [m/s] a drag of no weight
    const float wet = s.water_share < scene.bed_load.contact ? s.water_share / scene.bed_load.contact : 1;
    return s.shear_stress * scene.bed_load.area * wet / speed;
  }
};

}  // namespace thalweg
