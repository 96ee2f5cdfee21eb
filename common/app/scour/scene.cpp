#include "common/app/scour/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/app/scour/scene_walls.hpp"
#include "physics/transport/critical_shields.hpp"

namespace thalweg {
namespace {

std::string quoted(const char* what, const std::string& name) { return fmt::format("{} \"{}\"", what, name); }

void read_bed(const Case& scene, SceneReading& reading) {
  if (scene.sediments.size() > 1) {
    reading.notes.push_back({"the case has more than one sediment; give --grain and --grain-density", "grain"});
  } else if (scene.sediments.size() == 1) {
    const auto& [name, sediment] = *scene.sediments.begin();
    const std::string origin = quoted("material", name);
    reading.inputs.set("grain", sediment.grain_diameter, origin);
    reading.inputs.set("grain-density", sediment.grain_density, origin);
    const double critical = critical_shields_of(sediment, scene.water.density, scene.domain.gravity.norm());
    if (critical > 0) reading.inputs.set("critical-shields", critical, origin);
  }
  reading.inputs.set("water-density", scene.water.density, "material water");
  if (scene.water.viscosity > 0) reading.inputs.set("viscosity", scene.water.viscosity, "material water");
  if (scene.domain.gravity.norm() > 0) reading.inputs.set("gravity", scene.domain.gravity.norm(), "[domain]");
}

/// The level of the tailwater [m], and who tells it; of outlets if they hold one.
Level tailwater_level(const Case& scene) {
  for (const Outlet& outlet : scene.outlets) {
    if (outlet.kind != OutletKind::level) continue;
    double level = outlet.level;
    for (const double row : outlet.levels) level = std::max(level, row);
    return {level, quoted("outlet", outlet.name)};
  }
  for (const Inlet& inlet : scene.inlets)
    if (inlet.surface == InletSurface::level) return {inlet.level_at(0), quoted("inlet", inlet.name)};
  return top_of(scene, ShapeRole::water);
}

void read_depth(const Case& scene, const Level& bed, const Level& water, SceneReading& reading) {
  if (!bed.is_known() && !scene.sediments.empty()) {
    reading.notes.push_back({bed.origin + "; give --depth", "depth"});
  } else if (!water.is_known()) {
    reading.notes.push_back({water.origin + "; give --depth", "depth"});
  } else if (bed.is_known() && water.height > bed.height) {
    reading.inputs.set("depth", water.height - bed.height, fmt::format("{} over {}", water.origin, bed.origin));
  }
}

/// Mean velocity [m/s] of the water in an inlet whose wetted area is its own: the largest of its table.
double largest_velocity(const Inlet& inlet, int dimension) {
  const double area = inlet.area(dimension);
  double largest = inlet.flow_rate_at(0, area, dimension);
  for (const double time : inlet.times) largest = std::max(largest, inlet.flow_rate_at(time, area, dimension));
  return largest / area;
}

bool gives_velocity(const Inlet& inlet) { return inlet.velocity > 0 || !inlet.velocities.empty(); }

/// The kinds of an inlet for scour.
enum class InletKind { channel, wall_jet, falling };

InletKind kind_of(const Inlet& inlet, const Level& bed, const Level& water) {
  constexpr double steep = 0.9;
  if (inlet.axes().flow.z() < -steep) return InletKind::falling;
  if (!water.is_known()) return InletKind::channel;
  if (inlet.lower_edge() >= water.height) return InletKind::falling;
  const double depth = bed.is_known() ? water.height - bed.height : 0;
  const bool submerged = inlet.surface == InletSurface::full && inlet.upper_edge() < water.height - 0.1 * depth;
  return submerged ? InletKind::wall_jet : InletKind::channel;
}

void read_channel(const Case& scene, const Inlet& inlet, SceneReading& reading) {
  const std::string origin = quoted("inlet", inlet.name);
  const double speed = largest_velocity(inlet, scene.dimension());
  if (gives_velocity(inlet)) {
    reading.inputs.set_if_unknown("velocity", speed, origin);
  } else if (speed > 0) {
    reading.inputs.set_if_unknown("discharge", speed * inlet.extent_up(), origin);
  }
}

void read_jet(const Case& scene, const Inlet& inlet, const Level& bed, SceneReading& reading) {
  const std::string origin = quoted("inlet", inlet.name);
  ScourSubject jet{.kind = ScourKind::wall_jet, .title = "wall jet of " + origin, .nose = {}, .inputs = {}};
  const double speed = largest_velocity(inlet, scene.dimension());
  if (speed > 0) jet.inputs.set("jet-velocity", speed, origin);
  jet.inputs.set("jet-opening", inlet.extent_up(), origin);
  if (speed > 0) jet.inputs.set("discharge", speed * inlet.extent_up(), origin);
  const Level apron = apron_before(scene, inlet);
  if (apron.is_known()) jet.inputs.set("apron", apron.height, apron.origin);
  if (bed.is_known() && std::abs(inlet.lower_edge() - bed.height) > 0.5 * inlet.extent_up()) {
    reading.notes.push_back(
        {fmt::format("{} opens {:.3g} m from the bed's level; formulas for wall jets take it to lie on it", origin,
                     inlet.lower_edge() - bed.height),
         ""});
  }
  reading.subjects.push_back(std::move(jet));
}

void read_fall(const Case& scene, const Inlet& inlet, const Level& water, SceneReading& reading) {
  const std::string origin = quoted("inlet", inlet.name);
  ScourSubject fall{.kind = ScourKind::plunge_pool, .title = "fall of " + origin, .nose = {}, .inputs = {}};
  const double speed = largest_velocity(inlet, scene.dimension());
  if (speed > 0) fall.inputs.set("discharge", speed * inlet.extent_up(), origin);
  const double gravity = scene.domain.gravity.norm();
  const double head = gravity > 0 ? speed * speed / (2 * gravity) : 0;
  const double level = inlet.surface == InletSurface::level ? inlet.level_at(0) : inlet.upper_edge();
  const double drop = level + head - water.height;
  if (!water.is_known()) {
    reading.notes.push_back({origin + " falls on water whose level is not read; give --drop", "drop"});
  } else if (drop > 0) {
    fall.inputs.set("drop", drop, fmt::format("{} with its velocity head over {}", origin, water.origin));
  }
  reading.subjects.push_back(std::move(fall));
}

void read_inlets(const Case& scene, const Level& bed, const Level& water, SceneReading& reading) {
  for (const Inlet& inlet : scene.inlets) {
    switch (kind_of(inlet, bed, water)) {
      case InletKind::channel:
        read_channel(scene, inlet, reading);
        break;
      case InletKind::wall_jet:
        read_jet(scene, inlet, bed, reading);
        break;
      case InletKind::falling:
        read_fall(scene, inlet, water, reading);
        break;
    }
  }
}

void read_drive(const Flow& flow, SceneReading& reading) {
  if (flow.drive == Drive::velocity) reading.inputs.set("velocity", flow.velocity, "[flow]");
  if (flow.drive == Drive::discharge) reading.inputs.set("discharge", flow.discharge, "[flow]");
  if (flow.drive == Drive::slope && flow.slope > 0) reading.inputs.set("slope", flow.slope, "[flow]");
}

}  // namespace

SceneReading read_scene(const Case& scene) {
  SceneReading reading;
  read_bed(scene, reading);
  const Level bed = top_of(scene, ShapeRole::sediment);
  const Level water = tailwater_level(scene);
  read_depth(scene, bed, water, reading);
  read_drive(scene.flow, reading);
  read_inlets(scene, bed, water, reading);
  read_obstacles(scene, bed, reading);
  return reading;
}

std::vector<FormulaRow> formula_rows_of(const SceneReading& reading, const Inputs& given) {
  std::vector<FormulaRow> rows;
  for (ScourSubject subject : reading.subjects) {
    Inputs inputs = reading.inputs;
    inputs.take_over(subject.inputs);
    inputs.take_over(given);
    subject.inputs = inputs;
    derive(subject.inputs);
    for (FormulaRow& row : formula_rows(subject)) rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace thalweg
