#pragma once

#include <optional>
#include <vector>

#include "case/models/rule.hpp"
#include "case/tables/inlet.hpp"
#include "case/tables/outlet.hpp"

namespace thalweg {

/// Length [m] of the zones in which inlets hold particles ready, and behind the planes of outlets: the reach of the
/// neighbour lists and two spacings. What crosses the plane finds all its neighbours, also while births wait for new
/// lists (solver/domain/population.hpp).
double zone_length(const Case& of);

/// The centre of an opening [m] as gencase and solver place it: the lower edge, and in space the side, of a rectangular one
/// lie on the nearest boundary between two cells of the lattice. lattice_node [m]: a node of it; without one the opening
/// stands where the case says.
Vec3 centre_on_lattice(const Opening& opening, const Case& of, const std::optional<Vec3>& lattice_node);

/// The largest speed with which water enters through an inlet [m/s], profile and hydrograph included.
double largest_inlet_speed(const Inlet& inlet, const Case& of);

/// True if the water at the level of an outlet would run faster than waves: nothing that is imposed there comes upstream.
/// Told only where all water leaves through this outlet; false else.
bool is_supercritical(const Outlet& outlet, const Case& of);

namespace models {

/// Water that enters and leaves: [[inlet]], [[outlet]].
struct OpenBoundaries {
  static bool is_on(const Case& whole);
  static std::vector<Rule> rules();
};

}  // namespace models

}  // namespace thalweg
