#pragma once

#include <array>

namespace thalweg {

/// The words for ParticleType and SedimentState, by number.
inline constexpr std::array type_words{"wall", "moving wall", "water", "sediment"};
inline constexpr std::array state_words{"other", "deposit", "bed load", "suspended"};

}  // namespace thalweg
