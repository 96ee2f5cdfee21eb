#pragma once

#include <algorithm>

#include "solver/models/all.hpp"

namespace thalweg {

/// Particles within the kernel's support of a fluid particle, itself included, averaged over a sample.
template <int Dim, class Device>
double mean_neighbours(Device& on, const Particles<Device>& p, const Scene<Dim>& scene) {
  if (p.list_begin.empty()) return 0;
  const ClusterList list = p.list();
  const Record* records = p.record.data();
  const float support2 = scene.support() * scene.support();
  const Index stride = std::max<Index>(1, p.fluid_clusters / 1000);
  const Index samples = (p.fluid_clusters + stride - 1) / stride;
  const auto sum = [] HOST_DEVICE(std::int64_t a, std::int64_t b) { return a + b; };
  const std::int64_t particles =
      on.reduce_here(samples, std::int64_t{0}, declare<Reads<>, Writes<>>([=] HOST_DEVICE(Index n) {
                       return std::int64_t{list.last(n * stride)} - list.first(n * stride);
                     }),
                     sum);
  const std::int64_t found =
      on.reduce_here(samples, std::int64_t{0},
                     declare<Neighbours<field::place>, Reads<field::place>, Writes<>>([=] HOST_DEVICE(Index n) {
                       const Index c = n * stride;
                       std::int64_t neighbours = 0;
                       for (Index i = list.first(c); i < list.last(c); ++i) {
                         for (Index e = list.begin[c]; e < list.begin[c + 1]; ++e) {
                           const Index j = list.entries[e];
                           if (j == list.none) continue;
                           const Vec<Dim, float> r = scene.separation(records[i].place, records[j].place);
                           if (dot(r, r) < support2) ++neighbours;
                         }
                       }
                       return neighbours;
                     }),
                     sum);
  return particles == 0 ? 0 : double(found) / double(particles);
}

}  // namespace thalweg
