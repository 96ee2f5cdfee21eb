#pragma once

#include <algorithm>
#include <bit>
#include <vector>

#include "solver/lists/hilbert.hpp"
#include "solver/passes/time_step.hpp"

// Neighbour lists: particles are sorted along a Hilbert curve of cells one list reach wide, and every cluster of four
// consecutive ones gets one list of all particles within reach of any of them. The reach exceeds the kernel's support
// by a skin, so that a list serves until some particle has crossed half the skin.
namespace thalweg {

/// A particle taken out of the run.
struct ExcludedParticle {
  std::int64_t id;
  std::uint8_t type;
  Position position;
  float velocity[3];
};

namespace neighbours {

inline constexpr std::uint64_t wall_section = std::uint64_t{1} << 62;
inline constexpr std::uint64_t excluded_section = std::uint64_t{1} << 63;
inline constexpr int fine_bits =
    3;  // a list cell is ordered inside by eighths, so that four in a row lie close together

template <int Dim>
HOST_DEVICE inline Vec<Dim, std::uint32_t> cell_of(const Lattice<Dim>& lattice, const std::int32_t* place, int bits) {
  Vec<Dim, std::uint32_t> cell{};
  for (int k = 0; k < Dim; ++k) {
    cell[k] = Lattice<Dim>::part(place[axis<Dim>(k)], static_cast<std::uint64_t>(lattice.cells[k]) << bits);
  }
  return cell;
}

/// Where the particles of each list cell begin and end, over the box of occupied cells.
template <int Dim>
struct CellTable {
  Vec<Dim, std::int64_t> low{};
  Vec<Dim, std::int64_t> extent{};
  Vec<Dim, std::int64_t> period{};  // cells once around, 0 where the direction is not periodic
  const Index* begin[2];            // of fluid, of walls
  const Index* end[2];

  [[nodiscard]] HOST_DEVICE std::int64_t size() const {
    std::int64_t n = 1;
    for (int k = 0; k < Dim; ++k) n *= extent[k];
    return n;
  }

  /// Row-major number of a cell, or -1 outside the box.
  HOST_DEVICE std::int64_t number(Vec<Dim, std::int64_t> cell) const {
    std::int64_t n = 0;
    for (int k = Dim - 1; k >= 0; --k) {
      if (period[k] != 0) cell[k] = (cell[k] + period[k]) % period[k];
      const std::int64_t i = cell[k] - low[k];
      if (i < 0 || i >= extent[k]) return -1;
      n = n * extent[k] + i;
    }
    return n;
  }
};

/// Finds every particle within reach of any member of a cluster, each once.
template <int Dim, class Device>
struct ClusterSearch {
  CellTable<Dim> table;
  Lattice<Dim> lattice;
  const Record* records;
  Vec<Dim, const std::int32_t*> places;  // of all particles, one array a direction
  float reach2;

  /// Which of some particles lie within reach of a member in [from, to) but of none in [already, from).
  struct Within {
    const ClusterSearch& search;
    Index already, from, to;

    template <class I>
    HOST_DEVICE auto operator()(const Vec<Dim, I>& place) const {
      auto in_reach = near(place, from);
      for (Index m = from + 1; m < to; ++m) in_reach = lane_or(in_reach, near(place, m));
      for (Index m = already; m < from; ++m) in_reach = lane_and_not(in_reach, near(place, m));
      return in_reach;
    }

    template <class I>
    HOST_DEVICE auto near(const Vec<Dim, I>& place, Index m) const {
      auto d = along(place, m, 0);
      auto r2 = d * d;
      for (int k = 1; k < Dim; ++k) {
        d = along(place, m, k);
        r2 = r2 + d * d;
      }
      return r2 < decltype(r2)(search.reach2);
    }

    template <class I>
    HOST_DEVICE auto along(const Vec<Dim, I>& place, Index m, int k) const {
      const auto d = to_float(lane_difference(place[k], search.records[m].place[axis<Dim>(k)]));
      return d * decltype(d)(search.lattice.quantum[k]);
    }
  };

  /// Where members lie, counted in 2^-32 of a list cell.
  struct Box {
    Vec<Dim, std::int64_t> low{};
    Vec<Dim, std::int64_t> high{};
  };

  /// Square of the distance along k from a box to a list cell [m^2].
  HOST_DEVICE float squared_gap(const Box& box, int k, std::int64_t cell) const {
    const std::int64_t below = box.low[k] - ((cell + 1) << 32);
    const std::int64_t above = (cell << 32) - box.high[k];
    const auto gap = static_cast<float>(std::max<std::int64_t>(0, std::max(below, above)));
    const float d = gap * lattice.quantum[k] / static_cast<float>(lattice.cells[k]);
    return d * d;
  }

