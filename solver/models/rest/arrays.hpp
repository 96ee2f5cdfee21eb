#pragma once

#include "solver/state/arrays.hpp"
#include "solver/state/particles.hpp"

namespace thalweg {

namespace field {
inline constexpr Field stopping{"Stopping"};
}

/// Arrays of the model of resting deposits.
template <class Device>
struct RestArrays {
  typename Device::template Buffer<std::uint8_t> stopping;  // 1 where a particle stops in this step

  template <class Scene, class Visitor>
  void describe(const Scene&, Visitor& v) {
    v.array(field::stopping, stopping, scratch, std::uint8_t{0});
    v.shown_kind("Resting", [](float kind) { return kind == kind::resting ? 1.0F : 0.0F; });
  }
};

}  // namespace thalweg
