#pragma once

namespace thalweg {

/// Parameters of the eddy viscosity by mixing length.
template <int Dim>
struct MixingLengthScene {
  bool mixing_length = false;
};

}  // namespace thalweg
