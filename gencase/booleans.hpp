#pragma once

#include <stdexcept>

#include "gencase/region.hpp"

namespace thalweg::gencase {

enum class Boolean { unite, subtract, intersect };

/// Thrown for two surfaces whose combination is no closed two-manifold (they touch only in an edge or a corner), and
/// for surfaces that intersect themselves. what() says which.
struct NoManifold : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Cuts two closed surfaces against each other with exact arithmetic. An empty result has no triangles. Throws
/// NoManifold.
Triangles combine(const Triangles& a, const Triangles& b, Boolean how);

}  // namespace thalweg::gencase
