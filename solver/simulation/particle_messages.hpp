#pragma once

#include <vector>

#include "common/particles.hpp"
#include "common/ranks.hpp"

namespace thalweg {

/// A particle set as bytes, without ParticleSet::info, and back.
void append_to(Bytes& message, const ParticleSet& set);
ParticleSet particles_in(MessageReader& message);
Bytes to_message(const ParticleSet& set);
ParticleSet from_message(const Bytes& message);

/// The sets of all ranks as one rank would have it: the fluid of all, then the walls of all (own_fluid_fact); facts are
/// those of the first.
ParticleSet join_sets(const std::vector<ParticleSet>& of_ranks);

}  // namespace thalweg
