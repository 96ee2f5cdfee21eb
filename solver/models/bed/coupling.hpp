#pragma once

#include "physics/pair_terms.hpp"
#include "solver/backend/device.hpp"
#include "solver/state/scene.hpp"

namespace thalweg {

/// The coupling of two particles' velocities in a single-layer bed: the sediment's viscosity, and the layer between
/// water and sediment.
template <int Dim>
struct ViscousCoupling {
  using neighbours = Neighbours<field::place, field::flow, field::matter>;
  static constexpr unsigned kernel = kernel_gradient;
  static constexpr bool needs_stored = false;
  Scene<Dim> scene;

  /// k_ab [kg/s]; u = u_a - u_b. What a wall adds by being behind its surface is not in it (WallDrag).
  template <class LaneT, class L>
  HOST_DEVICE L coefficient(const LaneT& a, const LaneT& b, const Vec<Dim, L>& u, const PairGeometry<Dim, L>& g) const {
    const auto a_sediment = is_sediment(a);
    const auto b_sediment = is_sediment(b);
    const auto b_wall = is_wall(b);
    const L interface = L(2.0F) * interface_viscosity(L(scene.water_viscosity), L(scene.water_density),
                                                      lane_sqrt(dot(u, u)), L(static_cast<float>(scene.spacing)));
    const L among_sediment = lane_select(b_sediment, a.viscosity + b.viscosity, interface);
    const L of_sediment = lane_select(b_wall, a.viscosity + a.viscosity, among_sediment);
    const L of_water = lane_select(b_sediment, interface, L(0.0F));
    return viscous_coefficient(a.volume, b.volume, lane_select(a_sediment, of_sediment, of_water), g.F);
  }
};

}  // namespace thalweg
