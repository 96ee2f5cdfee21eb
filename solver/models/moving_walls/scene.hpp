#pragma once

namespace thalweg {

/// Parameters of the moving walls; their motions lie on the host (wall_motion.hpp).
template <int Dim>
struct MovingWallsScene {
  bool has_moving_walls = false;
};

}  // namespace thalweg
