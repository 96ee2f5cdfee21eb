#pragma once

#include <optional>

#include "common/profile.hpp"

namespace thalweg {

/// By how much the bed has fallen and risen at most between two profiles.
struct BedChange {
  double scour = 0;          // [m] >= 0
  double scour_at = 0;       // [m] x
  double deposition = 0;     // [m] >= 0
  double deposition_at = 0;  // [m] x
};

/// Compares the `bed` of two profiles at the columns both have; nothing when they share none.
std::optional<BedChange> bed_change(const Profile& before, const Profile& after);

}  // namespace thalweg
