#pragma once

#include "solver/state/scene.hpp"

// The view that one set of the mixture has of the particles around it.
namespace thalweg::mixture {

/// Volume of a neighbour as the set of `a` sees it: nothing if it is of the other set.
template <class LaneT>
HOST_DEVICE inline auto volume_seen(const LaneT& a, const LaneT& b) {
  using L = decltype(LaneT::volume);
  const L of_wall = lane_select(is_wall(b), b.volume, L(0.0F));
  return lane_select(same_phase(a, b), b.volume, of_wall);
}

/// The neighbour as the set of `a` sees it; of a wall's two pressures the one that this set exerts (a wall keeps that
/// of the grains as its excess).
template <int Dim, class LaneT>
HOST_DEVICE inline LaneT seen_by(const LaneT& a, LaneT b, const Scene<Dim>& scene) {
  using L = decltype(LaneT::volume);
  const auto b_wall = is_wall(b);
  const auto a_grain = is_sediment(a);
  b.volume = volume_seen(a, b);
  b.pressure = lane_select(a_grain & b_wall, L(scene.seepage.skeleton_stiffness) * b.excess, b.pressure);
  return b;
}

}  // namespace thalweg::mixture
