#pragma once

#include <vtkPolyData.h>

#include "postproc/cell_list.hpp"
#include "postproc/level_map.hpp"

namespace thalweg {

/// Adds Velocity [m/s], the kernel's mean over the fluid around each point or, with `sediment_only`, over the sediment;
/// with `shields`, and where the set has them, ShieldsNumber [-], the mean over the grains that have one. 0 where there
/// is none in reach.
void add_particle_values(vtkPolyData* surface, const ParticleSet& particles, const CellList& cells, bool sediment_only,
                         bool shields);

/// Adds BedLevelChange [m], each point's height over `height` of `initial` at the same place, NaN where that has none,
/// and its parts ScourDepth and DepositionDepth [m].
void add_bed_change(vtkPolyData* surface, const LevelMap& initial, double ColumnLevels::*height);

}  // namespace thalweg
