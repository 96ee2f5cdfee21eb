#include <cmath>

#include "case/models/driven_flow.hpp"
#include "physics/water/log_profile.hpp"
#include "solver/models/all.hpp"
#include "solver/models/current/water_body.hpp"
#include "solver/models/make.hpp"

namespace thalweg {

namespace {

/// The water of all particles of the source.
WaterBody water_of(const SceneSource& from) {
  if (from.water != nullptr) return *from.water;
  WaterBody body(from.of);
  body.add(from.particles);
  return body;
}

GuideZone guide_zone_of(const Case& of, double viscosity, double roughness) {
  const Flow& flow = of.flow;
  const int axis = flow.component();
  GuideZone zone;
  zone.on = flow.guide_length > 0;
  zone.component = axis;
  zone.from = flow.guide_from;
  zone.length = flow.guide_length;
  zone.period = of.domain.to[axis] - of.domain.from[axis];
  zone.viscosity = viscosity;
  zone.roughness = roughness;
  return zone;
}

}  // namespace

template <int Dim>
void CurrentModel::make(const SceneSource& from, Scene<Dim>& scene) {
  if (!models::DrivenFlow::is_on(from.of)) return;
  const Flow& flow = from.of.flow;
  CurrentDrive& current = scene.current;
  current.on = true;
  current.component = flow.component();
  const WaterBody water = water_of(from);
  const double depth = water.plan() > 0 ? water.mass() / (from.of.water.density * water.plan()) : 0;
  const double viscosity = from.of.water.viscosity / from.of.water.density;
  const double roughness = roughness_of_current(from.of);
  CurrentControl& start = current.start;
  start.velocity = water.mass() > 0 ? water.momentum() / water.mass() : 0;
  current.guide = guide_zone_of(from.of, viscosity, roughness);
  if (flow.drive == Drive::slope) {
    start.acceleration = from.of.domain.gravity.norm() * flow.slope;
    current.start_friction = std::sqrt(start.acceleration * depth);
    return;
  }
  current.controlled = true;
  start.target = flow.drive == Drive::velocity ? flow.velocity : flow.discharge / depth;
  const double friction = friction_velocity_of_current(start.target, depth, viscosity, roughness);
  const double present = friction_velocity_of_current(start.velocity, depth, viscosity, roughness);
  current.start_friction = friction;
  start.time = 0.1 * depth / friction;
  start.drag = present * present / depth;
  start = started(start);
}

template void CurrentModel::make(const SceneSource&, Scene<2>&);
template void CurrentModel::make(const SceneSource&, Scene<3>&);

}  // namespace thalweg
