#pragma once

#include <cmath>

#include "solver/backend/device.hpp"
#include "solver/models/mixing_length/arrays.hpp"
#include "solver/models/wall_stress/arrays.hpp"
#include "solver/passes/integrate.hpp"
#include "solver/state/scene.hpp"

// Distance of each water particle to the nearest wall or bed, in any direction, found where the neighbour lists are made.
// The surface is made of discs: one for each wall element (models/wall_stress) and one for each sediment particle with
// water next to it. Water that has discs in reach takes the nearest. Then each water particle asks its neighbours for
// theirs, until none finds a nearer one: a few rounds for each reach of depth. So distances go through the water: the floor of
// a channel means nothing behind a wall, and nothing is searched beyond the neighbour lists.
namespace thalweg {

/// The nearest surface: a disc of the radius 0.5 dp (0.71 dp in space, so that discs one spacing apart leave no gap).
struct SurfaceDisc {
  float normal[3];  // unit vector into the water
  float depth;      // of the particle below the surface [m]; negative: the particle is no surface
};

/// No disc has been found.
inline constexpr Index no_disc = ~Index{0};

/// Distance [m] from a place to a disc; r [m] leads there from the disc's particle. Infinite for a place that lies more
/// than two radii behind the disc: what is there belongs to another side of the wall.
template <int Dim>
HOST_DEVICE inline float distance_to_disc(const Vec<Dim, float>& r, const SurfaceDisc& disc, float radius) {
  float along = 0;
  for (int k = 0; k < Dim; ++k) along += r[k] * disc.normal[axis<Dim>(k)];
  const float above = along - disc.depth;
  if (above < -2 * radius) return INFINITY;
  const float across2 = dot(r, r) - along * along;
  const float across = sqrtf(across2 > 0 ? across2 : 0) - radius;
  if (!(across > 0)) return above > 0 ? above : 0;
  return sqrtf((above > 0 ? above * above : 0) + across * across);
}

/// Calls visit(j, r) for every neighbour j of particle i with volume, r = x_i - x_j [m].
template <int Dim, class Visit>
HOST_DEVICE inline void each_neighbour(const Record* records, const ClusterList& list, const Scene<Dim>& scene, Index i,
                                       const Visit& visit) {
  const Index cluster = i / cluster_size;
  for (Index entry = list.begin[cluster]; entry < list.begin[cluster + 1]; ++entry) {
    const Index j = list.entries[entry];
    if (j == list.count || j == i || records[j].volume == 0) continue;
    Vec<Dim, float> r{};
    for (int k = 0; k < Dim; ++k)
      r[k] = scene.distance(k, records[i].place[axis<Dim>(k)], records[j].place[axis<Dim>(k)]);
    visit(j, r);
  }
}

/// Particle pass: the discs. Those of sediment lie half a spacing towards the water, along the gradient of what is not
/// solid, where water is nearer than 1.6 spacings.
template <int Dim>
struct SurfaceDiscPass {
  using neighbours = Neighbours<field::place, field::matter>;
  using reads = Reads<field::place, field::matter, field::wall_element, field::wall_normal>;
  using writes = Writes<>;

  const Record* records;
  const WallElement* elements;
  const WallNormal* turned;  // nullptr: no wall moves
  SurfaceDisc* discs;
  ClusterList list;
  Scene<Dim> scene;

  HOST_DEVICE void operator()(Index i) const {
    SurfaceDisc& disc = discs[i];
    disc = {{0, 0, 0}, -1};
    const Record& own = records[i];
    if (own.volume == 0 || is_water(own)) return;
    if (is_sediment(own)) return take_bed(i, disc);
    if (!(elements[i].area > 0)) return;
    const float* normal = turned == nullptr ? elements[i].normal : turned[i].of;
    for (int c = 0; c < 3; ++c) disc.normal[c] = normal[c];
    disc.depth = elements[i].depth;
  }

 private:
  HOST_DEVICE void take_bed(Index i, SurfaceDisc& disc) const {
    const float next = 1.6F * static_cast<float>(scene.spacing);
    const float support = scene.support();
    bool wet = false;
    Vec<Dim, float> outward{};
    each_neighbour(records, list, scene, i, [&](Index j, const Vec<Dim, float>& r) {
      const float r2 = dot(r, r);
      if (!(r2 < support * support)) return;
      if (is_water(records[j])) {
        wet = wet || r2 < next * next;
        return;
      }
      const float slope = records[j].volume * scene.kernel.gradient(scene.kernel.closeness(sqrtf(r2)));
      for (int k = 0; k < Dim; ++k) outward[k] -= slope * r[k];
    });
    const float length = sqrtf(dot(outward, outward));
    if (!wet || !(length > 0)) return;
    for (int k = 0; k < Dim; ++k) disc.normal[axis<Dim>(k)] = outward[k] / length;
    disc.depth = 0.5F * static_cast<float>(scene.spacing);
  }
};

/// What the search for the nearest discs works on.
template <int Dim>
struct DiscSearch {
  const Record* records;
  const SurfaceDisc* discs;
  ClusterList list;
  Scene<Dim> scene;
  float radius;  // of the discs [m]

