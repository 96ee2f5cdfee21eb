#pragma once

#include <algorithm>
#include <bit>
#include <vector>

#include "solver/lists/cells.hpp"
#include "solver/lists/hilbert.hpp"

// The order of the particles: along a Hilbert curve, fluid before walls, and those that leave the arrays last.
namespace thalweg {

namespace neighbours {

/// A list cell is ordered inside by eighths, so that four in a row lie close together.
inline constexpr int fine_bits = 3;

/// Tells which particles leave the arrays: fluid without volume. A wall without volume stays: it has left the domain and
/// may come back (models/moving_walls), or lies in the ground under a thin bed (models/surface_bed). The type tells them
/// apart, because fluid that has left the domain is of the kind of walls.
struct Gone {
  const Record* records;
  const std::uint8_t* type;

  HOST_DEVICE bool operator()(Index i) const { return records[i].volume == 0 && type[i] >= first_fluid_type; }
  static constexpr std::uint8_t first_fluid_type = 2;  // ParticleType::water
};

/// Counts of the particles that stay, and of the fluid among them.
struct Census {
  Index kept = 0;
  Index fluid = 0;
};

template <class Device>
Census take_census(Device& on, const Particles<Device>& p) {
  const Record* records = p.record.data();
  const Gone gone{records, p.type.data()};
  return on.reduce_here(p.count, Census{},
                        declare<Reads<field::place, field::matter, field::type>, Writes<>>([=] HOST_DEVICE(Index i) {
                          if (gone(i)) return Census{};
                          return Census{1, is_wall(records[i]) ? Index{0} : Index{1}};
                        }),
                        [] HOST_DEVICE(Census a, const Census& b) {
                          return Census{a.kept + b.kept, a.fluid + b.fluid};
                        });
}

/// True if the walls stand where they stood when they were sorted last, behind the same fluid particles.
template <int Dim, class Device>
bool walls_are_sorted(const Particles<Device>& p, const Scene<Dim>& scene, const Census& now) {
  return p.walls_sorted && !scene.has_moving_walls && p.listed_at.size() == p.count && now.kept == p.count &&
         now.fluid == p.fluid_count;
}

/// A particle's position in the order: along the curve, walls after fluid. In large domains eighths of the longest side
/// begin at eighths of the curve's cube, so that planes part a half, a quarter and an eighth of a channel: across those
/// ranks have the fewest neighbours. In between no cell is skipped, or clusters would be less compact.
template <int Dim>
struct HilbertKey {
  const Record* records;
  Lattice<Dim> lattice;
  std::uint32_t longest = 1;  // [cells] side of the domain
  std::uint32_t eighth = 0;   // [cells] of the curve's cube; 0: cells lie there as in the domain
  int bits;

  HilbertKey(const Record* of, const Lattice<Dim>& on) : records(of), lattice(on) {
    std::uint32_t most_cells = 1;
    for (int k = 0; k < Dim; ++k) {
      const std::uint32_t cells = lattice.cells[k];
      most_cells = std::max(most_cells, cells);
      longest = std::max(longest, lattice.periodic[k] ? cells : (cells + 1) / 2);  // of the range the first half
    }
    constexpr std::uint32_t large = 64;
    if (longest >= large) eighth = std::bit_ceil(longest) / 8;
    bits = static_cast<int>(std::bit_width(on_curve(most_cells - 1))) + fine_bits;
  }
  HOST_DEVICE std::uint64_t operator()(Index i) const {
    Vec<Dim, std::uint32_t> cell = cell_of<Dim>(lattice, records[i].place, fine_bits);
    for (int k = 0; k < Dim; ++k) {
      const std::uint32_t inside = cell[k] & ((std::uint32_t{1} << fine_bits) - 1);
      cell[k] = on_curve(cell[k] >> fine_bits) << fine_bits | inside;
    }
    const std::uint64_t along = hilbert_code<Dim>(cell, bits);
    return is_wall(records[i]) ? along | std::uint64_t{1} << (Dim * bits) : along;
  }
  /// The key of a particle that leaves the arrays: behind all others.
  [[nodiscard]] HOST_DEVICE std::uint64_t of_gone(Index i) const {
    return (*this)(i) | std::uint64_t{1} << (Dim * bits + 1);
  }
  /// Bits of a key that can be set.
  [[nodiscard]] int used_bits() const { return Dim * bits + 2; }

