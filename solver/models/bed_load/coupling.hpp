#pragma once

#include "physics/pair_terms.hpp"
#include "solver/backend/device.hpp"
#include "solver/models/bed_load/arrays.hpp"
#include "solver/state/scene.hpp"

namespace thalweg {

/// The coupling of two particles' velocities where the bed load follows a law: within the sediment and against walls its
/// viscosity; between a surface particle a and the water w the drag K = tau_b A/|U|, spread over the water in reach,
///   k_aw = K V_w W_aw/S,   S = sum_w V_w W_aw
/// so that its sum over the water is tau_b A to rounding. K/S lies in the work quad until the solve needs it.
template <int Dim>
struct DragCoupling {
  using neighbours = Neighbours<field::place, field::flow, field::matter, field::drag_of_bed>;
  static constexpr unsigned kernel = kernel_value | kernel_gradient;
  static constexpr bool needs_stored = true;  // the iteration writes over the work quad
  Scene<Dim> scene;

  template <class LaneT, class L>
  HOST_DEVICE L coefficient(const LaneT& a, const LaneT& b, const Vec<Dim, L>&, const PairGeometry<Dim, L>& g) const {
    const auto a_sediment = is_sediment(a);
    const auto b_wall = is_wall(b);
    const L eta = a.viscosity + lane_select(b_wall, a.viscosity, b.viscosity);
    const L viscous = viscous_coefficient(a.volume, b.volume, eta, g.F);
    const L of_water = lane_select(a_sediment, b.volume, a.volume);
    const L drag = of_water * g.W * (a.work[0] + b.work[0]);  // one of them is the water's 0
    const L of_sediment = lane_select(is_water(b), drag, viscous);
    return lane_select(a_sediment, of_sediment, lane_select(is_sediment(b), drag, L(0.0F)));
  }
};

/// Brings the drag coefficients to the records.
template <class Device>
void prepare_drag(Device& on, Particles<Device>& p) {
  Record* records = p.record.data();
  const Drift* drift = p.drift.data();
  const Index fluid = p.fluid_count;
  on.for_each(p.count,
              declare<Reads<field::matter, field::drift>, Writes<field::drag_of_bed>>([=] HOST_DEVICE(Index i) {
                for (float& w : records[i].work) w = 0;
                if (i < fluid && is_sediment(records[i])) records[i].work[0] = drift[i].drag;
              }));
}

}  // namespace thalweg
