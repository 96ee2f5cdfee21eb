#pragma once

#include <vector>

#include "case/case.hpp"
#include "common/particles.hpp"
#include "physics/bed/grain_columns.hpp"

namespace thalweg {

/// A bed as it is laid: its columns, a spacing wide, and how many particles stand in each.
struct LaidBed {
  GrainColumns columns;
  std::vector<float> rows;
  double first[2] = {};  // [m] x and y of the middle of the first column
};

/// Rows of the bed that water on it may feel: those within the kernel's support, and one more. `smoothing_length` and
/// `spacing` in [m].
int rows_in_reach(double smoothing_length, double spacing);

/// Makes columns of the sediment in a filled scene, and rows of wall particles of it. `particles` comes back with the
/// rows in place of its sediment, and with the array field::bed_place. A column stands on the lowest particle of fluid
/// over each place of the ground; a place that holds no fluid is solid. Throws InputError where sediment hangs over water.
LaidBed lay_bed(const Case& of, ParticleSet& particles);

}  // namespace thalweg
