#include "foam_reference/current.hpp"

#include <algorithm>
#include <cmath>

#include "case/models/driven_flow.hpp"
#include "foam_reference/dictionary.hpp"
#include "physics/water/log_profile.hpp"

namespace thalweg::foam {
namespace {

constexpr double c_mu = 0.09;

Current with_mean(double mean_velocity, double depth, double viscosity, double roughness) {
  return {depth, mean_velocity, friction_velocity_of_current(mean_velocity, depth, viscosity, roughness)};
}

}  // namespace

double kinematic_viscosity(const Case& scene) { return scene.water.viscosity / scene.water.density; }

Current current_of(const FoamCase& foam_case) {
  const Case& scene = foam_case.scene;
  const Flow& flow = scene.flow;
  const double viscosity = kinematic_viscosity(scene);
  const double roughness = roughness_of_current(scene);
  const double area = foam_case.contents.water_area;
  const double depth = area > 0 ? foam_case.contents.water_volume / area : 0;
  switch (flow.drive) {
    case Drive::off:
      break;
    case Drive::slope: {
      const double friction = std::sqrt(scene.domain.gravity.norm() * flow.slope * depth);
      return {depth, log_profile(friction, depth * std::exp(-1.0), viscosity, roughness), friction};
    }
    case Drive::discharge:
      return with_mean(flow.discharge / depth, depth, viscosity, roughness);
    case Drive::velocity:
      return with_mean(flow.velocity, depth, viscosity, roughness);
  }
  for (const OpeningPatch& patch : opening_patches(scene)) {
    if (patch.inlet == nullptr) continue;
    const Current entering = current_of(foam_case, patch);
    return with_mean(entering.mean_velocity, entering.depth, viscosity, roughness);
  }
  return {};
}

Current current_of(const FoamCase& foam_case, const OpeningPatch& inlet) {
  const Case& scene = foam_case.scene;
  const int dimension = scene.info.dimension;
  const double depth = depth_at(scene, foam_case.plan, inlet);
  const double area =
      inlet.opening->is_round() ? inlet.opening->area(dimension) : depth * inlet.opening->extent_across(dimension);
  double largest = inlet.inlet->flow_rate_at(0, area, dimension);
  for (const double time : inlet.inlet->times) {
    largest = std::max(largest, inlet.inlet->flow_rate_at(time, area, dimension));
  }
  return with_mean(largest / area, depth, kinematic_viscosity(scene), inlet.inlet->roughness);
}

EddyState eddies_at(const Current& current, double z) {
  constexpr double least_stress = 0.1;
  const double u = current.friction_velocity;
  const double stress = std::max(least_stress, 1 - z / current.depth);
  return {u * u * stress / std::sqrt(c_mu), u / (std::sqrt(c_mu) * von_karman<double> * z)};
}

std::string drive_entries(const FoamCase& foam_case) {
  const Case& scene = foam_case.scene;
  const Flow& flow = scene.flow;
  if (flow.drive == Drive::off) return "";
  std::string law;
  if (flow.drive == Drive::slope) {
    law =
        "    acceleration    " + number(scene.domain.gravity.norm() * flow.slope) + ";  // [m/s^2] g times the slope\n";
  } else {
    const Current current = current_of(foam_case);
    // As in the particles' drive: a tenth of the time H/u*, and the drag that the law of the wall expects.
    const double time = 0.1 * current.depth / current.friction_velocity;
    const double drag = current.friction_velocity * current.friction_velocity / current.depth;
    law = flow.drive == Drive::velocity
              ? "    velocity        " + number(flow.velocity) + ";  // [m/s] mean over the water\n"
              : "    discharge       " + number(flow.discharge) + ";  // [m^2/s]\n    area            " +
                    number(foam_case.contents.water_area) + ";  // [m^2] of the water seen from above\n";
    law += "    time            " + number(time) + ";  // [s] of the control\n    drag            " + number(drag) +
           ";  // [m/s^2] at its start\n";
  }
  return substitute(R"(%name%
{
    type            drivenWater;
    libs            ("libthalwegFoam.so");
    waterPhase      water;
    axis            %axis%;  // 0: x, 1: y
%law%}
)",
                    {{"name", drive_name}, {"axis", std::to_string(flow.component())}, {"law", law}});
}

}  // namespace thalweg::foam