 private:
  [[nodiscard]] HOST_DEVICE std::uint32_t on_curve(std::uint32_t cell) const {
    if (eighth == 0) return cell;
    const std::uint32_t part = cell * 8 / longest;
    return part * eighth + cell - (part * longest + 7) / 8;
  }
};

/// True if the particles stand in the order of their list cells, which the search for neighbours relies on.
template <int Dim, class Device>
bool are_in_order(Device& on, const Particles<Device>& p, const Scene<Dim>& scene) {
  const HilbertKey<Dim> key(p.record.data(), scene.lattice);
  return on.reduce_here(p.count, true,
                        declare<Neighbours<field::place, field::matter>, Reads<>, Writes<>>(
                            [=] HOST_DEVICE(Index i) { return i == 0 || key(i - 1) <= key(i); }),
                        [] HOST_DEVICE(bool a, bool b) { return a && b; });
}

/// The new order of the first n particles: all of them, or the fluid.
template <int Dim, class Device>
typename Device::template Buffer<Index> hilbert_order(Device& on, const Particles<Device>& p, const Scene<Dim>& scene,
                                                      Index n) {
  typename Device::template Buffer<std::uint64_t> keys;
  typename Device::template Buffer<Index> order;
  keys.resize(n);
  order.resize(n);
  const HilbertKey<Dim> key(p.record.data(), scene.lattice);
  const Gone gone{p.record.data(), p.type.data()};
  std::uint64_t* k = keys.data();
  Index* o = order.data();
  on.for_each(n, declare<Reads<field::place, field::matter, field::type>, Writes<>>([=] HOST_DEVICE(Index i) {
                k[i] = gone(i) ? key.of_gone(i) : key(i);
                o[i] = i;
              }));
  on.sort_by_key(keys, order, key.used_bits());
  return order;
}

/// The particles [from, p.count) as excluded ones, but for those that died on purpose (Role::dormant).
template <class Device>
std::vector<ExcludedParticle> excluded_behind(Device& on, const Particles<Device>& p, Index from) {
  std::vector<ExcludedParticle> excluded;
  const auto records = on.download(p.record, from, p.count);
  const auto ids = on.download(p.id, from, p.count);
  const auto types = on.download(p.type, from, p.count);
  const auto positions = on.download(p.position, from, p.count);
  const auto masses = on.download(p.mass, from, p.count);
  const bool has_roles = p.roles() != nullptr;
  const auto roles = on.download(p.role, has_roles ? from : 0, has_roles ? p.count : 0);
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (has_roles && roles[i] == Role::dormant) continue;
    const Record& r = records[i];
    excluded.push_back({ids[i], types[i], positions[i], {r.velocity[0], r.velocity[1], r.velocity[2]}, masses[i]});
  }
  return excluded;
}

/// Sorts all arrays that follow their particles and cuts off those that leave. Returns the excluded ones.
template <int Dim, class Device>
std::vector<ExcludedParticle> sort_particles(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  const Census census = take_census(on, p);
  const auto order = hilbert_order(on, p, scene, walls_are_sorted(p, scene, census) ? census.fluid : p.count);
  const auto reorder = [&](auto& buffer) {
    std::remove_reference_t<decltype(buffer)> spare;
    on.reorder(buffer, order, spare);
  };
  reorder(p.record);
  EachArray sort(sorted, [&](const Field&, auto& buffer, const auto&) { reorder(buffer); });
  p.describe(scene, sort);

  const Index end = census.kept;
  std::vector<ExcludedParticle> excluded;
  if (end < p.count) {
    excluded = excluded_behind(on, p, end);
    p.record.resize(end + 1);
    on.write(Record{}, p.record.data() + end);
    EachArray truncate(sorted, [&](const Field&, auto& buffer, const auto&) { buffer.resize(end); });
    p.describe(scene, truncate);
  }
  p.count = end;
  p.fluid_count = census.fluid;
  p.walls_sorted = true;
  return excluded;
}

}  // namespace neighbours

}  // namespace thalweg
