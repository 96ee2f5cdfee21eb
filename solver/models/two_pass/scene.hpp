#pragma once

namespace thalweg {

/// Parameters of the two-pass integrator.
template <int Dim>
struct TwoPassScene {
  bool two_pass = false;
};

}  // namespace thalweg
