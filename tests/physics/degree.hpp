#pragma once

#include <numbers>

namespace thalweg {

// One degree [rad].
inline constexpr double degree = std::numbers::pi / 180;

}  // namespace thalweg
