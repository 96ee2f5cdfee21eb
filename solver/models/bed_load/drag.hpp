#pragma once

#include <cmath>

#include "solver/models/bed_load/arrays.hpp"
#include "solver/models/bed_load/scene.hpp"
#include "solver/models/states/bed_states.hpp"

namespace thalweg {

namespace settling {
/// Drag of a parcel in suspension over the one with which its weight would sink at w_s [-]. It ties the parcel to the water,
/// through which it drifts at w_s (drift.hpp): with a drag for w_s and no drift, the pressure of the water resists as it
/// does to a body of its size, and 1 mm grains sank at 0.76, 0.54 and 0.31 w_s at 10, 5 and 2.5 mm.
inline constexpr float tie = 20;
/// Velocity of the water that rises around a parcel by itself, over its settling velocity [-]. Measured: without it parcels of
/// 0.2 and 1 mm grains sank at 0.77 w_s in the plane at 10, 5 and 2.5 mm, and with 0.25 in space at 1.10 to 1.15.
template <int Dim>
inline constexpr float counterflow = Dim == 2 ? 0.25F : 0.1F;
/// Share of settled sediment in reach of a parcel that lies on a bed [-].
inline constexpr float landed = 0.3F;
}  // namespace settling

/// True for a parcel that the water carries: suspended, or with no settled sediment in reach.
HOST_DEVICE inline bool is_in_suspension(const Record& r, const BedSurface& s) {
  if (!is_sediment(r) || !(s.water_share > 1e-6F)) return false;
  return r.kind == kind::suspended || !(s.settled_share > 1e-3F);
}

/// Particle pass: the coefficient of the drag between water and each particle of sediment. A surface particle drags as
/// its shear stress says,
///   K = tau_b A min(1, S/S_0)/|U|
/// U the water's velocity along the bed less the skeleton's, A the area of a particle, S the share of water in reach, S_0
/// that of half a layer of water: a bed with less over it is partly dry. A parcel in suspension is tied to the water,
///   K = 20 V (rho_bed - rho_w) g/w_s
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
    const float K = is_in_suspension(r, s) ? of_settling(r) : of_surface(r, s);
    drift[i].drag = K / s.water_share;
  }

 private:
  [[nodiscard]] HOST_DEVICE float of_settling(const Record& r) const {
    return settling::tie * r.volume * scene.bed_load.submerged_weight / scene.erosion.settling_velocity;
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
