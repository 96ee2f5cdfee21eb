#include "postproc/bed_change.hpp"

#include <cmath>

namespace thalweg {
namespace {

constexpr double same_place = 1e-9;  // [m] columns lie at multiples of the spacing

/// A column without sediment: its bed is the floor, or it has none.
bool is_bare(const Profile& profile, std::size_t i) {
  return std::isnan(profile.bed[i]) || std::abs(profile.bed[i] - profile.floor[i]) < same_place;
}

/// Height of the bed; the floor of a dry column.
double level_at(const Profile& profile, std::size_t i) {
  const bool dry = !profile.floor.empty() && std::isnan(profile.bed[i]) && std::isnan(profile.free_surface[i]);
  return dry ? profile.floor[i] : profile.bed[i];
}

}  // namespace

std::vector<double> rise_of_bed(const Profile& before, const Profile& after) {
  std::vector<double> rise(after.x.size(), Profile::missing);
  if (before.bed.empty() || after.bed.empty()) return rise;
  const bool floors = !before.floor.empty() && !after.floor.empty();
  const double same_floor = after.x.size() > 1 ? after.x[1] - after.x[0] : 0;  // [m] a spacing
  for (std::size_t a = 0, b = 0; a < after.x.size(); ++a) {
    while (b < before.x.size() && before.x[b] < after.x[a] - same_place) ++b;
    if (b == before.x.size()) break;
    if (std::abs(before.x[b] - after.x[a]) > same_place) continue;
    if (floors && is_bare(before, b) && is_bare(after, a)) continue;
    if (floors && !(std::abs(after.floor[a] - before.floor[b]) <= same_floor)) continue;
    rise[a] = level_at(after, a) - level_at(before, b);
  }
  return rise;
}

}  // namespace thalweg
