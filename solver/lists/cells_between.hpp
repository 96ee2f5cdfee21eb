#pragma once

#include <algorithm>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "solver/backend/buffer.hpp"
#include "solver/backend/ranks.hpp"
#include "solver/lists/sort.hpp"

// The list cells in which a rank's particles lie, and which of them other ranks need to know: those near their own.
namespace thalweg::neighbours {

/// A list cell as one number.
inline constexpr int cell_bits = 21;
template <int Dim>
std::uint64_t packed_cell(const Vec<Dim, std::int64_t>& cell) {
  std::uint64_t packed = 0;
  for (int k = 0; k < Dim; ++k) packed |= static_cast<std::uint64_t>(cell[k]) << (cell_bits * k);
  return packed;
}
/// The list cell of a particle's place.
template <int Dim>
std::uint64_t packed_cell_at(const Lattice<Dim>& lattice, const std::int32_t* place) {
  const auto at = cell_of<Dim>(lattice, place, 0);
  Vec<Dim, std::int64_t> cell{};
  for (int k = 0; k < Dim; ++k) cell[k] = at[k];
  return packed_cell<Dim>(cell);
}
template <int Dim>
Vec<Dim, std::int64_t> unpacked_cell(std::uint64_t packed) {
  Vec<Dim, std::int64_t> cell{};
  for (int k = 0; k < Dim; ++k) {
    cell[k] = static_cast<std::int64_t>(packed >> (cell_bits * k) & ((std::uint64_t{1} << cell_bits) - 1));
  }
  return cell;
}

/// A box of cells that may reach around periodic directions.
template <int Dim>
struct BoxOfCells {
  std::int64_t low[3] = {INT64_MAX / 2, INT64_MAX / 2, INT64_MAX / 2};
  std::int64_t high[3] = {-1, -1, -1};

  void add(const Vec<Dim, std::int64_t>& cell) {
    for (int k = 0; k < Dim; ++k) low[k] = std::min(low[k], cell[k]), high[k] = std::max(high[k], cell[k]);
  }
  [[nodiscard]] bool is_empty() const { return high[0] < 0; }
  /// True if a cell lies in it or within `around` cells of it; period: cells once around, 0 where there is no way around.
  [[nodiscard]] bool is_near(const Vec<Dim, std::int64_t>& cell, const Vec<Dim, std::int64_t>& period,
                             const Vec<Dim, std::int64_t>& around) const {
    bool near = !is_empty();
    for (int k = 0; k < Dim; ++k) {
      bool along = false;
      for (int turn = -1; turn <= 1; ++turn) {
        const std::int64_t c = cell[k] + turn * period[k];
        along = along || (c >= low[k] - around[k] && c <= high[k] + around[k]);
      }
      near = near && along;
    }
    return near;
  }
};

/// Cells once around each direction, 0 where it is not periodic.
template <int Dim>
Vec<Dim, std::int64_t> periods_of(const Lattice<Dim>& lattice) {
  Vec<Dim, std::int64_t> period{};
  for (int k = 0; k < Dim; ++k) period[k] = lattice.periodic[k] ? lattice.cells[k] : 0;
  return period;
}

/// what(cell) for a cell and those beside it.
template <int Dim, class What>
void for_each_cell_around(std::uint64_t packed, const Vec<Dim, std::int64_t>& period, const What& what) {
  const auto middle = unpacked_cell<Dim>(packed);
  int number = 1;
  for (int k = 0; k < Dim; ++k) number *= 3;
  for (int n = 0; n < number; ++n) {
    Vec<Dim, std::int64_t> cell{};
    bool exists = true;
    for (int k = 0, rest = n; k < Dim; ++k, rest /= 3) {
      cell[k] = middle[k] + rest % 3 - 1;
      if (period[k] != 0) cell[k] = (cell[k] + period[k]) % period[k];
      exists = exists && cell[k] >= 0;
    }
    if (exists) what(packed_cell<Dim>(cell));
  }
}

/// Cells of other ranks, of those with fluid and of those with walls.
struct NearCells {
  std::vector<std::uint64_t> fluid;
  std::vector<std::uint64_t> walls;
};

/// The cells of this rank's particles, and the particles in each.
template <int Dim>
class OwnCells {
 public:
  struct Run {
    std::uint64_t cell;
    Index begin;
    Index end;
  };
  std::vector<Run> fluid;
  std::vector<Run> walls;
  BoxOfCells<Dim> box;
  Lattice<Dim> lattice;

  template <class Device>
  OwnCells(Device& on, const Particles<Device>& p, const Scene<Dim>& scene) : lattice(scene.lattice) {
    const auto records = on.download(p.record, 0, p.count);
    for (Index i = 0; i < p.count; ++i) {
      const std::uint64_t packed = packed_cell_at(lattice, records[i].place);
      auto& runs = i < p.fluid_count ? fluid : walls;
      if (runs.empty() || runs.back().cell != packed) {
        runs.push_back({packed, i, i});
        box.add(unpacked_cell<Dim>(packed));
      }
      runs.back().end = i + 1;
    }
  }

  /// This rank's particles in the cells around another's: fluid beside any of its cells, of which there are `fluid_count`,
  /// then walls beside its fluid.
  [[nodiscard]] HostBuffer<Index> beside(const NearCells& other, Index& fluid_count) const {
    HostBuffer<Index> chosen;
    const auto around_fluid = cells_around(other.fluid);
    auto around_all = around_fluid;
    around_all.merge(cells_around(other.walls));
    choose(fluid, around_all, chosen);
    fluid_count = static_cast<Index>(chosen.size());
    choose(walls, around_fluid, chosen);
    return chosen;
  }

 private:
  using Set = std::unordered_set<std::uint64_t>;

