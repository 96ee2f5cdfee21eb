#pragma once

#include <cmath>

#include "solver/lists/cells.hpp"
#include "solver/state/step_state.hpp"

// The life of the neighbour lists. A list misses a neighbour once two particles have come nearer to each other by the skin.
// Neighbours move alike, so their displacements are compared within blocks of the domain: the lists serve until two
// particles of a neighbourhood differ by the skin, or one has moved by the skin itself, which covers the fixed walls and
// particles from further apart.
namespace thalweg {

namespace neighbours {

/// True if a particle has left the domain since the lists were made. Those that died on purpose do not count.
template <class Device>
bool has_excluded(Device& on, const Particles<Device>& p) {
  const Record* records = p.record.data();
  const Role* roles = p.roles();
  return on.reduce(p.fluid_count, false, declare<Reads<field::place, field::role>, Writes<>>([=] HOST_DEVICE(Index i) {
                     return records[i].volume == 0 && (roles == nullptr || roles[i] != Role::dormant);
                   }),
                   [] HOST_DEVICE(bool a, bool b) { return a || b; });
}

/// The blocks over the box of occupied list cells. On several ranks they reach into those of the other ranks, whose
/// displacements this one compares with its own.
template <int Dim>
DriftBlocks drift_blocks_over(const CellTable<Dim>& cells, bool shared) {
  DriftBlocks blocks;
  for (int k = 0; k < Dim; ++k) {
    blocks.low[k] = cells.low[k] / 2;
    blocks.extent[k] = (cells.low[k] + cells.extent[k] - 1) / 2 - blocks.low[k] + 1;
    blocks.set_period(k, cells.period[k]);
    if (!shared) continue;
    blocks.low[k] -= blocks.around[k];
    blocks.extent[k] += 2 * blocks.around[k];
    const bool wraps = blocks.low[k] < 0 || blocks.low[k] + blocks.extent[k] > blocks.period[k];
    if (blocks.period[k] != 0 && wraps) blocks.low[k] = 0, blocks.extent[k] = blocks.period[k];
  }
  return blocks;
}

/// Notes which particles lie in each list cell, block by block, when lists are made.
template <int Dim, class Device>
void fill_drift_blocks(Device& on, Particles<Device>& p, const CellTable<Dim>& cells) {
  const DriftBlocks blocks = drift_blocks_over(cells, on.shared != nullptr);
  constexpr Index parts = 1U << Dim;
  p.drift_blocks = blocks;
  p.drift_of_block.resize(blocks.count());
  p.drift_of_cell.resize(std::size_t{blocks.count()} * parts);
  p.drift_cells.resize(std::size_t{blocks.count()} * parts);
  DriftCell* to = p.drift_cells.data();
  on.for_each(blocks.count() * parts, declare<Reads<>, Writes<>>([=] HOST_DEVICE(Index n) {
                Vec<Dim, std::int64_t> cell{};
                std::int64_t block = n / parts;
                bool is_inside = true;
                for (int k = 0; k < Dim; ++k) {
                  cell[k] = 2 * (blocks.low[k] + block % blocks.extent[k]) + (n % parts >> k & 1);
                  block /= blocks.extent[k];
                  is_inside = is_inside && (cells.period[k] == 0 || cell[k] < cells.period[k]);
                }
                const std::int64_t c = is_inside ? cells.number(cell) : -1;
                DriftCell found{{0, 0}, {0, 0}};
                for (int s = 0; c >= 0 && s < 2; ++s) {
                  const int own = cells.own(s == 1);
                  found.begin[s] = cells.begin[own][c], found.end[s] = cells.end[own][c];
                }
                to[n] = found;
              }));
}

/// Finds the box of the displacements of the particles that lay in a list cell.
template <int Dim>
struct CellDrift {
  using reads = Reads<field::place, field::listed_at, field::role>;
  using writes = Writes<>;

  const Record* records;
  const Place* listed;
  const Role* roles;
  Vec<Dim, float> quantum;
  const DriftCell* cells;
  int sections;  // 2: walls move too
  DriftBox* to;

  HOST_DEVICE void operator()(Index n) const {
    DriftBox box;
    for (int s = 0; s < sections; ++s) {
      for (Index i = cells[n].begin[s]; i < cells[n].end[s]; ++i) {
        if (s == 0 && records[i].volume == 0) {
          if (roles == nullptr || roles[i] != Role::dormant) box.squared = INFINITY;
          continue;
        }
        box.add(displacement(i));
      }
    }
    to[n] = box;
  }

