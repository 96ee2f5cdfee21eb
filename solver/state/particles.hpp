#pragma once

#include <cstdint>
#include <vector>

#include "solver/state/cluster_list.hpp"
#include "solver/state/scene.hpp"

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
  float lode_sine;                // of three Lode angles of the rate of strain [-]; 0 in the plane
  float effective_pressure;       // [Pa]
  float yield_stress;             // [Pa]
  float bed_slope;                // tangent of the slope of the bed's surface above or below [-]
  float calm;                     // for how long it has been below yield and slow [s] (models/rest/rest.hpp)
  float viscous_acceleration[3];  // of the last implicit solve [m/s^2], where the next one starts
};

/// What the sediment's surface is like around a particle; kept only where sediment has states, zero where no water is
/// in reach (models/states/bed_states.hpp).
struct BedSurface {
  float fill;               // sum over sediment of V W, 1 inside a bed [-]
  float concentration;      // share of the sediment in the fluid volume within the support [-]
  float normal[3];          // out of the bed, unit
  float water_share;        // sum over water of V W [-]
  float water_velocity[3];  // mean of the water in reach [m/s]
  float water_height;       // of that water over the surface, along the normal [m]
  float bed_velocity[3];    // mean of the deposits in reach, 0 without [m/s]
  float settled_share;      // sum over sediment that is not suspended of V W, itself left out [-]
  float shear_stress;       // tau_b [Pa]
  float critical_stress;    // tau_b at which this grain starts to move [Pa]
  float calm;               // for how long the grain could have become a deposit again [s]
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
  Buffer<BedSurface> bed;              // empty unless sediment has states
  Buffer<std::uint8_t> stopping;       // scratch of models/rest/rest.hpp; empty unless sediment may rest
  Buffer<float> excess_pore_pressure;  // [Pa] of sediment; empty unless scene.seepage.pore_pressure
  Buffer<Index> motion;                // number of the motion, 0: stands still; empty unless scene.has_moving_walls
  Buffer<Position> moved_from;         // where it stood at t = 0; empty unless scene.has_moving_walls

  // Neighbour lists (lists/neighbours.hpp) and the places they were built for.
  Buffer<Place> listed_at;  // empty: no list yet
  Buffer<Index> list_begin;
  Buffer<Index> list_entries;
  Buffer<Index> clusters_with_sediment;   // fluid clusters with sediment in or within reach
  Buffer<Index> clusters_of_walls;        // wall clusters with fluid in reach
  Buffer<Index> clusters_of_water;        // fluid clusters that are not in clusters_with_sediment
  Buffer<Index> clusters_at_bed_surface;  // fluid clusters that have sediment, and water in reach

  // Where some sediment rests (models/rest/rest.hpp), the part of those that has to be computed.
  bool any_resting = false;
  Buffer<Index> clusters_active;           // of clusters_with_sediment: some member does not rest
  Buffer<Index> clusters_shore;            // of clusters_with_sediment: all members rest, something active in reach
  Buffer<Index> clusters_part_resting;     // of clusters_active: some member rests
  Buffer<Index> clusters_of_walls_active;  // of clusters_of_walls: something active in reach

  Index fluid_clusters = 0;
  Index clusters = 0;

  [[nodiscard]] ClusterList list() const {
    return {list_begin.data(), list_entries.data(), fluid_clusters, clusters, fluid_count, count};
  }
  [[nodiscard]] ClusterRange all_fluid() const { return {nullptr, fluid_clusters}; }
  [[nodiscard]] ClusterRange near_sediment() const {
    return range(any_resting ? clusters_active : clusters_with_sediment);
  }
  [[nodiscard]] ClusterRange pure_water() const { return range(clusters_of_water); }
  [[nodiscard]] ClusterRange walls_near_fluid() const {
    return range(any_resting ? clusters_of_walls_active : clusters_of_walls);
  }
  [[nodiscard]] ClusterRange at_bed_surface() const { return range(clusters_at_bed_surface); }
  [[nodiscard]] ClusterRange shore() const { return range(clusters_shore); }
  [[nodiscard]] ClusterRange part_resting() const { return range(clusters_part_resting); }

 private:
  static ClusterRange range(const Buffer<Index>& clusters) {
    return {clusters.data(), static_cast<Index>(clusters.size())};
  }
};

/// Calls body(i) for every particle of the clusters in range.
template <class Device, class Body>
void for_each_member(Device& on, const ClusterList& list, ClusterRange range, const Body& body) {
  on.for_each(range.count * cluster_size, [=] HOST_DEVICE(Index n) {
    const Index c = range[n / cluster_size];
    const Index i = list.first(c) + n % cluster_size;
    if (i < list.last(c)) body(i);
  });
}

/// then() of the sum of of(i) over those particles.
template <class Device, class T, class Of, class Combine, class Then>
void reduce_members_then(Device& on, const ClusterList& list, ClusterRange range, const T& start, const Of& of,
                         const Combine& combine, const Then& then) {
  on.reduce_then(
      range.count * cluster_size, start,
      [=] HOST_DEVICE(Index n) {
        const Index c = range[n / cluster_size];
        const Index i = list.first(c) + n % cluster_size;
        return i < list.last(c) ? of(i) : start;
      },
      combine, then);
}

/// Lists of indices, chosen one after the other; how many they hold is asked for once, at the end.
template <class Device>
class Selection {
 public:
  explicit Selection(Device& on) : on_(on) { counts_.resize(most); }

  /// Those of candidate(0) … candidate(n - 1) that keep().
  template <class Candidate, class Keep>
  void choose(Index n, const Candidate& candidate, const Keep& keep, typename Device::template Buffer<Index>& kept) {
    on_.select(n, candidate, keep, kept, counts_.data() + chosen_.size());
    chosen_.push_back(&kept);
  }
  template <class Keep>
  void choose(Index n, const Keep& keep, typename Device::template Buffer<Index>& kept) {
    choose(
        n, [] HOST_DEVICE(Index i) { return i; }, keep, kept);
  }
  template <class Keep>
  void choose(ClusterRange from, const Keep& keep, typename Device::template Buffer<Index>& kept) {
    choose(
        from.count, [=] HOST_DEVICE(Index n) { return from[n]; }, keep, kept);
  }
  /// The lists have their lengths from here on.
  void finish() {
    const auto counts = on_.on_host(counts_, 0, chosen_.size());
    for (std::size_t k = 0; k < chosen_.size(); ++k) chosen_[k]->resize(counts[k]);
  }

 private:
  static constexpr std::size_t most = 8;
  Device& on_;
  typename Device::template Buffer<Index> counts_;
  std::vector<typename Device::template Buffer<Index>*> chosen_;
};

}  // namespace thalweg