  /// found(hits) for particles of the cells in reach of a box that lie within reach of a member in [from, to) but of
  /// none in [already, from).
  template <class Found>
  HOST_DEVICE void visit(const Box& box, Index already, Index from, Index to, int sections, const Found& found) const {
    constexpr float rounding = 1.0001F;  // of the gaps
    Vec<Dim, std::int64_t> first{};
    Vec<Dim, std::int64_t> last{};
    bool once_around[Dim];
    for (int k = 0; k < Dim; ++k) {
      first[k] = (box.low[k] >> 32) - 1;
      last[k] = (box.high[k] >> 32) + 1;
      // Once around a short period and no further; the cells are then near both ways.
      once_around[k] = table.period[k] != 0 && last[k] - first[k] >= table.period[k];
      if (once_around[k]) last[k] = first[k] + table.period[k] - 1;
    }
    const auto gap = [&](int k, std::int64_t c) { return once_around[k] ? 0 : squared_gap(box, k, c); };
    Vec<Dim, float> gap2{};
    for (int k = 0; k < Dim; ++k) gap2[k] = gap(k, first[k]);
    const Within within{*this, already, from, to};
    Vec<Dim, std::int64_t> cell = first;
    while (true) {
      float distance2 = gap2[0];
      for (int k = 1; k < Dim; ++k) distance2 += gap2[k];
      const std::int64_t n = distance2 < rounding * reach2 ? table.number(cell) : -1;
      for (int s = 0; n >= 0 && s < sections; ++s) {
        Device::template filter<Dim>(places, table.begin[s][n], table.end[s][n], within, found);
      }
      int k = 0;
      for (; k < Dim && ++cell[k] > last[k]; ++k) {
        cell[k] = first[k];
        gap2[k] = gap(k, cell[k]);
      }
      if (k == Dim) return;
      gap2[k] = gap(k, cell[k]);
    }
  }

  HOST_DEVICE Box box_of(Index first, Index last) const {
    Box box{};
    for (Index m = first; m < last; ++m) {
      for (int k = 0; k < Dim; ++k) {
        const auto at = static_cast<std::int64_t>(
            std::uint64_t{static_cast<std::uint32_t>(records[m].place[axis<Dim>(k)])} * lattice.cells[k]);
        box.low[k] = m == first ? at : std::min(box.low[k], at);
        box.high[k] = m == first ? at : std::max(box.high[k], at);
      }
    }
    return box;
  }

