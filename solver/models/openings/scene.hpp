#pragma once

namespace thalweg {

template <int Dim>
struct OpeningsScene {
  bool has_openings = false;  // water enters or leaves: [[inlet]], [[outlet]]
};

}  // namespace thalweg
