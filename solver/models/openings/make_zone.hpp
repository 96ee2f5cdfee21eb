#pragma once

#include <optional>

#include "case/case.hpp"
#include "solver/models/openings/zone.hpp"

namespace thalweg {

/// The place of an opening as the device has it. lattice_node [m]: a node of the lattice that the scene was filled on.
///
/// Walls and beds are whole cells of the lattice, so their surfaces lie up to half a spacing beside those of their shapes.
/// The lower edge of a rectangular opening goes with them to the nearest boundary of cells, in space its side too, or its
/// lowest water would enter within the bed or above it. An opening that slants stays, and so does one without a lattice.
Zone make_zone(const Inlet& inlet, const Case& of, const std::optional<Vec3>& lattice_node);
Zone make_zone(const Outlet& outlet, const Case& of, const std::optional<Vec3>& lattice_node);

}  // namespace thalweg
