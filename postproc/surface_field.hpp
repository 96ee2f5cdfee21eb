#pragma once

#include <memory>
#include <optional>

#include "common/extraction/bodies.hpp"
#include "common/extraction/profile_extraction.hpp"
#include "postproc/cell_list.hpp"
#include "postproc/level_map.hpp"

namespace thalweg {

/// The volume fractions of a whole particle set on a grid of one spacing in 3-D, half of one in 2-D, summed on all
/// cores, and the bodies in it.
struct SurfaceField {
  VolumeFractions sums;
  Bodies bodies;  // refers to `sums`

  SurfaceField(VolumeFractions filled, const ClassifiedParticles& set) : sums(std::move(filled)), bodies(sums, set) {}
  SurfaceField(const SurfaceField&) = delete;
  SurfaceField& operator=(const SurfaceField&) = delete;
};

/// `cells` holds the particles of `set` in cells with edges of cell_edge(). Null without any fluid.
std::unique_ptr<SurfaceField> make_surface_field(const ClassifiedParticles& set, const CellList& cells,
                                                 const ExtractionSettings& settings);

/// Edge of the cells for make_surface_field [m]: the kernel's support.
inline double cell_edge(const ParticleFileInfo& info) { return 2 * info.smoothing_length; }

/// The heights of all columns of a field.
LevelMap level_map(const SurfaceField& field);

}  // namespace thalweg
