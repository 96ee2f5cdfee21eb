#pragma once

#include "physics/pair_terms.hpp"
#include "solver/models/bed/arrays.hpp"
#include "solver/models/seepage/porosity.hpp"

namespace thalweg {

namespace field {
/// The work quad before the viscous solve: of water the drag coefficient PoreState::exchange.
inline constexpr Field drag_coefficient{"DragCoefficient", quad_work};
}  // namespace field

/// The coupling of two particles' velocities in a mixture: within the grains and against walls their viscosity,
/// between grains and water the drag T_a T_b C W with the water's C, which lies in the work quad until the solve needs
/// it.
template <int Dim>
struct MixtureCoupling {
  using neighbours = Neighbours<field::place, field::flow, field::matter, field::drag_coefficient>;
  static constexpr unsigned kernel = kernel_value | kernel_gradient;
  static constexpr bool needs_stored = true;  // the iteration writes over the work quad
  Scene<Dim> scene;

  template <class LaneT, class L>
  HOST_DEVICE L coefficient(const LaneT& a, const LaneT& b, const Vec<Dim, L>&, const PairGeometry<Dim, L>& g) const {
    const auto a_grain = is_sediment(a);
    const auto b_grain = is_sediment(b);
    const auto b_wall = is_wall(b);
    const L eta = a.viscosity + lane_select(b_wall, a.viscosity, b.viscosity);
    const L viscous = viscous_coefficient(a.volume, b.volume, eta, g.F);
    const L of_water = lane_select(a_grain, b.work[0], a.work[0]);
    const L drag = a.volume * b.volume * of_water * g.W;
    const L of_grain = lane_select(is_water(b), drag, viscous);
    return lane_select(a_grain, of_grain, lane_select(b_grain, drag, L(0.0F)));
  }
};

/// Brings the drag coefficients to the records and takes the strength from loose grains: the water carries what lies
/// above them.
template <int Dim, class Device>
void prepare_mixture_viscosity(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  Record* records = p.record.data();
  Sediment* sediment = p.sediment.data();
  const PoreState* pores = p.pores.data();
  on.for_each(
      p.fluid_count,
      declare<Reads<field::matter, field::pores>, Writes<field::drag_coefficient, field::sediment, field::matter>>(
          [=] HOST_DEVICE(Index i) {
            Record& r = records[i];
            r.work[0] = pores[i].exchange;
            if (!is_sediment(r) || !mixture::is_loose(pores[i].porosity, scene)) return;
            sediment[i].yield_stress = 0;
            r.viscosity = scene.sediment.consistency;
          }));
}

}  // namespace thalweg
