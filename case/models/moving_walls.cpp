#include "case/models/moving_walls.hpp"

#include "case/case.hpp"

namespace thalweg::models {

bool MovingWalls::is_on(const Case& whole) { return !whole.motions.empty(); }

}  // namespace thalweg::models
