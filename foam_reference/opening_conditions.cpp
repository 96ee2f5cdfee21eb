#include "foam_reference/opening_conditions.hpp"

#include <fmt/format.h>

#include <cmath>

#include "case/check_context.hpp"
#include "foam_reference/dictionary.hpp"
#include "physics/water/log_profile.hpp"

namespace thalweg::foam {
namespace {

// Height of a face's centre over the opening's lower edge, as an expression [m]. In an opening that lies flat: along x.
std::string height_over_edge(const OpeningPatch& patch) {
  const bool upright = is_upright(patch);
  const Opening& opening = *patch.opening;
  const double edge = upright ? opening.lower_edge() : opening.at.x() - 0.5 * opening.extent_up();
  return fmt::format("(pos().{}() - {})", upright ? "z" : "x", number(edge));
}

std::string level_of(const Opening& opening) { return over_time(opening.times, opening.levels, opening.level); }

// The share of water in a face under a level, its part below it.
std::string share_under_level(const FoamCase& foam_case, const Opening& opening) {
  return fmt::format("min(max(({} - pos().z())/{} + 0.5, 0), 1)", level_of(opening), number(foam_case.plan.size().z()));
}

// Place of a face's centre across the opening, from its middle, as an expression [m].
std::string place_across(const Opening& opening) {
  const Vec3 across = opening.axes().across;
  std::string text;
  for (const int axis : {0, 1, 2}) {
    if (std::abs(across[axis]) < 1e-6) continue;
    if (!text.empty()) text += " + ";
    text += fmt::format("({})*(pos().{}() - ({}))", number(across[axis]), axis_name(axis), number(opening.at[axis]));
  }
  return "(" + text + ")";
}

// A table over height and width as an expression: the row of each height, times a hat that falls to 0 at the next ones.
std::string shape_of_section(const OpeningPatch& patch) {
  const VelocitySection& section = patch.inlet->section;
  const std::string height = height_over_edge(patch);
  if (section.across.empty()) return over_time(section.heights, section.speeds, 0, height);
  const std::string across = place_across(*patch.opening);
  std::string text;
  for (std::size_t row = 0; row < section.heights.size(); ++row) {
    std::vector<double> hat(section.heights.size(), 0.0);
    hat[row] = 1;
    const auto begin = section.speeds.begin() + static_cast<std::ptrdiff_t>(row * section.across.size());
    const std::vector<double> speeds(begin, begin + static_cast<std::ptrdiff_t>(section.across.size()));
    if (!text.empty()) text += " + ";
    text += over_time(section.heights, hat, 0, height) + "*" + over_time(section.across, speeds, 0, across);
  }
  return "(" + text + ")";
}

// Relative speed over the opening, as an expression.
std::string shape_of(const FoamCase& foam_case, const OpeningPatch& patch) {
  const Inlet& inlet = *patch.inlet;
  switch (inlet.profile) {
    case InletProfile::uniform:
      return "1";
    case InletProfile::log_law: {
      const Current current = current_of(foam_case, patch);
      const double origin =
          profile_origin(current.friction_velocity, kinematic_viscosity(foam_case.scene), inlet.roughness);
      return fmt::format("log(max({}/{}, 1))", height_over_edge(patch), number(origin));
    }
    case InletProfile::table:
      return shape_of_section(patch);
  }
  return "1";
}

// Flow rate of an inlet [m^3/s] (2-D: through the block's metre of width) as an expression. `wet`: the wetted area [m^2]
// for a flow that is given as a velocity.
std::string flow_rate_of(const FoamCase& foam_case, const Inlet& inlet, const std::string& wet) {
  const double across = inlet.extent_across(foam_case.scene.info.dimension);
  if (inlet.flow_rate > 0 || !inlet.flow_rates.empty())
    return over_time(inlet.times, inlet.flow_rates, inlet.flow_rate);
  if (inlet.discharge > 0 || !inlet.discharges.empty()) {
    return number(across) + "*" + over_time(inlet.times, inlet.discharges, inlet.discharge);
  }
  return wet + "*" + over_time(inlet.times, inlet.velocities, inlet.velocity);
}

// The wetted area of an inlet [m^2] where the case tells it.
std::string wetted_area(const FoamCase& foam_case, const Inlet& inlet) {
  const int dimension = foam_case.scene.info.dimension;
  switch (inlet.surface) {
    case InletSurface::full:
      return number(inlet.area(dimension));
    case InletSurface::level:
      return fmt::format("{}*({} - {})", number(inlet.extent_across(dimension)), level_of(inlet),
                         number(inlet.lower_edge()));
    case InletSurface::follow:
      break;
  }
  return "weightSum(alpha.water)";
}

std::string expression(const std::string& entry) { return "type exprFixedValue; valueExpr \"" + entry + "\";"; }

std::string axis_vector(const Vec3& along) {
  return fmt::format("vector({}, {}, {})", number(along.x()), number(along.y()), number(along.z()));
}

// Water that crosses in proportion to `shape` and to the share of water in a face, `share`; `flow_rate` [m^3/s] of water
// in all, without the air in faces that are partly dry. An opening that has fallen dry brings none.
std::string weighted_flow(const Vec3& along, const std::string& flow_rate, const std::string& share,
                          const std::string& shape) {
  return expression(fmt::format("{}*({})*({})*({})/max(weightSum(({})*({})*({})), 1e-9)", axis_vector(along), flow_rate,
                                share, shape, share, share, shape)) +
         " value uniform (0 0 0);";
}

// k and omega over the height of an inlet, as expressions.
struct InletEddies {
  std::string k;
  std::string omega;
};

InletEddies eddies_of(const FoamCase& foam_case, const OpeningPatch& patch) {
  const Current current = current_of(foam_case, patch);
  if (patch.inlet->profile == InletProfile::log_law) {
    // eddies_at as an expression, from half a cell on: k is the ground's there.
    const EddyState at_bed = eddies_at(current, 0.5 * foam_case.plan.size().z());
    const double depth = current.depth;
    const double half = 0.5 * foam_case.plan.size().z();
    const std::string z = fmt::format("max({}, {})", height_over_edge(patch), number(half));
    return {fmt::format("{}*max(1 - {}/{}, 0.1)", number(at_bed.k / (1 - half / depth)), z, number(depth)),
            fmt::format("{}/{}", number(at_bed.omega * half), z)};
  }
  // Without a law of its own: eddies of a twentieth of the speed, and of a length of 0.07 of the depth.
  const double k = 1.5 * std::pow(0.05 * current.mean_velocity, 2);
  const double omega = std::sqrt(k) / (std::pow(0.09, 0.25) * 0.07 * current.depth);
  return {number(k), number(omega)};
}

}  // namespace

std::string over_time(const std::vector<double>& times, const std::vector<double>& values, double steady,
                      const std::string& variable) {
  if (values.empty()) return number(steady);
  std::string text = "(" + number(values.front());
  for (std::size_t row = 1; row < values.size(); ++row) {
    const double change = values[row] - values[row - 1];
    if (change == 0) continue;
    text += fmt::format(" + ({})*min(max(({} - {})/{}, 0), 1)", number(change), variable, number(times[row - 1]),
                        number(times[row] - times[row - 1]));
  }
  return text + ")";
}

std::string alpha_at(const FoamCase& foam_case, const OpeningPatch& patch) {
  const std::string as_inside = "type variableHeightFlowRate; lowerBound 0; upperBound 1; value uniform 0;";
  if (patch.outlet != nullptr) {
    switch (patch.outlet->kind) {
      case OutletKind::fall:
        return "type inletOutlet; inletValue uniform 0; value uniform 0;";
      case OutletKind::level:
      case OutletKind::pump:
        return as_inside;
    }
  }
  switch (patch.inlet->surface) {
    case InletSurface::full:
      return "type fixedValue; value uniform 1;";
    case InletSurface::level:
      return expression(share_under_level(foam_case, *patch.opening)) + " value uniform 0;";
    case InletSurface::follow:
      break;
  }
  return as_inside;
}

std::string velocity_at(const FoamCase& foam_case, const OpeningPatch& patch) {
  const Vec3 along = patch.opening->axes().flow;
  if (patch.inlet != nullptr) {
    const std::string shape = shape_of(foam_case, patch);
    const std::string share = patch.inlet->surface == InletSurface::full ? "1" : "alpha.water";
    return weighted_flow(along, flow_rate_of(foam_case, *patch.inlet, wetted_area(foam_case, *patch.inlet)), share,
                         shape);
  }
  switch (patch.outlet->kind) {
    case OutletKind::fall:
    case OutletKind::level:
      return "type pressureInletOutletVelocity; value uniform (0 0 0);";
    case OutletKind::pump:
      break;
  }
  std::string entering;
  for (const Inlet& inlet : foam_case.scene.inlets) {
    entering += (entering.empty() ? "" : " + ") + flow_rate_of(foam_case, inlet, wetted_area(foam_case, inlet));
  }
  return weighted_flow(along, entering, "alpha.water", "1");
}

std::string pressure_at(const FoamCase& foam_case, const OpeningPatch& patch) {
  const std::string of_flux = "type fixedFluxPressure; value uniform 0;";
  if (patch.inlet != nullptr) return of_flux;
  switch (patch.outlet->kind) {
    case OutletKind::pump:
      return of_flux;
    case OutletKind::fall:
      return "type prghTotalPressure; p0 uniform 0; value uniform 0;";
    case OutletKind::level:
      break;
  }
  // p_rgh = p - rho g.x, with p the pressure of water at rest under the level and of air above it.
  const double g = -foam_case.scene.domain.gravity.z();
  const std::string under = fmt::format("({} - pos().z())", level_of(*patch.opening));
  const double water = foam_case.scene.water.density;
  return expression(fmt::format("{}*max({}, 0) + {}*min({}, 0) + ({}*alpha.water + {}*(1 - alpha.water))*{}*pos().z()",
                                number(water * g), under, number(air_density * g), under, number(water),
                                number(air_density), number(g))) +
         " value uniform 0;";
}

std::string k_at(const FoamCase& foam_case, const OpeningPatch& patch) {
  if (patch.inlet == nullptr) return "type inletOutlet; inletValue $internalField; value $internalField;";
  return expression(eddies_of(foam_case, patch).k) + " value $internalField;";
}

std::string omega_at(const FoamCase& foam_case, const OpeningPatch& patch) {
  if (patch.inlet == nullptr) return "type inletOutlet; inletValue $internalField; value $internalField;";
  return expression(eddies_of(foam_case, patch).omega) + " value $internalField;";
}

}  // namespace thalweg::foam
