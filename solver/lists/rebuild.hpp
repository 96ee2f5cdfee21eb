#pragma once

#include <algorithm>
#include <vector>

#include "solver/domain/population.hpp"
#include "solver/lists/build.hpp"
#include "solver/lists/drift.hpp"
#include "solver/lists/share.hpp"
#include "solver/lists/sort.hpp"

namespace thalweg {

/// Remembers the places that the lists are made for.
template <class Device>
void keep_listed_places(Device& on, Particles<Device>& p) {
  p.listed_at.resize(p.count);
  const Record* records = p.record.data();
  Place* listed = p.listed_at.data();
  on.for_each(p.count, declare<Reads<field::place>, Writes<field::listed_at>>([=] HOST_DEVICE(Index i) {
                for (int k = 0; k < 3; ++k) listed[i].c[k] = records[i].place[k];
              }));
}

/// This rank's share of the scene; nullptr where there is one rank.
template <int Dim, class Device>
Share<Dim, Device>* share_of(Device& on) {
  return static_cast<Share<Dim, Device>*>(on.shared);
}

/// Those of all ranks, in the order of their ids.
template <class Device>
std::vector<ExcludedParticle> of_all_ranks(Device& on, std::vector<ExcludedParticle> excluded) {
  if (on.shared != nullptr) {
    Ranks& ranks = on.shared->ranks;
    Bytes mine;
    append_to(mine, excluded.data(), excluded.size());
    const auto all = exchange_any(ranks, std::vector<Bytes>(static_cast<std::size_t>(ranks.size()), mine));
    excluded.clear();
    for (const Bytes& of_rank : all) {
      std::vector<ExcludedParticle> some(of_rank.size() / sizeof(ExcludedParticle));
      MessageReader(of_rank).read(some.data(), some.size());
      excluded.insert(excluded.end(), some.begin(), some.end());
    }
  }
  std::sort(excluded.begin(), excluded.end(),
            [](const ExcludedParticle& a, const ExcludedParticle& b) { return a.id < b.id; });
  return excluded;
}

/// Sorts the particles, and hands over to other ranks those that lie in their ranges.
template <int Dim, class Device>
std::vector<ExcludedParticle> put_in_order(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  auto* const share = share_of<Dim>(on);
  if (share != nullptr) share->drop_copies(on, p, scene);
  auto excluded = of_all_ranks(on, neighbours::sort_particles(on, p, scene));
  if (share != nullptr) {
    share->redistribute(on, p, scene);
    share->find_copies(on, p, scene);
  }
  return excluded;
}

/// Lets in the particles that wait to be born, sorts all of them and makes the lists anew. Returns the particles that
/// were excluded since the last time.
template <int Dim, class Device>
std::vector<ExcludedParticle> rebuild_lists(Device& on, Particles<Device>& p, const Scene<Dim>& scene,
                                            Population& population) {
  population.admit(on, p, scene);
  auto excluded = put_in_order(on, p, scene);
  population.count_lost(excluded);
  neighbours::build_lists(on, p, scene);
  keep_listed_places(on, p);
  return excluded;
}

/// The same in a scene where nobody is born.
template <int Dim, class Device>
std::vector<ExcludedParticle> rebuild_lists(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  Population nobody;
  return rebuild_lists(on, p, scene, nobody);
}

}  // namespace thalweg
