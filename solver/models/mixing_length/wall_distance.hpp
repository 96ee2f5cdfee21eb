#pragma once

#include <cmath>

#include "solver/models/mixing_length/arrays.hpp"
#include "solver/models/mixing_length/surface_lattice.hpp"

// Distance of each water particle to the nearest wall or bed, in any direction, found where the neighbour lists are made.
// Each node of a lattice one spacing wide is told the nearest surface by the node before it, along all lines of the
// lattice, forth and back, direction after direction, twice (after Danielsson 1980, Comput. Graph. Image Process. 14,
// 227-248). A particle takes the nearest of those of the nodes around it. Where nothing moves but water the lattice is
// made once.
namespace thalweg {

/// Pass over the lines of the lattice along direction k.
template <int Dim>
struct SpreadAlongPass {
  using reads = Reads<>;
  using writes = Writes<>;

  SurfaceLattice<Dim> surfaces;
  Index* nearest;
  int k;

  HOST_DEVICE void operator()(Index line) const {
    int at[Dim];
    for (int l = 0; l < Dim; ++l) {
      if (l == k) continue;
      at[l] = static_cast<int>(line % static_cast<Index>(surfaces.columns.nodes[l]));
      line /= static_cast<Index>(surfaces.columns.nodes[l]);
    }
    const int n = surfaces.columns.nodes[k];
    const int steps = surfaces.columns.periodic[k] ? 2 * n : n;
    for (const bool forth : {true, false}) {
      Index carried = no_surface_node;
      for (int step = 0; step < steps; ++step) {
        at[k] = forth ? step % n : n - 1 - step % n;
        const Index node = surfaces.node(at);
        const Index own = nearest[node];
        if (carried != own && carried != no_surface_node) {
          const Vec<Dim, double> here = surfaces.place(node);
          if (surfaces.distance(here, carried) < surfaces.distance(here, own)) nearest[node] = carried;
        }
        carried = nearest[node];
      }
    }
  }
};

/// Particle pass over the fluid: the distance to the nearest of the surfaces that the nodes around a particle know.
template <int Dim>
struct WallDistancePass {
  using reads = Reads<field::position>;
  using writes = Writes<field::eddies>;

  SurfaceLattice<Dim> surfaces;
  const Position* positions;
  const Index* nearest;
  Eddies* eddies;

  HOST_DEVICE void operator()(Index i) const {
    const ColumnLattice<Dim>& columns = surfaces.columns;
    Vec<Dim, double> x{};
    int below[Dim];
    for (int k = 0; k < Dim; ++k) {
      x[k] = positions[i].x[axis<Dim>(k)];
      float share;
      below[k] = columns.below(k, x[k], share);
    }
    float least = INFINITY;
    Index last = no_surface_node;
    for (int corner = 0; corner < (1 << Dim); ++corner) {
      int at[Dim];
      bool in = true;
      for (int k = 0; k < Dim; ++k) {
        at[k] = columns.inside(k, below[k] + ((corner >> k) & 1));
        in = in && at[k] >= 0;
      }
      if (!in) continue;
      const Index surface = nearest[surfaces.node(at)];
      if (surface == last) continue;
      last = surface;
      const float distance = surfaces.distance(x, surface);
      least = distance < least ? distance : least;
    }
    eddies[i].wall_distance = least < INFINITY ? least : 0;
  }
};

/// The lattice, between steps.
template <class Device, int Dim>
struct SurfaceNodes {
  typename Device::template Buffer<SurfaceNode<Dim>> nodes;
};
template <class Device>
struct WallDistanceWork : SurfaceNodes<Device, 2>, SurfaceNodes<Device, 3> {
  typename Device::template Buffer<Index> nearest;  // per node: the node next to which the nearest surface lies
};

/// Tells every node its nearest surface.
template <int Dim, class Device>
void find_surfaces(Device& on, Particles<Device>& p, const Scene<Dim>& scene, WallDistanceWork<Device>& work) {
  auto& nodes = static_cast<SurfaceNodes<Device, Dim>&>(work).nodes;
  const auto all = static_cast<std::size_t>(SurfaceLattice<Dim>(scene, nullptr).size());
  nodes.resize(all);
  work.nearest.resize(all);
  on.fill(nodes, all, SurfaceNode<Dim>{});
  const SurfaceLattice<Dim> surfaces(scene, nodes.data());
  const auto add = [] HOST_DEVICE(std::int64_t * to, std::int64_t amount) { Device::atomic_add(to, amount); };
  const WallNormal* turned = p.wall_normal.size() == 0 ? nullptr : p.wall_normal.data();
  const Record* records = p.record.data();
  const Position* positions = p.position.data();
  on.for_each(p.count - p.fluid_count,
              AddWallsPass<Dim, decltype(add)>{records, positions, p.wall_element.data(), turned, surfaces.columns,
                                               nodes.data(), add, p.fluid_count});
  if (scene.has_sediment) {
    for_each_member(
        on, p.list(), p.at_bed_surface(),
        AddBedPass<Dim, decltype(add)>{records, positions, p.list(), scene, surfaces.columns, nodes.data(), add});
  }
  on.share_sums(nodes);
  const SurfaceNode<Dim>* made = nodes.data();
  Index* nearest = work.nearest.data();
  on.for_each(static_cast<Index>(all), declare<Reads<>, Writes<>>([=] HOST_DEVICE(Index n) {
                nearest[n] = made[n].number > 0 ? n : no_surface_node;
              }));
  for (int round = 0; round < 2; ++round) {
    for (int k = Dim - 1; k >= 0; --k) {
      const auto lines = static_cast<Index>(all / static_cast<std::size_t>(surfaces.columns.nodes[k]));
      on.for_each(lines, SpreadAlongPass<Dim>{surfaces, nearest, k});
    }
  }
}

/// Finds the distances of all water particles.
template <int Dim, class Device>
void find_wall_distances(Device& on, Particles<Device>& p, const Scene<Dim>& scene, WallDistanceWork<Device>& work) {
  if (work.nearest.empty() || scene.has_sediment || scene.walls_move) find_surfaces(on, p, scene, work);
  const SurfaceLattice<Dim> surfaces(scene, static_cast<SurfaceNodes<Device, Dim>&>(work).nodes.data());
  on.for_each(p.fluid_count, WallDistancePass<Dim>{surfaces, p.position.data(), work.nearest.data(), p.eddies.data()});
}

}  // namespace thalweg
