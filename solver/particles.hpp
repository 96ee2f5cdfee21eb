#pragma once

#include <cstdint>

#include "solver/cluster_list.hpp"
#include "solver/scene.hpp"

namespace thalweg {

/// Position proper; places in the records follow it.
struct Position {
  double x[3];  // [m]
};

/// A record's place alone [quanta].
struct Place {
  std::int32_t c[3];
};

/// What the last sweeps found for a particle.
struct Rates {
  float acceleration[3];  // [m/s^2] without the implicit part
  float excess_rate;      // d(rho/rho0)/dt [1/s]
};

/// What is known of a particle beside its record in a scene with sediment; index by particle, empty without sediment.
struct Sediment {
  float strain_rate;              // gdot = sqrt(2 D:D) [1/s]
  float effective_pressure;       // [Pa]
  float yield_stress;             // [Pa]
  float viscous_acceleration[3];  // of the last implicit solve [m/s^2], where the next one starts
};

/// All particles on a device, in the order of the neighbour lists: fluid first, walls after, one zero-volume record
/// last.
template <class Device>
struct Particles {
  template <class T>
  using Buffer = typename Device::template Buffer<T>;

  Index count = 0;
  Index fluid_count = 0;

  Buffer<Record> record;  // count + 1
  Buffer<Position> position;
  Buffer<float> mass;  // [kg]
  Buffer<std::int64_t> id;
  Buffer<std::uint8_t> type;
  Buffer<Rates> rates;
  Buffer<Sediment> sediment;
  Buffer<float> excess_pore_pressure;  // [Pa] of sediment; empty unless scene.seepage.pore_pressure

  // Neighbour lists (passes/neighbours.hpp) and the places they were built for.
  Buffer<Place> listed_at;  // empty: no list yet
  Buffer<Index> list_begin;
  Buffer<Index> list_entries;
  Buffer<Index> clusters_with_sediment;  // fluid clusters with sediment in or within reach
  Buffer<Index> clusters_of_walls;       // wall clusters with fluid in reach
  Buffer<Index> clusters_of_water;       // fluid clusters that are not in clusters_with_sediment
  Index fluid_clusters = 0;
  Index clusters = 0;

  [[nodiscard]] ClusterList list() const {
    return {list_begin.data(), list_entries.data(), fluid_clusters, clusters, fluid_count, count};
  }
  [[nodiscard]] ClusterRange all_fluid() const { return {nullptr, fluid_clusters}; }
  [[nodiscard]] ClusterRange near_sediment() const { return range(clusters_with_sediment); }
  [[nodiscard]] ClusterRange pure_water() const { return range(clusters_of_water); }
  [[nodiscard]] ClusterRange walls_near_fluid() const { return range(clusters_of_walls); }

 private:
  static ClusterRange range(const Buffer<Index>& clusters) {
    return {clusters.data(), static_cast<Index>(clusters.size())};
  }
};

}  // namespace thalweg
