#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "physics/lane_math.hpp"
#include "solver/lists/cells.hpp"

// The list cells in reach of some particles.
namespace thalweg::neighbours {

/// The extent of some particles, counted in 2^-32 of a list cell.
template <int Dim>
struct CellExtent {
  Vec<Dim, std::int64_t> low{};
  Vec<Dim, std::int64_t> high{};

  /// True if it is at most two cells wide.
  [[nodiscard]] HOST_DEVICE bool is_compact() const {
    bool compact = true;
    for (int k = 0; k < Dim; ++k) compact = compact && (high[k] >> 32) - (low[k] >> 32) <= 1;
    return compact;
  }
};

/// The list cells from `first` to `last` along each direction.
template <int Dim>
struct CellWindow {
  Vec<Dim, std::int64_t> first{};
  Vec<Dim, std::int64_t> last{};
  bool once_around[Dim];  // a short period, once around and no further; its cells are near both ways
};

/// A list reach [m] around particles, and the cells that it meets.
template <int Dim>
struct CellReach {
  /// Of gaps between particles and cells.
  static constexpr float rounding = 1.0001F;

  CellTable<Dim> table;
  Lattice<Dim> lattice;
  float reach2;  // [m^2]

  /// The extent of n particles; place(m, k) is the place of the m-th along k.
  template <class Place>
  HOST_DEVICE CellExtent<Dim> extent_of(Index n, const Place& place) const {
    CellExtent<Dim> extent{};
    for (Index m = 0; m < n; ++m) {
      for (int k = 0; k < Dim; ++k) {
        const auto at =
            static_cast<std::int64_t>(std::uint64_t{static_cast<std::uint32_t>(place(m, k))} * lattice.cells[k]);
        extent.low[k] = m == 0 ? at : std::min(extent.low[k], at);
        extent.high[k] = m == 0 ? at : std::max(extent.high[k], at);
      }
    }
    return extent;
  }

  HOST_DEVICE CellWindow<Dim> window_around(const CellExtent<Dim>& extent) const {
    CellWindow<Dim> window{};
    for (int k = 0; k < Dim; ++k) {
      window.first[k] = (extent.low[k] >> 32) - 1;
      window.last[k] = (extent.high[k] >> 32) + 1;
      window.once_around[k] = table.period[k] != 0 && window.last[k] - window.first[k] >= table.period[k];
      if (window.once_around[k]) window.last[k] = window.first[k] + table.period[k] - 1;
    }
    return window;
  }

  /// Square of the distance along k from particles to a list cell [m^2].
  HOST_DEVICE float squared_gap(const CellExtent<Dim>& extent, const CellWindow<Dim>& window, int k,
                                std::int64_t cell) const {
    if (window.once_around[k]) return 0;
    const std::int64_t below = extent.low[k] - ((cell + 1) << 32);
    const std::int64_t above = (cell << 32) - extent.high[k];
    const auto gap = static_cast<float>(std::max<std::int64_t>(0, std::max(below, above)));
    const float d = gap * lattice.quantum[k] / static_cast<float>(lattice.cells[k]);
    return d * d;
  }
};

/// Places of a few particles beside each other, relative to their middle.
template <int Dim>
struct LocalFrame {
  Vec<Dim, std::int32_t> middle{};  // [quanta]
  Vec<Dim, float> half{};           // half the particles' extent [m]

  /// Of squares of distances up to a few reaches, in single precision.
  static constexpr float rounding = 1.00001F;

  LocalFrame() = default;

  /// Around n particles; place(m, k) is the place of the m-th along k.
  template <class Place>
  HOST_DEVICE LocalFrame(const Lattice<Dim>& lattice, Index n, const Place& place) {
    for (int k = 0; k < Dim; ++k) {
      std::int64_t low = 0;  // from the first one's place
      std::int64_t high = 0;
      for (Index m = 1; m < n; ++m) {
        const std::int64_t d = lane_difference(place(m, k), place(0, k));
        low = std::min(low, d);
        high = std::max(high, d);
      }
      middle[k] = lane_difference(place(0, k), static_cast<std::int32_t>(-(low + high) / 2));
      const std::int64_t half_width = (high - low + 2) / 2;
      half[k] = rounding * static_cast<float>(half_width) * lattice.quantum[k];
    }
  }

  /// True if a reach [m^2] around the frame is wider than a period: then a place has several images near it.
  [[nodiscard]] HOST_DEVICE bool meets_itself(const Lattice<Dim>& lattice, float reach2) const {
    const double reach = std::sqrt(rounding * reach2);
    bool meets = false;
    for (int k = 0; k < Dim; ++k) {
      meets = meets || (lattice.periodic[k] && 2 * (reach + half[k]) > lattice.range[k]);
    }
    return meets;
  }
};

}  // namespace thalweg::neighbours
