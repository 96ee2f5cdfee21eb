#include "common/extraction/wall_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include "common/extraction/parts.hpp"

namespace thalweg {
namespace {

/// Room above a run: up to the next run of its column, or open above the highest.
struct Gap {
  double from;  // [m]
  double to;    // [m]
};

/// The gaps of all columns of a rectangle of columns, and which of them are connected.
class Gaps {
 public:
  Gaps(const RunsOfColumns& columns, double spacing) : spacing_(spacing) {
    for (const auto& [place, runs] : columns) {
      low_ = {std::min(low_.first, place.first), std::min(low_.second, place.second)};
      high_ = {std::max(high_.first, place.first), std::max(high_.second, place.second)};
    }
    nx_ = high_.first - low_.first + 1;
    ny_ = high_.second - low_.second + 1;
    first_.assign(static_cast<std::size_t>(nx_ * ny_) + 1, 0);
    // A column without any wall is open from top to bottom: one gap.
    for (long cell = 0; cell < nx_ * ny_; ++cell) {
      const auto found = columns.find({low_.first + cell / ny_, low_.second + cell % ny_});
      if (found == columns.end()) gaps_.push_back({-infinite, infinite});
      for (std::size_t r = 0; found != columns.end() && r < found->second.size(); ++r) {
        const bool highest = r + 1 == found->second.size();
        gaps_.push_back({found->second[r].high, highest ? infinite : found->second[r + 1].low});
      }
      first_[static_cast<std::size_t>(cell) + 1] = gaps_.size();
    }
    leader_.resize(gaps_.size());
    std::iota(leader_.begin(), leader_.end(), std::size_t{0});
    for (long cell = 0; cell < nx_ * ny_; ++cell) {
      if (cell / ny_ + 1 < nx_) connect(cell, cell + ny_);
      if (cell % ny_ + 1 < ny_) connect(cell, cell + 1);
    }
    is_room_.assign(gaps_.size(), 0);
    for (std::size_t g = 0; g < gaps_.size(); ++g) {
      if (gaps_[g].to == infinite) is_room_[leader(g)] = 1;
    }
  }

  /// The gap in which a place lies becomes room of the flow.
  void mark(const Vec3& place) {
    const long x = column_of(place.x(), spacing_) - low_.first;
    const long y = column_of(place.y(), spacing_) - low_.second;
    if (x < 0 || y < 0 || x >= nx_ || y >= ny_) return;
    const auto cell = static_cast<std::size_t>(x * ny_ + y);
    for (std::size_t g = first_[cell]; g < first_[cell + 1]; ++g) {
      if (place.z() >= gaps_[g].from - spacing_ && place.z() <= gaps_[g].to + spacing_) is_room_[leader(g)] = 1;
    }
  }

  /// True if the gap above run r of a column is room of the flow.
  [[nodiscard]] bool is_room(const std::pair<long, long>& place, std::size_t r) {
    const auto cell = static_cast<std::size_t>((place.first - low_.first) * ny_ + place.second - low_.second);
    return is_room_[leader(first_[cell] + r)] != 0;
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  /// Connects the gaps of two columns beside each other that a particle could pass between.
  void connect(long one, long other) {
    const auto a = static_cast<std::size_t>(one);
    const auto b = static_cast<std::size_t>(other);
    for (std::size_t g = first_[a]; g < first_[a + 1]; ++g) {
      for (std::size_t h = first_[b]; h < first_[b + 1]; ++h) {
        const double both = std::min(gaps_[g].to, gaps_[h].to) - std::max(gaps_[g].from, gaps_[h].from);
        if (both > 0.5 * spacing_) leader_[leader(g)] = leader(h);
      }
    }
  }

  std::size_t leader(std::size_t g) {
    while (leader_[g] != g) g = leader_[g] = leader_[leader_[g]];
    return g;
  }

  double spacing_;  // [m]
  std::pair<long, long> low_{std::numeric_limits<long>::max(), std::numeric_limits<long>::max()};
  std::pair<long, long> high_{std::numeric_limits<long>::min(), std::numeric_limits<long>::min()};
  long nx_ = 0;
  long ny_ = 0;
  std::vector<std::size_t> first_;  // gap of each column
  std::vector<Gap> gaps_;
  std::vector<std::size_t> leader_;
  std::vector<std::uint8_t> is_room_;  // of leaders
};

/// True if walls stand so far apart, with so little between them, that the rectangle around them cannot be held.
bool is_scattered(const RunsOfColumns& columns) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const auto& [place, runs] : columns) {
    low = std::min(low, static_cast<double>(place.second));
    high = std::max(high, static_cast<double>(place.second));
  }
  const double along =
      static_cast<double>(columns.rbegin()->first.first) - static_cast<double>(columns.begin()->first.first);
  return (along + 1) * (high - low + 1) > 1e6 + 100.0 * static_cast<double>(columns.size());
}

}  // namespace

long column_of(double coordinate, double spacing) { return std::lround(std::floor(coordinate / spacing + 1e-3)); }

void join_hollow_walls(const ParticleSet& particles, double spacing, RunsOfColumns& columns) {
  const bool any_gap =
      std::any_of(columns.begin(), columns.end(), [](const auto& column) { return column.second.size() > 1; });
  if (!any_gap || is_scattered(columns)) return;
  Gaps gaps(columns, spacing);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (is_fluid(particles.type[i])) gaps.mark(particles.position[i]);
  }
  for (auto& [place, runs] : columns) {
    std::vector<WallRun> joined{runs.front()};
    for (std::size_t r = 1; r < runs.size(); ++r) {
      if (gaps.is_room(place, r - 1)) {
        joined.push_back(runs[r]);
      } else {
        joined.back().high = runs[r].high;
        joined.back().members = runs[r].members;
      }
    }
    runs = std::move(joined);
  }
}

}  // namespace thalweg
