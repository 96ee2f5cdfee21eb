#include "solver/models/openings/make_zone.hpp"

#include <algorithm>
#include <cmath>

#include "case/models/openings.hpp"

namespace thalweg {
namespace {

/// Number of cells of the lattice along a length [m].
Index cells_along(double length, double spacing) {
  return static_cast<Index>(std::max(1.0, std::round(length / spacing)));
}

Zone make_zone(const Opening& opening, const Case& of, const std::optional<Vec3>& lattice_node) {
  Zone zone;
  const Vec3 at = centre_on_lattice(opening, of, lattice_node);
  const OpeningAxes axes = opening.axes();
  for (int c = 0; c < 3; ++c) {
    zone.at[c] = at[c];
    zone.flow[c] = axes.flow[c];
    zone.up[c] = axes.up[c];
    zone.across[c] = of.info.dimension == 3 ? axes.across[c] : 0;
  }
  zone.half_up = 0.5 * opening.extent_up();
  zone.half_across = 0.5 * opening.extent_across(of.info.dimension);
  zone.round = opening.is_round();
  zone.length = zone_length(of);
  zone.spacing = of.numerics.spacing;
  zone.upright = std::abs(axes.flow.z()) < 1e-6 && !opening.is_round();
  return zone;
}

}  // namespace

Zone make_zone(const Inlet& inlet, const Case& of, const std::optional<Vec3>& lattice_node) {
  Zone zone = make_zone(static_cast<const Opening&>(inlet), of, lattice_node);
  zone.enters = true;
  zone.is_full = inlet.surface == InletSurface::full;
  zone.feeds = inlet.bed_load != InletBedLoad::none;
  zone.rows = cells_along(2 * zone.half_up, zone.spacing);
  zone.ranks = of.info.dimension == 3 ? cells_along(2 * zone.half_across, zone.spacing) : 1;
  return zone;
}

Zone make_zone(const Outlet& outlet, const Case& of, const std::optional<Vec3>& lattice_node) {
  Zone zone = make_zone(static_cast<const Opening&>(outlet), of, lattice_node);
  zone.falls = outlet.kind == OutletKind::fall;
  zone.pumps = outlet.kind == OutletKind::pump;
  return zone;
}

}  // namespace thalweg