  [[nodiscard]] HOST_DEVICE DriftBox displacement(Index i) const {
    DriftBox one;
    one.squared = 0;
    for (int k = 0; k < Dim; ++k) {
      const int c = axis<Dim>(k);
      const float d = static_cast<float>(Lattice<Dim>::difference(records[i].place[c], listed[i].c[c])) * quantum[k];
      one.low[k] = one.high[k] = d;
      one.squared += d * d;
    }
    return one;
  }
};

/// Half the largest difference between displacements around a block, or half the largest displacement there if that is
/// more; its square [m^2].
template <int Dim>
struct NeighbourhoodDrift {
  using reads = Reads<>;
  using writes = Writes<>;

  DriftBlocks blocks;
  const DriftBox* of_block;

  HOST_DEVICE float operator()(Index n) const {
    if (of_block[n].squared < 0) return 0;
    std::int64_t at[3];
    std::int64_t rest = n;
    for (int k = 0; k < 3; ++k) {
      at[k] = rest % blocks.extent[k];
      rest /= blocks.extent[k];
    }
    DriftBox all = of_block[n];
    for (std::int64_t z = -blocks.around[2]; z <= blocks.around[2]; ++z) {
      const std::int64_t in_z = along(2, at[2] + z);
      for (std::int64_t y = -blocks.around[1]; in_z >= 0 && y <= blocks.around[1]; ++y) {
        const std::int64_t in_y = along(1, at[1] + y);
        for (std::int64_t x = -blocks.around[0]; in_y >= 0 && x <= blocks.around[0]; ++x) {
          const std::int64_t in_x = along(0, at[0] + x);
          if (in_x >= 0) all.add(of_block[(in_z * blocks.extent[1] + in_y) * blocks.extent[0] + in_x]);
        }
      }
    }
    float apart2 = 0;
    for (int k = 0; k < Dim; ++k) apart2 += (all.high[k] - all.low[k]) * (all.high[k] - all.low[k]);
    return (apart2 > all.squared ? apart2 : all.squared) / 4;
  }

  /// Number of a block along a direction; -1 where there is none.
  [[nodiscard]] HOST_DEVICE std::int64_t along(int k, std::int64_t at) const {
    if (blocks.period[k] != 0) {
      at = (at + blocks.low[k] + 2 * blocks.period[k]) % blocks.period[k] - blocks.low[k];
    }
    return at >= 0 && at < blocks.extent[k] ? at : -1;
  }
};

/// Finds how far particles have drifted since the lists were made; walls only if they move.
template <int Dim, class Device>
void find_squared_drift(Device& on, Particles<Device>& p, const Scene<Dim>& scene, StepState* state) {
  constexpr Index parts = 1U << Dim;
  const DriftBlocks blocks = p.drift_blocks;
  DriftBox* of_cell = p.drift_of_cell.data();
  DriftBox* of_block = p.drift_of_block.data();
  on.for_each(blocks.count() * parts,
              CellDrift<Dim>{p.record.data(), p.listed_at.data(), p.roles(), scene.lattice.quantum,
                             p.drift_cells.data(), scene.walls_move ? 2 : 1, of_cell});
  on.for_each(blocks.count(), declare<Reads<>, Writes<>>([=] HOST_DEVICE(Index n) {
                DriftBox box;
                for (Index part = 0; part < parts; ++part) box.add(of_cell[n * parts + part]);
                of_block[n] = box;
              }));
  on.share_drift(blocks, p.drift_of_block);
  on.reduce_then(
      blocks.count(), 0.0F, NeighbourhoodDrift<Dim>{blocks, of_block},
      [] HOST_DEVICE(float a, float b) { return a > b ? a : b; },
      [=] HOST_DEVICE(float found) { state->squared_drift = found; });
}

}  // namespace neighbours

/// True once the drift is half the skin [m^2]: two particles may have come nearer to each other by the skin.
template <int Dim>
bool must_rebuild_lists(const Scene<Dim>& scene, float squared_drift) {
  const auto slack = static_cast<float>((scene.list_reach - 2 * scene.smoothing_length) / 2);
  return !(squared_drift < slack * slack);
}

}  // namespace thalweg
