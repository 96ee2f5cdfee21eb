#pragma once

#include <cstdint>

#include "solver/backend/device.hpp"
#include "solver/state/particles.hpp"
#include "solver/state/scene.hpp"

// The list cells: the domain cut into boxes one list reach wide, and the particles in each.
namespace thalweg::neighbours {

template <int Dim>
HOST_DEVICE inline Vec<Dim, std::uint32_t> cell_of(const Lattice<Dim>& lattice, const std::int32_t* place, int bits) {
  Vec<Dim, std::uint32_t> cell{};
  for (int k = 0; k < Dim; ++k) {
    cell[k] = Lattice<Dim>::part(place[axis<Dim>(k)], static_cast<std::uint64_t>(lattice.cells[k]) << bits);
  }
  return cell;
}

/// The particles of a list cell lie in so many ranges at most: fluid and walls; on several ranks those of the ranks
/// before, this rank's, and those of the ranks behind.
inline constexpr int most_sections = 6;

/// First and last particle of each list cell, over the box of occupied cells. In the order of the sections and the cells'
/// places in the lists, whatever rank has them.
template <int Dim>
struct CellTable {
  Vec<Dim, std::int64_t> low{};
  Vec<Dim, std::int64_t> extent{};
  Vec<Dim, std::int64_t> period{};  // cells once around, 0 where the direction is not periodic
  int sections = 2;                 // fluid first, walls in the second half
  const Index* begin[most_sections];
  const Index* end[most_sections];

  /// The section of this rank's fluid, or of its walls.
  [[nodiscard]] HOST_DEVICE int own(bool walls) const { return sections / 4 + (walls ? sections / 2 : 0); }

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

template <int Dim, class Device>
struct Cells {
  CellTable<Dim> table;
  typename Device::template Buffer<Index> begin[most_sections];
  typename Device::template Buffer<Index> end[most_sections];
};

/// The particles of the sections: from[s] to from[s] + count[s].
struct Sections {
  int number = 2;
  Index from[most_sections] = {};
  Index count[most_sections] = {};

  template <class Device>
  explicit Sections(const Particles<Device>& p) {
    const HaloParts& h = p.copies;
    const Index walls = p.count - p.fluid_count;
    const Index behind[] = {p.count, p.count + h.fluid_before};
    const Index walls_behind[] = {behind[1] + h.fluid_behind, behind[1] + h.fluid_behind + h.walls_before};
    if (h.count() == 0) {
      from[1] = count[0] = p.fluid_count;
      count[1] = walls;
      return;
    }
    number = 6;
    const Index all[6][2] = {{behind[0], h.fluid_before}, {0, p.fluid_count},
                             {behind[1], h.fluid_behind}, {walls_behind[0], h.walls_before},
                             {p.fluid_count, walls},      {walls_behind[1], h.walls_behind}};
    for (int s = 0; s < 6; ++s) from[s] = all[s][0], count[s] = all[s][1];
  }

  /// The section in which a particle lies.
  [[nodiscard]] HOST_DEVICE int of(Index i) const {
    int s = 0;
    while (i - from[s] >= count[s]) ++s;  // unsigned: a particle before the section counts as far behind it
    return s;
  }
};

/// Begins and ends of the list cells, to be written.
struct SectionEnds {
  Index* begin[most_sections];
  Index* end[most_sections];
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
  const Index all = p.with_copies();
  box = on.reduce_here(all, box, declare<Reads<field::place>, Writes<>>([=] HOST_DEVICE(Index i) {
                         Box b{};
                         const auto cell = cell_of<Dim>(lattice, records[i].place, 0);
                         for (int k = 0; k < Dim; ++k) b.low[k] = b.high[k] = cell[k];
                         return b;
                       }),
                       [] HOST_DEVICE(Box a, const Box& b) {
                         for (int k = 0; k < Dim; ++k) {
                           a.low[k] = a.low[k] < b.low[k] ? a.low[k] : b.low[k];
                           a.high[k] = a.high[k] > b.high[k] ? a.high[k] : b.high[k];
                         }
                         return a;
                       });
  for (int k = 0; all == 0 && k < Dim; ++k) box.low[k] = 0;  // a rank without particles: no cells
  for (int k = 0; k < Dim; ++k) {
    table.period[k] = lattice.periodic[k] ? lattice.cells[k] : 0;
    table.low[k] = box.low[k];
    table.extent[k] = box.high[k] - box.low[k] + 1;
  }
  const std::int64_t n = table.size();
  const Sections sections(p);
  table.sections = sections.number;
  SectionEnds to{};
  for (int s = 0; s < sections.number; ++s) {
    on.fill(cells.begin[s], static_cast<std::size_t>(n), Index{0});
    on.fill(cells.end[s], static_cast<std::size_t>(n), Index{0});
    table.begin[s] = to.begin[s] = cells.begin[s].data();
    table.end[s] = to.end[s] = cells.end[s].data();
  }
  const auto number = [=] HOST_DEVICE(Index i) {
    const auto cell = cell_of<Dim>(lattice, records[i].place, 0);
    Vec<Dim, std::int64_t> c{};
    for (int k = 0; k < Dim; ++k) c[k] = cell[k];
    return table.number(c);
  };
  on.for_each(all, declare<Neighbours<field::place>, Reads<>, Writes<>>([=] HOST_DEVICE(Index i) {
                const int s = sections.of(i);
                const std::int64_t c = number(i);
                const Index last = sections.from[s] + sections.count[s] - 1;
                if (i == sections.from[s] || number(i - 1) != c) to.begin[s][c] = i;
                if (i == last || number(i + 1) != c) to.end[s][c] = i + 1;
              }));
  return cells;
}

}  // namespace thalweg::neighbours
