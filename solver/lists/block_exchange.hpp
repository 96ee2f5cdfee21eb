#pragma once

#include <vector>

#include "solver/lists/cells_between.hpp"
#include "solver/state/drift_blocks.hpp"

namespace thalweg::neighbours {

/// The boxes of displacements (drift.hpp) of blocks that other ranks compare with theirs.
template <int Dim>
class BlockExchange {
 public:
  /// Finds which of this rank's blocks lie near each other rank's.
  void start(Ranks& ranks, const OwnCells<Dim>& own, const Lattice<Dim>& lattice) {
    const auto cells_around = periods_of(lattice);
    DriftBlocks whole;
    Vec<Dim, std::int64_t> period{};
    Vec<Dim, std::int64_t> around{};
    for (int k = 0; k < Dim; ++k) {
      whole.set_period(k, cells_around[k]);
      period[k] = whole.period[k];
      around[k] = whole.around[k];
    }
    std::vector<std::uint64_t> blocks;
    BoxOfCells<Dim> box;
    for (const auto* runs : {&own.fluid, &own.walls}) {
      for (const auto& run : *runs) {
        auto block = unpacked_cell<Dim>(run.cell);
        for (int k = 0; k < Dim; ++k) block[k] /= 2;
        box.add(block);
        blocks.push_back(packed_cell<Dim>(block));
      }
    }
    std::sort(blocks.begin(), blocks.end());
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
    const auto boxes = gather_from(ranks, box);
    std::vector<Bytes> to(boxes.size());
    mine_.assign(boxes.size(), {});
    theirs_.assign(boxes.size(), {});
    for (std::size_t r = 0; r < boxes.size(); ++r) {
      if (static_cast<int>(r) == ranks.rank()) continue;
      for (const std::uint64_t block : blocks) {
        if (boxes[r].is_near(unpacked_cell<Dim>(block), period, around)) mine_[r].push_back(block);
      }
      append_to(to[r], mine_[r].data(), mine_[r].size());
    }
    const auto from = exchange_any(ranks, to);
    for (std::size_t r = 0; r < from.size(); ++r) {
      theirs_[r].resize(from[r].size() / sizeof(std::uint64_t));
      MessageReader(from[r]).read(theirs_[r].data(), theirs_[r].size());
    }
  }

  /// Adds the others' boxes to this rank's.
  void merge(Ranks& ranks, const DriftBlocks& blocks, DriftBox* of_block) const {
    const std::size_t n = mine_.size();
    std::vector<std::vector<DriftBox>> out(n);
    std::vector<std::vector<DriftBox>> in(n);
    std::vector<std::span<const std::byte>> to(n);
    std::vector<std::span<std::byte>> from(n);
    for (std::size_t r = 0; r < n; ++r) {
      for (const std::uint64_t block : mine_[r]) {
        const std::int64_t at = number(blocks, block);
        out[r].push_back(at < 0 ? DriftBox{} : of_block[at]);
      }
      in[r].resize(theirs_[r].size());
      to[r] = std::as_bytes(std::span(out[r]));
      from[r] = std::as_writable_bytes(std::span(in[r]));
    }
    ranks.exchange(to, from);
    for (std::size_t r = 0; r < n; ++r) {
      for (std::size_t b = 0; b < in[r].size(); ++b) {
        const std::int64_t at = number(blocks, theirs_[r][b]);
        if (at >= 0) of_block[at].add(in[r][b]);
      }
    }
  }

 private:
  /// A block's number in this rank's table, or -1 beyond it.
  static std::int64_t number(const DriftBlocks& blocks, std::uint64_t packed) {
    const auto block = unpacked_cell<Dim>(packed);
    std::int64_t n = 0;
    for (int k = Dim - 1; k >= 0; --k) {
      std::int64_t at = block[k] - blocks.low[k];
      if (blocks.period[k] != 0) at = (at + 2 * blocks.period[k]) % blocks.period[k];
      if (at < 0 || at >= blocks.extent[k]) return -1;
      n = n * blocks.extent[k] + at;
    }
    return n;
  }

  std::vector<std::vector<std::uint64_t>> mine_;    // blocks of which each other rank hears
  std::vector<std::vector<std::uint64_t>> theirs_;  // blocks of which each other rank tells
};

}  // namespace thalweg::neighbours
