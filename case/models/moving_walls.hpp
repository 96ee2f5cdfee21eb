#pragma once

#include "case/models/rule.hpp"

namespace thalweg::models {

/// Walls that move as a [[motion]] says. Models that cannot take them say so in their own rules.
struct MovingWalls {
  static bool is_on(const Case& whole);
};

}  // namespace thalweg::models
