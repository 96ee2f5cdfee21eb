#pragma once

#include <stdexcept>

#include "gencase/region.hpp"

namespace thalweg::gencase {

enum class Boolean { unite, subtract, intersect };

/// Two surfaces whose combination is no closed two-manifold (they touch in an edge or a corner only), or that intersect
/// themselves.
struct NoManifold : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Cuts two closed surfaces against each other with exact arithmetic. An empty result has no triangles. Throws
/// NoManifold.
Triangles combine(const Triangles& a, const Triangles& b, Boolean how);

}  // namespace thalweg::gencase