  /// found(hits) for the neighbours of cluster members [first, last); walls need only fluid neighbours (sections = 1).
  template <class Found>
  HOST_DEVICE void search(Index first, Index last, int sections, const Found& found) const {
    const Box box = box_of(first, last);
    std::int64_t widest = 0;
    for (int k = 0; k < Dim; ++k) widest = std::max(widest, (box.high[k] >> 32) - (box.low[k] >> 32));
    if (widest <= 1) {
      visit(box, first, first, last, sections, found);
      return;
    }
    // Four in a row that lie far apart (isolated grains, the edge of the domain): around each by itself.
    for (Index m = first; m < last; ++m) visit(box_of(m, m + 1), first, m, m + 1, sections, found);
  }
};

/// Counts what a search finds.
struct Count {
  Index& n;
  template <class Hits>
  HOST_DEVICE void operator()(const Hits& hits) const {
    n += hits.count();
  }
};

/// Writes what a search finds one after the other; gathers the bits of its flags, if there are any.
struct Write {
  Index* entries;
  Index& at;
  const std::uint8_t* flags;
  std::uint8_t& gathered;
  template <class Hits>
  HOST_DEVICE void operator()(const Hits& hits) const {
    at += hits.write(entries + at);
    if (flags != nullptr) gathered |= hits.any(flags);
  }
};

/// A wall that moves and has no volume is parked, not excluded (models/moving_walls/moving_walls.hpp).
HOST_DEVICE inline bool is_excluded(const Record& r, const Index* motion, Index i) {
  return r.volume == 0 && (motion == nullptr || motion[i] == 0);
}

/// Null without walls that move.
template <class Device>
const Index* motions_of(const Particles<Device>& p) {
  return p.motion.size() == 0 ? nullptr : p.motion.data();
}

/// How many particles there are without the excluded ones, and how many of them are fluid.
struct Census {
  Index kept = 0;
  Index fluid = 0;
};

template <class Device>
Census take_census(Device& on, const Particles<Device>& p) {
  const Record* records = p.record.data();
  const Index* motion = motions_of(p);
  return on.reduce(
      p.count, Census{},
      [=] HOST_DEVICE(Index i) {
        if (is_excluded(records[i], motion, i)) return Census{};
        return Census{1, records[i].phase == phase_wall ? Index{0} : Index{1}};
      },
      [] HOST_DEVICE(Census a, const Census& b) {
        return Census{a.kept + b.kept, a.fluid + b.fluid};
      });
}

/// Sorts all per-particle arrays; excluded particles (zero volume) end up behind `count` and are returned.
template <int Dim, class Device>
std::vector<ExcludedParticle> sort_particles(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  const Census census = take_census(on, p);
  typename Device::template Buffer<std::uint64_t> key;
  typename Device::template Buffer<Index> order;
  key.resize(p.count);
  order.resize(p.count);
  {
    const Record* records = p.record.data();
    std::uint64_t* keys = key.data();
    Index* o = order.data();
    const Lattice<Dim> lattice = scene.lattice;
    const Index* motion = motions_of(p);
    std::uint32_t most_cells = 1;
    for (int k = 0; k < Dim; ++k) most_cells = std::max(most_cells, static_cast<std::uint32_t>(lattice.cells[k]));
    const int bits = static_cast<int>(std::bit_width(most_cells - 1)) + fine_bits;
    on.for_each(p.count, [=] HOST_DEVICE(Index i) {
      const Record& r = records[i];
      std::uint64_t k = hilbert_code<Dim>(cell_of<Dim>(lattice, r.place, fine_bits), bits);
      if (r.phase == phase_wall) k |= wall_section;
      if (is_excluded(r, motion, i)) k |= excluded_section;
      keys[i] = k;
      o[i] = i;
    });
  }
  on.sort_by_key(key, order);
  const auto scratch_reorder = [&](auto& buffer) {
    std::remove_reference_t<decltype(buffer)> scratch;
    on.reorder(buffer, order, scratch);
  };
  scratch_reorder(p.record);
  scratch_reorder(p.position);
  scratch_reorder(p.mass);
  scratch_reorder(p.id);
  scratch_reorder(p.type);
  scratch_reorder(p.rates);
  if (scene.has_sediment) scratch_reorder(p.sediment);
  if (scene.has_states) scratch_reorder(p.bed);
  if (scene.seepage.pore_pressure) scratch_reorder(p.excess_pore_pressure);
  if (scene.has_moving_walls) scratch_reorder(p.motion), scratch_reorder(p.moved_from);

  const Index end = census.kept;
  std::vector<ExcludedParticle> excluded;
  if (end < p.count) {
    const auto records = on.on_host(p.record, end, p.count);
    const auto ids = on.on_host(p.id, end, p.count);
    const auto types = on.on_host(p.type, end, p.count);
    const auto positions = on.on_host(p.position, end, p.count);
    for (std::size_t i = 0; i < records.size(); ++i) {
      const Record& r = records[i];
      excluded.push_back({ids[i], types[i], positions[i], {r.velocity[0], r.velocity[1], r.velocity[2]}});
    }
    p.record.resize(end + 1);
    Record* last = p.record.data() + end;
    on.for_each(1, [=] HOST_DEVICE(Index) { *last = Record{}; });
    p.position.resize(end);
    p.mass.resize(end);
    p.id.resize(end);
    p.type.resize(end);
    p.rates.resize(end);
    if (scene.has_sediment) p.sediment.resize(end);
    if (scene.has_states) p.bed.resize(end);
    if (scene.seepage.pore_pressure) p.excess_pore_pressure.resize(end);
    if (scene.has_moving_walls) p.motion.resize(end), p.moved_from.resize(end);
  }
  p.count = end;
  p.fluid_count = census.fluid;
  return excluded;
}

template <int Dim, class Device>
struct Cells {
  CellTable<Dim> table;
  typename Device::template Buffer<Index> begin[2];
  typename Device::template Buffer<Index> end[2];
};

template <int Dim>
struct CellBox {
  Vec<Dim, std::int64_t> low, high;
};

template <int Dim, class Device>
Cells<Dim, Device> fill_cells(Device& on, const Particles<Device>& p, const Scene<Dim>& scene) {
  Cells<Dim, Device> cells;
  CellTable<Dim>& table = cells.table;
  const Record* records = p.record.data();
  const Lattice<Dim> lattice = scene.lattice;
  using Box = CellBox<Dim>;
  Box box{};
  for (int k = 0; k < Dim; ++k) box.low[k] = INT64_MAX, box.high[k] = -1;
  box = on.reduce(
      p.count, box,
      [=] HOST_DEVICE(Index i) {
        Box b{};
        const auto cell = cell_of<Dim>(lattice, records[i].place, 0);
        for (int k = 0; k < Dim; ++k) b.low[k] = b.high[k] = cell[k];
        return b;
      },
      [] HOST_DEVICE(Box a, const Box& b) {
        for (int k = 0; k < Dim; ++k) {
          a.low[k] = a.low[k] < b.low[k] ? a.low[k] : b.low[k];
          a.high[k] = a.high[k] > b.high[k] ? a.high[k] : b.high[k];
        }
        return a;
      });
  for (int k = 0; k < Dim; ++k) {
    table.period[k] = lattice.periodic[k] ? lattice.cells[k] : 0;
    table.low[k] = box.low[k];
    table.extent[k] = box.high[k] - box.low[k] + 1;
  }
  const std::int64_t n = table.size();
  for (int s = 0; s < 2; ++s) {
    on.fill(cells.begin[s], static_cast<std::size_t>(n), Index{0});
    on.fill(cells.end[s], static_cast<std::size_t>(n), Index{0});
    table.begin[s] = cells.begin[s].data();
    table.end[s] = cells.end[s].data();
  }
  Index* begins[2] = {cells.begin[0].data(), cells.begin[1].data()};
  Index* ends[2] = {cells.end[0].data(), cells.end[1].data()};
  const Index fluid = p.fluid_count;
  const Index count = p.count;
  const auto number = [=] HOST_DEVICE(Index i) {
    const auto cell = cell_of<Dim>(lattice, records[i].place, 0);
    Vec<Dim, std::int64_t> c{};
    for (int k = 0; k < Dim; ++k) c[k] = cell[k];
    return table.number(c);
  };
  on.for_each(count, [=] HOST_DEVICE(Index i) {
    const int s = i < fluid ? 0 : 1;
    const std::int64_t c = number(i);
    if (i == 0 || i == fluid || number(i - 1) != c) begins[s][c] = i;
    if (i + 1 == fluid || i + 1 == count || number(i + 1) != c) ends[s][c] = i + 1;
  });
  return cells;
}

/// Makes the lists for the particles in their present order and places.
template <int Dim, class Device>
void build_lists(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  const Cells<Dim, Device> cells = fill_cells<Dim>(on, p, scene);
  const auto reach = static_cast<float>(scene.list_reach);
  typename Device::template Buffer<std::int32_t> places[Dim];
  ClusterSearch<Dim, Device> search{cells.table, scene.lattice, p.record.data(), {}, reach * reach};
  for (int k = 0; k < Dim; ++k) {
    places[k].resize(p.count + filter_overrun);
    search.places[k] = places[k].data();
    std::int32_t* to = places[k].data();
    const Record* from = p.record.data();
    on.for_each(p.count, [=] HOST_DEVICE(Index i) { to[i] = from[i].place[axis<Dim>(k)]; });
  }
  p.fluid_clusters = (p.fluid_count + cluster_size - 1) / cluster_size;
  p.clusters = p.fluid_clusters + (p.count - p.fluid_count + cluster_size - 1) / cluster_size;

  ClusterList list = p.list();
  typename Device::template Buffer<Index> counts;
  counts.resize(p.clusters);
  {
    Index* c = counts.data();
    on.for_each(p.clusters, [=] HOST_DEVICE(Index cluster) {
      Index n = 0;
      search.search(list.first(cluster), list.last(cluster), cluster < list.fluid_clusters ? 2 : 1, Count{n});
      c[cluster] = (n + list_padding - 1) / list_padding * list_padding;
    });
  }
  const Index total = on.exclusive_scan(counts, p.list_begin);
  p.list_entries.resize(std::size_t{total} + std::size_t{2} * list_prefetch);
  list = p.list();

  constexpr std::uint8_t reaches_sediment = 1, reaches_water = 2, has_sediment = 4;
  typename Device::template Buffer<std::uint8_t> about;
  typename Device::template Buffer<std::uint8_t> phase;  // a byte a particle, where a record is a line of the cache
  about.resize(p.clusters);
  if (scene.has_sediment) {
    phase.resize(p.count + filter_overrun);
    const Record* records = p.record.data();
    std::uint8_t* to = phase.data();
    on.for_each(p.count, [=] HOST_DEVICE(Index i) {
      const float is = records[i].phase;
      to[i] = is == phase_sediment ? reaches_sediment : is == phase_water ? reaches_water : std::uint8_t{0};
    });
  }
  {
    Index* entries = p.list_entries.data();
    std::uint8_t* flags = about.data();
    const std::uint8_t* reaches = scene.has_sediment ? phase.data() : nullptr;
    on.for_each(p.clusters, [=] HOST_DEVICE(Index cluster) {
      Index at = list.begin[cluster];
      std::uint8_t f = 0;
      search.search(list.first(cluster), list.last(cluster), cluster < list.fluid_clusters ? 2 : 1,
                    Write{entries, at, reaches, f});
      for (Index i = list.first(cluster); reaches != nullptr && i < list.last(cluster); ++i) {
        if (reaches[i] == reaches_sediment) f |= has_sediment;
      }
      for (; at < list.begin[cluster + 1]; ++at) entries[at] = list.count;
      flags[cluster] = f;
    });
    on.for_each(2 * list_prefetch, [=] HOST_DEVICE(Index e) { entries[total + e] = list.count; });
  }

  const std::uint8_t* flags = about.data();
  Selection<Device> selection(on);
  selection.choose(
      p.all_fluid(), [=] HOST_DEVICE(Index c) { return (flags[c] & reaches_sediment) != 0; }, p.clusters_with_sediment);
  selection.choose(
      p.all_fluid(), [=] HOST_DEVICE(Index c) { return (flags[c] & reaches_sediment) == 0; }, p.clusters_of_water);
  if (scene.has_states) {
    constexpr std::uint8_t both = has_sediment | reaches_water;
    selection.choose(
        p.all_fluid(), [=] HOST_DEVICE(Index c) { return (flags[c] & both) == both; }, p.clusters_at_bed_surface);
  }
  const Index fluid_clusters = p.fluid_clusters;
  selection.choose(
      p.clusters - p.fluid_clusters, [=] HOST_DEVICE(Index n) { return fluid_clusters + n; },
      [=] HOST_DEVICE(Index c) { return list.begin[c + 1] > list.begin[c]; }, p.clusters_of_walls);
  selection.finish();
}

/// Whether a particle has left the domain since the lists were made.
template <class Device>
bool has_excluded(Device& on, const Particles<Device>& p) {
  const Record* records = p.record.data();
  return on.reduce(
      p.fluid_count, false, [=] HOST_DEVICE(Index i) { return records[i].volume == 0; },
      [] HOST_DEVICE(bool a, bool b) { return a || b; });
}

/// How far a particle has moved since the lists were made, squared [m^2]; infinite when it was excluded.
template <int Dim>
struct SquaredDrift {
  const Record* records;
  const Place* listed;
  Vec<Dim, float> quantum;
  Index fluid;