  [[nodiscard]] Set cells_around(const std::vector<std::uint64_t>& cells) const {
    const auto period = periods_of(lattice);
    Set around;
    for (const std::uint64_t packed : cells) {
      for_each_cell_around<Dim>(packed, period, [&](std::uint64_t cell) { around.insert(cell); });
    }
    return around;
  }

  static void choose(const std::vector<Run>& runs, const Set& cells, HostBuffer<Index>& to) {
    for (const Run& run : runs) {
      if (!cells.contains(run.cell)) continue;
      for (Index i = run.begin; i < run.end; ++i) to.push_back(i);
    }
  }
};

/// The cells of every other rank that lie near this rank's.
template <int Dim>
std::vector<NearCells> exchange_cells(Ranks& ranks, const OwnCells<Dim>& own, const Scene<Dim>& scene) {
  const auto boxes = gather_from(ranks, own.box);
  const auto period = periods_of(scene.lattice);
  Vec<Dim, std::int64_t> one{};
  for (int k = 0; k < Dim; ++k) one[k] = 1;
  std::vector<Bytes> to(boxes.size());
  for (std::size_t r = 0; r < boxes.size(); ++r) {
    if (static_cast<int>(r) == ranks.rank()) continue;
    const auto add = [&](const auto& runs) {
      std::vector<std::uint64_t> cells;
      for (const auto& run : runs) {
        if (boxes[r].is_near(unpacked_cell<Dim>(run.cell), period, one)) cells.push_back(run.cell);
      }
      const std::uint64_t n = cells.size();
      append_to(to[r], &n, 1);
      append_to(to[r], cells.data(), cells.size());
    };
    add(own.fluid);
    add(own.walls);
  }
  const auto from = exchange_any(ranks, to);
  std::vector<NearCells> near(boxes.size());
  for (std::size_t r = 0; r < near.size(); ++r) {
    if (static_cast<int>(r) == ranks.rank()) continue;
    MessageReader message(from[r]);
    for (auto* cells : {&near[r].fluid, &near[r].walls}) {
      cells->resize(message.template number<std::uint64_t>());
      message.read(cells->data(), cells->size());
    }
  }
  return near;
}

/// Particles of a rank that lie in cells beside another's: fluid first.
struct Candidates {
  HostBuffer<Index> index;
  Index fluid_count = 0;
};

/// Of this rank's candidates those in reach of another rank's.
template <int Dim>
class InReach {
 public:
  using Cell = std::uint64_t;

  /// places: of the other rank's candidates, three numbers each, fluid first.
  InReach(const Lattice<Dim>& lattice, double reach, const std::vector<std::int32_t>& places, std::size_t fluid)
      : lattice_(lattice), reach2_(static_cast<float>(rounding * reach * reach)), places_(places), fluid_(fluid) {
    for (std::size_t n = 0; n < places.size() / 3; ++n)
      cells_[packed_cell_at(lattice, places.data() + 3 * n)].push_back(n);
  }

  /// True for a place within reach of the other's fluid or, for fluid, of its walls.
  [[nodiscard]] bool operator()(const std::int32_t* place, bool is_fluid) const {
    bool found = false;
    for_each_cell_around<Dim>(packed_cell_at(lattice_, place), periods_of(lattice_), [&](Cell cell) {
      const auto beside = cells_.find(cell);
      if (found || beside == cells_.end()) return;
      for (const std::size_t n : beside->second) {
        found = found || ((is_fluid || n < fluid_) && is_near(place, places_.data() + 3 * n));
      }
    });
    return found;
  }

 private:
  static constexpr double rounding = 1.001;  // more than that of the search

  [[nodiscard]] bool is_near(const std::int32_t* a, const std::int32_t* b) const {
    float r2 = 0;
    for (int k = 0; k < Dim; ++k) {
      const int c = axis<Dim>(k);
      const float d = static_cast<float>(Lattice<Dim>::difference(a[c], b[c])) * lattice_.quantum[k];
      r2 += d * d;
    }
    return r2 < reach2_;
  }

  Lattice<Dim> lattice_;
  float reach2_;
  const std::vector<std::int32_t>& places_;
  std::size_t fluid_;
  std::unordered_map<Cell, std::vector<std::size_t>> cells_;
};

/// Keeps of the candidates for each other rank those that are in reach of what it has.
template <int Dim>
void keep_those_in_reach(Ranks& ranks, const std::span<const Record> records, const Scene<Dim>& scene,
                         std::vector<Candidates>& candidates) {
  std::vector<Bytes> to(candidates.size());
  for (std::size_t r = 0; r < candidates.size(); ++r) {
    const std::int64_t fluid = candidates[r].fluid_count;
    append_to(to[r], &fluid, 1);
    for (const Index i : candidates[r].index) append_to(to[r], records[i].place, 3);
  }
  const auto from = exchange_any(ranks, to);
  for (std::size_t r = 0; r < candidates.size(); ++r) {
    MessageReader message(from[r]);
    const auto fluid = message.template number<std::int64_t>();
    std::vector<std::int32_t> places((from[r].size() - sizeof(fluid)) / sizeof(std::int32_t));
    message.read(places.data(), places.size());
    const InReach<Dim> in_reach(scene.lattice, scene.list_reach, places, static_cast<std::size_t>(fluid));
    Candidates kept;
    for (Index n = 0; n < candidates[r].index.size(); ++n) {
      const Index i = candidates[r].index[n];
      const bool is_fluid = n < candidates[r].fluid_count;
      if (!in_reach(records[i].place, is_fluid)) continue;
      kept.index.push_back(i);
      kept.fluid_count += is_fluid ? 1 : 0;
    }
    candidates[r] = std::move(kept);
  }
}

}  // namespace thalweg::neighbours
