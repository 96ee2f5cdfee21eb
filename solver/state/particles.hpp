#pragma once

#include <cstdint>

#include "solver/state/arrays.hpp"
#include "solver/state/cluster_list.hpp"
#include "solver/state/drift_blocks.hpp"
#include "solver/state/halo_parts.hpp"
#include "solver/state/report.hpp"

namespace thalweg {

/// A record's place alone [quanta].
struct Place {
  std::int32_t c[3];
};

/// Who moves a particle. A scene without births and deaths has no roles: all its particles are integrated.
enum class Role : std::uint8_t {
  integrated,  // the equations of motion
  prescribed,  // its own velocity, which nothing changes; its density stays too
  dormant      // nothing: it has no volume and leaves the arrays when the lists are made anew
};

/// Rates of a particle, as the last sweeps found them.
struct Rates {
  float acceleration[3];  // [m/s^2] without the implicit part
  float excess_rate;      // d(rho/rho0)/dt [1/s]
};

/// The arrays that every scene has, and the neighbour lists over them (lists/). Particles stand in the order of the
/// lists: fluid first, walls after; then, where the scene lies on several ranks, copies of particles that other ranks
/// have; one record of zero volume last.
template <class Device>
struct ParticleCore {
  template <class T>
  using Buffer = typename Device::template Buffer<T>;

  Index count = 0;
  Index fluid_count = 0;
  HaloParts copies;  // behind them, of particles that other ranks have

  Buffer<Record> record;  // with_copies() + 1
  Buffer<Position> position;
  Buffer<float> mass;         // [kg]
  Buffer<float> loaded_mass;  // [kg] with the grains that water carries; empty where it carries none
  Buffer<std::int64_t> id;
  Buffer<std::uint8_t> type;
  Buffer<Rates> rates;
  Buffer<float> dissipation;  // share of the artificial viscosity that acts [-]; empty without its switch
  bool has_roles = false;     // particles are born or die (domain/population.hpp)
  Buffer<Role> role;          // empty without

  // Neighbour lists and the places they were built for.
  Buffer<Place> listed_at;
  bool walls_sorted = false;  // here, once: walls that stand still keep their order
  DriftBlocks drift_blocks;
  Buffer<DriftCell> drift_cells;  // those of a block one after the other
  Buffer<DriftBox> drift_of_cell;
  Buffer<DriftBox> drift_of_block;
  Buffer<Index> list_begin;
  Buffer<Index> list_entries;
  Buffer<std::uint8_t> cluster_marks;     // lists/cluster_marks.hpp
  Buffer<Index> clusters_with_sediment;   // fluid clusters with sediment in or within reach
  Buffer<Index> clusters_of_walls;        // wall clusters with fluid in reach
  Buffer<Index> clusters_of_water;        // fluid clusters that are not in clusters_with_sediment
  Buffer<Index> clusters_near_walls;      // fluid clusters with walls in reach; empty unless scene.needs_near_walls
  Buffer<Index> clusters_at_bed_surface;  // fluid clusters that have sediment, and water in reach

  // If some sediment rests (models/rest): the part of those clusters that has to be computed.
  bool any_resting = false;
  Buffer<Index> clusters_active;           // of clusters_with_sediment: some member does not rest
  Buffer<Index> clusters_rest_front;       // of clusters_with_sediment: all members rest, something active in reach
  Buffer<Index> clusters_part_resting;     // of clusters_active: some member rests
  Buffer<Index> clusters_of_walls_active;  // of clusters_of_walls: something active in reach

  Index fluid_clusters = 0;
  Index clusters = 0;

  /// The record, which ends with one more than there are particles, is described by whoever resizes it.
  template <class Scene, class Visitor>
  void describe(const Scene& scene, Visitor& v) {
    v.array(field::position, position, sorted | halo, Position{});
    v.array(field::mass, mass, sorted | halo, 0.0F);
    if (scene.water_has_grains) v.array(field::loaded_mass, loaded_mass, sorted | checkpointed | halo, 0.0F);
    v.array(field::id, id, sorted, std::int64_t{0});
    v.array(field::type, type, sorted, std::uint8_t{0});
    v.array(field::rates, rates, sorted | checkpointed, Rates{});
    if (scene.viscosity_switch) v.array(field::dissipation, dissipation, sorted | checkpointed, 1.0F);
    if (has_roles) v.array(field::role, role, sorted | checkpointed, Role::integrated);
  }

  /// The masses that forces accelerate [kg].
  [[nodiscard]] const float* inertia() const { return loaded_mass.size() == 0 ? mass.data() : loaded_mass.data(); }
  /// nullptr where all particles are integrated.
  [[nodiscard]] const Role* roles() const { return has_roles ? role.data() : nullptr; }
  /// nullptr where all of the artificial viscosity acts.
  [[nodiscard]] float* dissipations() { return dissipation.size() == 0 ? nullptr : dissipation.data(); }
  [[nodiscard]] const float* dissipations() const { return dissipation.size() == 0 ? nullptr : dissipation.data(); }
  [[nodiscard]] ClusterList list() const {
    return {list_begin.data(), list_entries.data(),
            fluid_clusters,    clusters,
            fluid_count,       count,
            with_copies(),     copies.count() > 0 ? cluster_marks.data() : nullptr};
  }
  [[nodiscard]] bool has_lists() const { return list_begin.size() != 0; }
  [[nodiscard]] FluidCount fluid() const { return {fluid_count}; }
  [[nodiscard]] Index with_copies() const { return count + copies.count(); }
  [[nodiscard]] ClusterRange all_fluid() const { return {nullptr, fluid_clusters}; }
  [[nodiscard]] ClusterRange near_sediment() const {
    return range(any_resting ? clusters_active : clusters_with_sediment);
  }
  [[nodiscard]] ClusterRange pure_water() const { return range(clusters_of_water); }
  [[nodiscard]] ClusterRange walls_near_fluid() const {
    return range(any_resting ? clusters_of_walls_active : clusters_of_walls);
  }
  [[nodiscard]] ClusterRange near_walls() const { return range(clusters_near_walls); }
  [[nodiscard]] ClusterRange at_bed_surface() const { return range(clusters_at_bed_surface); }
  [[nodiscard]] ClusterRange rest_front() const { return range(clusters_rest_front); }
  [[nodiscard]] ClusterRange part_resting() const { return range(clusters_part_resting); }

  static ClusterRange range(const Buffer<Index>& clusters) {
    return {clusters.data(), static_cast<Index>(clusters.size())};
  }
};

/// All particles of a scene: ParticleCore with the arrays of every model (models/all.hpp).
template <class Device>
struct Particles;

}  // namespace thalweg
