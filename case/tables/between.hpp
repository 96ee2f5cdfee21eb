#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace thalweg {

/// Place of a value among increasing ones: from entry `below`, by a share of the way to the next. Before the first and
/// behind the last entry: at that entry.
struct Between {
  std::size_t below = 0;
  double share = 0;  // [-]

  [[nodiscard]] std::size_t above() const { return share > 0 ? below + 1 : below; }
  [[nodiscard]] double mix(double at_below, double at_above) const { return at_below + share * (at_above - at_below); }
};

/// Among the first `count` of `places`, one at least.
inline Between between(const std::vector<double>& places, std::size_t count, double at) {
  const auto end = places.begin() + static_cast<std::ptrdiff_t>(count);
  const auto after = std::upper_bound(places.begin(), end, at);
  if (after == places.begin()) return {};
  if (after == end) return {count - 1, 0};
  const auto above = static_cast<std::size_t>(after - places.begin());
  return {above - 1, (at - places[above - 1]) / (places[above] - places[above - 1])};
}

}  // namespace thalweg
