#include "postproc/bed_change.hpp"

#include <cmath>

namespace thalweg {

std::optional<BedChange> bed_change(const Profile& before, const Profile& after) {
  if (before.bed.empty() || after.bed.empty()) return std::nullopt;
  std::optional<BedChange> change;
  std::size_t b = 0;
  for (std::size_t a = 0; a < after.x.size(); ++a) {
    constexpr double same_place = 1e-9;  // [m] columns lie at multiples of the spacing
    while (b < before.x.size() && before.x[b] < after.x[a] - same_place) ++b;
    if (b == before.x.size()) break;
    const double rise = after.bed[a] - before.bed[b];
    if (std::abs(before.x[b] - after.x[a]) > same_place || std::isnan(rise)) continue;
    if (!change) change = BedChange{0, after.x[a], 0, after.x[a]};
    if (-rise > change->scour) {
      change->scour = -rise;
      change->scour_at = after.x[a];
    }
    if (rise > change->deposition) {
      change->deposition = rise;
      change->deposition_at = after.x[a];
    }
  }
  return change;
}

}  // namespace thalweg
