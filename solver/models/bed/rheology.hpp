#pragma once

#include "physics/sediment/dilatancy.hpp"
#include "physics/sediment/suspension_viscosity.hpp"
#include "solver/backend/members.hpp"
#include "solver/models/bed/arrays.hpp"
#include "solver/models/bed/sediment_law.hpp"
#include "solver/models/pore_pressure/arrays.hpp"
#include "solver/models/pore_pressure/scene.hpp"
#include "solver/models/states/arrays.hpp"
#include "solver/state/scene.hpp"

namespace thalweg {

/// Particle pass: yield stress and apparent viscosity of a deposit; with states, suspended sediment is thickened
/// water, and bed load that does not drift over a skeleton yields at the stress that moves its grains.
struct RheologyPass {
  using reads = Reads<field::matter, field::sediment, field::bed, field::pore_pressure, field::solids>;
  using writes = Writes<field::matter, field::sediment>;

  Record* records;
  Sediment* sediment;
  const BedSurface* bed;  // nullptr: all sediment is deposit
  SedimentScene law;
  const float* excess_pore_pressure;  // [Pa], nullptr where the scene has none
  const float* solids;                // [-], nullptr where the packing keeps its porosity
  PoreScene pores;
  float solids_share;
  float einstein_coefficient;
  float water_viscosity;
  bool bed_load_drifts;

  HOST_DEVICE void operator()(Index i) const {
    Record& r = records[i];
    if (!is_sediment(r)) return;
    Sediment& s = sediment[i];
    if (r.kind == kind::suspended) {
      s.yield_stress = 0;
      r.viscosity = suspension_viscosity(water_viscosity, solids_share * bed[i].concentration, einstein_coefficient);
      return;
    }
    if (excess_pore_pressure != nullptr) {
      const float carried = s.effective_pressure - excess_pore_pressure[i];
      s.effective_pressure = carried > 0 ? carried : 0;
    }
    s.yield_stress = r.kind == kind::bed_load && !bed_load_drifts ? bed[i].critical_stress : yield_stress_of(law, s);
    if (solids != nullptr) s.yield_stress += strength_of_dilatancy(s, solids[i]);
    const float apparent = apparent_viscosity_of(law, s);
    r.viscosity = apparent > water_viscosity ? apparent : water_viscosity;
  }

 private:
  /// p_eff tan psi, the stress that opens a dense packing; a loose one yields earlier, at nothing less than no stress.
  [[nodiscard]] HOST_DEVICE float strength_of_dilatancy(const Sediment& s, float share) const {
    const float steady =
        steady_solids(pores.critical_solids, pores.water_viscosity, s.strain_rate, s.effective_pressure);
    const float stress = s.effective_pressure * dilatancy(pores.dilatancy, share, steady);
    return stress > -s.yield_stress ? stress : -s.yield_stress;
  }
};

template <int Dim, class Device>
void apply_rheology(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  const RheologyPass pass{p.record.data(),
                          p.sediment.data(),
                          scene.has_states ? p.bed.data() : nullptr,
                          scene.sediment,
                          scene.pores.on ? p.excess_pore_pressure.data() : nullptr,
                          scene.pores.critical_solids > 0 ? p.solids.data() : nullptr,
                          scene.pores,
                          scene.erosion.solids_share,
                          scene.erosion.einstein_coefficient,
                          scene.water_viscosity,
                          scene.bed_load.on};
  for_each_member(on, p.list(), p.near_sediment(), pass);
  if (p.any_resting) for_each_member(on, p.list(), p.rest_front(), pass);
}

}  // namespace thalweg
