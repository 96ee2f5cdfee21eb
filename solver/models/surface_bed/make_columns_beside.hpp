#pragma once

#include <vector>

#include "case/case.hpp"
#include "physics/bed/grain_columns.hpp"

namespace thalweg {

/// Columns of a bed within the width of an opening whose middles lie so far [m] in front of its plane: from `from` up to,
/// not including, `to`. In front is where the opening's direction points; numbers below zero lie behind. None where the
/// opening looks up or down, or across the lattice. `first`: x and y of the middle of the first column [m].
std::vector<int> columns_beside(const Opening& opening, const Case& of, const BedGrid& grid, const double (&first)[2],
                                double from, double to);

/// The axis that an opening looks along, 0 for x and 1 for y; -1 for another direction.
int axis_of(const Opening& opening);

}  // namespace thalweg
