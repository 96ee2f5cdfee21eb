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

/// First and last particle of each list cell, over the box of occupied cells.
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
  box = on.reduce(p.count, box, declare<Reads<field::place>, Writes<>>([=] HOST_DEVICE(Index i) {
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
  on.for_each(count, declare<Neighbours<field::place>, Reads<>, Writes<>>([=] HOST_DEVICE(Index i) {
                const int s = i < fluid ? 0 : 1;
                const std::int64_t c = number(i);
                if (i == 0 || i == fluid || number(i - 1) != c) begins[s][c] = i;
                if (i + 1 == fluid || i + 1 == count || number(i + 1) != c) ends[s][c] = i + 1;
              }));
  return cells;
}

}  // namespace thalweg::neighbours
