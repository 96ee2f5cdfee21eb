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

  SurfaceField(VolumeFractions filled, double spacing, bool has_sediment, bool rest_is_known)
      : sums(std::move(filled)), bodies(sums, spacing, has_sediment, rest_is_known) {}
  SurfaceField(const SurfaceField&) = delete;
  SurfaceField& operator=(const SurfaceField&) = delete;
};

/// `cells` holds the particles in cells of the kernel's support. Null without any fluid. Throws InputError when spacing
/// or smoothing length are missing.
std::unique_ptr<SurfaceField> make_surface_field(const ParticleSet& particles, const CellList& cells,
                                                 const ExtractionSettings& settings);

/// Edge of the cells for make_surface_field [m]: the kernel's support.
inline double cell_edge(const ParticleFileInfo& info) { return 2 * info.smoothing_length; }

LevelMap level_map(const SurfaceField& field);

}  // namespace thalweg
