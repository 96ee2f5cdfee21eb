#pragma once

#include "solver/state/arrays.hpp"
#include "solver/state/particles.hpp"

namespace thalweg {

namespace field {
inline constexpr Field motion{"Motion"};
inline constexpr Field moved_from{"MovedFrom"};
}  // namespace field

/// Arrays of the moving walls; empty without them.
template <class Device>
struct MovingWallsArrays {
  typename Device::template Buffer<Index> motion;         // number of the motion; 0: stands still
  typename Device::template Buffer<Position> moved_from;  // where it stood at t = 0

  template <class Scene, class Visitor>
  void describe(const Scene&, Visitor& v) {
    v.array(field::motion, motion, sorted, Index{0});
    v.array(field::moved_from, moved_from, sorted | checkpointed, Position{});
    v.shown("Motion", motion);
  }
};

}  // namespace thalweg
