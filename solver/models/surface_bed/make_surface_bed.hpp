#pragma once

#include <memory>

#include "case/case.hpp"
#include "common/particles.hpp"
#include "solver/models/surface_bed/surface_bed.hpp"

namespace thalweg {

/// The bed of a case, or null if it is no surface. `particles` are those of a filled scene, whose sediment becomes rows of
/// walls (make_bed_rows.hpp), or of a checkpoint, which knows its bed. Throws InputError for a checkpoint of another bed,
/// and for sediment that hangs over water.
std::shared_ptr<SurfaceBed> make_surface_bed(const Case& of, ParticleSet& particles);

}  // namespace thalweg