  [[nodiscard]] HOST_DEVICE float distance(Index i, Index j) const {
    Vec<Dim, float> r{};
    for (int k = 0; k < Dim; ++k)
      r[k] = scene.distance(k, records[i].place[axis<Dim>(k)], records[j].place[axis<Dim>(k)]);
    return distance_to_disc<Dim>(r, discs[j], radius);
  }
};

/// Particle pass over the fluid: the nearest disc in reach, or none.
template <int Dim>
struct NearestDiscPass {
  using neighbours = Neighbours<field::place, field::matter>;
  using reads = Reads<field::place, field::matter>;
  using writes = Writes<>;

  DiscSearch<Dim> search;
  Index* nearest;

  HOST_DEVICE void operator()(Index i) const {
    nearest[i] = no_disc;
    if (!is_water(search.records[i])) return;
    float least = INFINITY;
    each_neighbour(search.records, search.list, search.scene, i, [&](Index j, const Vec<Dim, float>& r) {
      if (!(search.discs[j].depth >= 0)) return;
      const float distance = distance_to_disc<Dim>(r, search.discs[j], search.radius);
      if (!(distance < least)) return;
      least = distance;
      nearest[i] = j;
    });
  }
};

/// Particle pass over the fluid: the nearest of the discs that the water in reach knows. 1 if it is a new one.
template <int Dim>
struct SpreadDiscsPass {
  using neighbours = Neighbours<field::place, field::matter>;
  using reads = Reads<field::place, field::matter>;
  using writes = Writes<>;

  DiscSearch<Dim> search;
  const Index* known;
  Index* nearest;

  HOST_DEVICE Index operator()(Index i) const {
    const Index before = known[i];
    nearest[i] = before;
    if (!is_water(search.records[i])) return 0;
    // What is nearer by less than this is not worth another round.
    const float worth = 1e-3F * static_cast<float>(search.scene.spacing);
    float least = before == no_disc ? INFINITY : search.distance(i, before);
    Index last = before;
    each_neighbour(search.records, search.list, search.scene, i, [&](Index j, const Vec<Dim, float>&) {
      if (!is_water(search.records[j]) || known[j] == no_disc || known[j] == last) return;
      last = known[j];
      const float distance = search.distance(i, last);
      if (!(distance < least - worth)) return;
      least = distance;
      nearest[i] = last;
    });
    return nearest[i] == before ? 0 : 1;
  }
};

/// What the search keeps between rounds.
template <class Device>
struct WallDistanceWork {
  typename Device::template Buffer<SurfaceDisc> discs;
  typename Device::template Buffer<Index> nearest;
  typename Device::template Buffer<Index> nearest_before;
};

/// Finds the distances of all water particles.
template <int Dim, class Device>
void find_wall_distances(Device& on, Particles<Device>& p, const Scene<Dim>& scene, WallDistanceWork<Device>& work) {
  work.discs.resize(p.count);
  work.nearest.resize(p.fluid_count);
  work.nearest_before.resize(p.fluid_count);
  const Record* records = p.record.data();
  const WallNormal* turned = p.wall_normal.size() == 0 ? nullptr : p.wall_normal.data();
  on.for_each(p.count,
              SurfaceDiscPass<Dim>{records, p.wall_element.data(), turned, work.discs.data(), p.list(), scene});
  const float radius = static_cast<float>(0.5 * scene.spacing * std::sqrt(Dim - 1.0));
  const DiscSearch<Dim> search{records, work.discs.data(), p.list(), scene, radius};
  on.for_each(p.fluid_count, NearestDiscPass<Dim>{search, work.nearest.data()});
  Index found = 1;
  while (found > 0) {
    std::swap(work.nearest, work.nearest_before);
    found = on.reduce(p.fluid_count, Index{0},
                      SpreadDiscsPass<Dim>{search, work.nearest_before.data(), work.nearest.data()},
                      [] HOST_DEVICE(Index a, Index b) { return a + b; });
  }
  const Index* nearest = work.nearest.data();
  Eddies* eddies = p.eddies.data();
  on.for_each(p.fluid_count, declare<Reads<field::place>, Writes<field::eddies>>([=] HOST_DEVICE(Index i) {
                eddies[i].wall_distance = nearest[i] == no_disc ? 0 : search.distance(i, nearest[i]);
              }));
}

}  // namespace thalweg
