#pragma once

#include "physics/kernel.hpp"
#include "solver/state/record.hpp"

namespace thalweg {

/// The parts of the kernel that a sweep's body may ask for, as `static constexpr unsigned kernel = …`.
enum PairKernel : unsigned { no_kernel = 0, kernel_value = 1, kernel_gradient = 2 };

/// The geometry of one pair a, b, made once by the sweep. W and F are set if the body asks for them.
template <int Dim, class L>
struct PairGeometry {
  Vec<Dim, L> r;  // x_a - x_b [m]
  L r2;           // r . r [m^2]
  L W;            // kernel [1/m^Dim]
  L F;            // grad W = F r [1/m^(Dim+2)]; F <= 0, and 0 outside the support
};

/// Turns differences of places into the geometry of a pair.
template <int Dim>
struct PairMetric {
  Vec<Dim, float> quantum;  // [m]
  WendlandC2<Dim, float> kernel;

  /// Fills r2, W and F of a geometry whose r is known.
  template <unsigned asked, class L>
  HOST_DEVICE void complete(PairGeometry<Dim, L>& g) const {
    g.r2 = dot(g.r, g.r);
    if constexpr (asked != no_kernel) {
      const L closeness = kernel.closeness(lane_sqrt(g.r2));
      if constexpr ((asked & kernel_value) != 0) g.W = kernel.value(closeness);
      if constexpr ((asked & kernel_gradient) != 0) g.F = kernel.gradient(closeness);
    }
  }
};

}  // namespace thalweg