  HOST_DEVICE float operator()(Index i) const {
    if (records[i].volume == 0 && i < fluid) return INFINITY;
    float d2 = 0;
    for (int k = 0; k < Dim; ++k) {
      const int c = axis<Dim>(k);
      const float d = static_cast<float>(Lattice<Dim>::difference(records[i].place[c], listed[i].c[c])) * quantum[k];
      d2 += d * d;
    }
    return d2;
  }
};

/// Finds the largest of them, among all that can move.
template <int Dim, class Device>
void find_squared_drift(Device& on, const Particles<Device>& p, const Scene<Dim>& scene, StepState* state) {
  on.reduce_then(
      scene.has_moving_walls ? p.count : p.fluid_count, 0.0F,
      SquaredDrift<Dim>{p.record.data(), p.listed_at.data(), scene.lattice.quantum, p.fluid_count},
      [] HOST_DEVICE(float a, float b) { return a > b ? a : b; },
      [=] HOST_DEVICE(float found) { state->squared_drift = found; });
}

}  // namespace neighbours

/// Whether lists serve no longer when some particle has moved so far [m^2].
template <int Dim>
bool are_worn_out(const Scene<Dim>& scene, float squared_drift) {
  const auto slack = static_cast<float>((scene.list_reach - 2 * scene.smoothing_length) / 2);
  return !(squared_drift < slack * slack);
}

/// Sorts particles and makes the lists anew. Returns what was excluded since the last time.
template <int Dim, class Device>
std::vector<ExcludedParticle> rebuild_lists(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  auto excluded = neighbours::sort_particles(on, p, scene);
  neighbours::build_lists(on, p, scene);
  p.listed_at.resize(p.count);
  const Record* records = p.record.data();
  Place* listed = p.listed_at.data();
  on.for_each(p.count, [=] HOST_DEVICE(Index i) {
    for (int k = 0; k < 3; ++k) listed[i].c[k] = records[i].place[k];
  });
  return excluded;
}

}  // namespace thalweg
