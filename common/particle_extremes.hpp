#pragma once

#include "common/particles.hpp"

namespace thalweg {

/// Widens a set of two particles, which have the least and the largest entry of every array of those added so far (of several
/// components the shortest and the longest), by the particles of `range`. A set of none takes the range's own. Infinite numbers
/// count, NaN does not. Throws RunError for an array that does not fit the number of particles, or that the ranges before did
/// not have.
void widen(ParticleSet& extremes, const ParticleSet& range);

}  // namespace thalweg
