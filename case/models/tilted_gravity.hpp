#pragma once

#include "case/case.hpp"

namespace thalweg {

/// True unless gravity points straight down, along -z.
inline bool has_tilted_gravity(const Case& of) {
  const Vec3& g = of.domain.gravity;
  return !(g.z() < 0 && g.x() == 0 && g.y() == 0);
}

}  // namespace thalweg
