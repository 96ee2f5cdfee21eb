#include "solver/models/openings/make_zone.hpp"

#include <cmath>

#include "case/models/openings.hpp"

namespace thalweg {
namespace {

/// Way [m] from the lower edge of a length `half` to both sides of `at` to the nearest boundary between two cells of the
/// lattice; 0 along a slanting direction, and along one in which the domain repeats itself: there an opening may be as wide
/// as the period.
Vec3 way_to_lattice(const Vec3& at, const Vec3& direction, double half, const Vec3& node, const Case& of) {
  const double spacing = of.numerics.spacing;
  Eigen::Index axis = 0;
  if (direction.cwiseAbs().maxCoeff(&axis) < 1 - 1e-9) return Vec3::Zero();
  if (of.domain.is_periodic(static_cast<int>(axis))) return Vec3::Zero();
  const double edge = at[axis] - direction[axis] * half;
  const double cells = (edge - node[axis]) / spacing - 0.5;
  const double way = (std::round(cells) - cells) * spacing;
  return std::abs(way) > 1e-6 * spacing ? Vec3(way * Vec3::Unit(axis)) : Vec3(Vec3::Zero());
}

Vec3 centre_on_lattice(const Opening& opening, const Case& of, const std::optional<Vec3>& lattice_node) {
  if (!lattice_node || opening.is_round()) return opening.at;
  const OpeningAxes axes = opening.axes();
  Vec3 at = opening.at + way_to_lattice(opening.at, axes.up, 0.5 * opening.extent_up(), *lattice_node, of);
  if (of.info.dimension == 3) {
    at += way_to_lattice(opening.at, axes.across, 0.5 * opening.extent_across(of.info.dimension), *lattice_node, of);
  }
  return at;
}

}  // namespace

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

}  // namespace thalweg
