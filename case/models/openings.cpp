#include "case/models/openings.hpp"

#include <algorithm>
#include <cmath>

#include "case/case.hpp"
#include "case/models/driven_flow.hpp"
#include "case/models/mixture.hpp"

namespace thalweg {

double zone_length(const Case& of) {
  return 2 * of.smoothing_length() * (1 + of.numerics.list_skin) + 2 * of.numerics.spacing;
}

namespace {

/// The largest flow rate of an inlet [m^3/s] (2-D: [m^2/s]).
double largest_flow_rate(const Inlet& inlet, const Case& c) {
  const double area = inlet.area(c.info.dimension);
  double largest = inlet.flow_rate_at(0, area, c.info.dimension);
  for (const double time : inlet.times) {
    largest = std::max(largest, inlet.flow_rate_at(time, area, c.info.dimension));
  }
  return largest;
}

/// Largest speed of a profile over its mean [-]. A logarithmic one has 1.2 and less over all roughnesses.
double peak_of_profile(const Inlet& inlet) {
  switch (inlet.profile) {
    case InletProfile::uniform:
      return 1;
    case InletProfile::log_law:
      return 1.2;
    case InletProfile::table:
      break;
  }
  constexpr int parts = 100;
  const int parts_across = inlet.section.across.empty() ? 1 : parts;
  double sum = 0;
  double peak = 0;
  for (int up = 0; up < parts; ++up) {
    for (int side = 0; side < parts_across; ++side) {
      const double across = ((side + 0.5) / parts_across - 0.5) * inlet.extent_across(3);
      const double speed = inlet.shape_at((up + 0.5) / parts * inlet.extent_up(), across, 0, 0, 0);
      sum += speed / (parts * parts_across);
      peak = std::max(peak, speed);
    }
  }
  return sum > 0 ? peak / sum : 1;
}

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

}  // namespace

double largest_inlet_speed(const Inlet& inlet, const Case& of) {
  double wet = inlet.area(of.info.dimension);
  if (inlet.surface == InletSurface::level) {
    const auto& levels = inlet.levels;
    const double lowest = levels.empty() ? inlet.level : *std::min_element(levels.begin(), levels.end());
    wet *= std::max(0.01, (lowest - inlet.lower_edge()) / inlet.extent_up());
  }
  return peak_of_profile(inlet) * largest_flow_rate(inlet, of) / wet;
}

bool is_supercritical(const Outlet& outlet, const Case& c) {
  if (c.outlets.size() != 1 || c.inlets.empty()) return false;
  if (outlet.kind != OutletKind::level || !outlet.file.empty()) return false;
  double entering = 0;
  for (const Inlet& inlet : c.inlets) {
    if (inlet.surface == InletSurface::follow && !inlet.velocities.empty()) return false;
    entering += largest_flow_rate(inlet, c);
  }
  const double lowest =
      outlet.levels.empty() ? outlet.level : *std::min_element(outlet.levels.begin(), outlet.levels.end());
  const double depth = lowest - outlet.lower_edge();
  const double velocity = entering / (depth * outlet.extent_across(c.info.dimension));
  return depth > 0 && velocity > std::sqrt(c.domain.gravity.norm() * depth);
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

namespace models {

bool OpenBoundaries::is_on(const Case& whole) { return !whole.inlets.empty() || !whole.outlets.empty(); }

std::vector<Rule> OpenBoundaries::rules() {
  return {{Mixture::is_on, "model.seepage", "the two sets of particles of a mixture cannot enter or leave",
           "write seepage = \"off\", or remove the inlets and outlets"},
          {DrivenFlow::is_on, "flow.drive", "a flow that is driven around a period has inlets or outlets too",
           "remove flow.drive, or the inlets and outlets"},
          {[](const Case& c) { return c.inlets.empty() && !c.has_water(); }, "case.name",
           "the scene has outlets, and neither water nor an inlet", "give a shape the role \"water\""}};
}

}  // namespace models
}  // namespace thalweg
