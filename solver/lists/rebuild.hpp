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

/// Calls what(share) with this rank's share of the scene; nothing where there is one rank.
template <int Dim, class Device, class What>
void with_share(Device& on, const What& what) {
  if (on.shared != nullptr) what(static_cast<Share<Dim, Device>&>(*on.shared));
}

/// Those of all ranks.
inline std::vector<ExcludedParticle> of_all_ranks(Ranks& ranks, const std::vector<ExcludedParticle>& excluded) {
  Bytes mine;
  append_to(mine, excluded.data(), excluded.size());
  std::vector<ExcludedParticle> all;
  for (const Bytes& of_rank : exchange_any(ranks, std::vector<Bytes>(static_cast<std::size_t>(ranks.size()), mine))) {
    std::vector<ExcludedParticle> some(of_rank.size() / sizeof(ExcludedParticle));
    MessageReader(of_rank).read(some.data(), some.size());
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

/// Sorts the particles, and hands over to other ranks those that lie in their ranges. Returns the excluded ones in the order
/// of their ids.
template <int Dim, class Device>
std::vector<ExcludedParticle> put_in_order(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  with_share<Dim>(on, [&](auto& share) { share.drop_copies(on, p, scene); });
  auto excluded = neighbours::sort_particles(on, p, scene);
  with_share<Dim>(on, [&](auto& share) {
    excluded = of_all_ranks(share.ranks, excluded);
    share.redistribute(on, p, scene);
    share.find_copies(on, p, scene);
  });
  std::sort(excluded.begin(), excluded.end(),
            [](const ExcludedParticle& a, const ExcludedParticle& b) { return a.id < b.id; });
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
