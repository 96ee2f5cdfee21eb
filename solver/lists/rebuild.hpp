#pragma once

#include "solver/domain/population.hpp"
#include "solver/lists/build.hpp"
#include "solver/lists/drift.hpp"
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

/// Lets in the particles that wait to be born, sorts all of them and makes the lists anew. Returns the particles that
/// were excluded since the last time.
template <int Dim, class Device>
std::vector<ExcludedParticle> rebuild_lists(Device& on, Particles<Device>& p, const Scene<Dim>& scene,
                                            Population& population) {
  population.admit(on, p, scene);
  auto excluded = neighbours::sort_particles(on, p, scene);
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
