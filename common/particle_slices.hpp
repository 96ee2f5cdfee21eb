#pragma once

#include <cstddef>

#include "common/particles.hpp"

namespace thalweg {

/// Particles [from, to) of a set, without info and facts.
ParticleSet slice(const ParticleSet& of, std::size_t from, std::size_t to);

/// Adds particles with the same arrays behind those that are there; without info and facts. `to` may have none yet.
void append(ParticleSet& to, const ParticleSet& particles);

/// Makes room for so many particles with the arrays of `like`, which has some.
void reserve(ParticleSet& set, const ParticleSet& like, std::size_t particles);

}  // namespace thalweg
