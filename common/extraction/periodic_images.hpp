#pragma once

#include <optional>

#include "case/tables/domain.hpp"
#include "common/particles.hpp"

namespace thalweg {

/// The set and, behind it, the copies that a domain which repeats itself has within `reach` [m] of its ends: kernel sums
/// next to them are those of the middle then. Nothing for a domain without periodic directions.
std::optional<ParticleSet> with_periodic_images(const ParticleSet& set, const Domain& domain, double reach);

}  // namespace thalweg
