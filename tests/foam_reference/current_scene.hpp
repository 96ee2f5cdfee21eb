#pragma once

#include "tests/foam_reference/small_scene.hpp"

namespace thalweg::foam {

/// One period of 0.2 m of a flume with a rough floor under 0.1 m of water; no container; cells of 10 mm. The slope gives
/// u* = sqrt(9.81 x 0.1 x 0.00197) = 43.96 mm/s.
inline Case flume() {
  Case scene;
  scene.file = "flume/case.toml";
  scene.info.name = "flume";
  scene.domain.from = Vec3(0, 0, -0.1);
  scene.domain.to = Vec3(0.2, 0, 0.2);
  scene.domain.periodic = {"x"};
  scene.shapes = {box("floor", ShapeRole::wall, Vec3(0, 0, -0.1), Vec3(0.2, 0, 0)),
                  box("water", ShapeRole::water, Vec3(0, 0, 0), Vec3(0.2, 0, 0.1))};
  scene.shapes.front().roughness = 1e-3;
  scene.model.wall_friction = WallFriction::rough;
  scene.model.turbulence = Turbulence::mixing_length;
  scene.flow.drive = Drive::slope;
  scene.flow.slope = 0.00197;
  scene.flow.start = FlowStart::log_law;
  scene.numerics.spacing = 0.005;
  scene.foam.cell = 0.01;
  scene.foam.turbulence = FoamTurbulence::k_omega;
  scene.output.end = 1;
  scene.output.interval = 0.5;
  scene.compare.times = {1};
  return scene;
}

/// A channel of 0.6 m between an inlet that follows the level of the scene (0.04 m^2/s, log law) and a tail water at
/// 0.1 m; its floor is 20 mm thick and the domain reaches further down; cells of 20 mm.
inline Case channel() {
  Case scene = flume();
  scene.domain.from = Vec3(-0.2, 0, -0.1);
  scene.domain.to = Vec3(0.8, 0, 0.3);
  scene.domain.periodic.clear();
  scene.shapes.front().from = Vec3(-0.2, 0, -0.02);
  scene.shapes.front().to = Vec3(0.8, 0, 0);
  scene.shapes.back().from.x() = -0.2;
  scene.shapes.back().to.x() = 0.7;
  scene.flow = Flow();
  scene.flow.start = FlowStart::log_law;
  scene.flow.discharge = 0.04;
  Inlet west;
  west.name = "west";
  west.at = Vec3(0, 0, 0.1);
  west.direction = Vec3::UnitX();
  west.height = 0.2;
  west.discharge = 0.04;
  west.surface = InletSurface::follow;
  west.profile = InletProfile::log_law;
  west.roughness = 1e-3;
  Outlet east;
  east.name = "east";
  east.at = Vec3(0.6, 0, 0.1);
  east.direction = Vec3::UnitX();
  east.height = 0.2;
  east.kind = OutletKind::level;
  east.level = 0.1;
  scene.inlets = {west};
  scene.outlets = {east};
  scene.foam.cell = 0.02;
  return scene;
}

/// The channel under 0.2 m of tail water, fed at 1 m/s through a slot of 40 mm under a gate that stands behind the inlet's
/// plane.
inline Case sluice() {
  Case scene = channel();
  scene.shapes.push_back(box("gate", ShapeRole::wall, Vec3(-0.2, 0, 0.04), Vec3(0, 0, 0.4)));
  scene.shapes[1].from.x() = 0;
  scene.shapes[1].to.z() = 0.2;
  scene.flow = Flow();
  Inlet& slot = scene.inlets[0];
  slot.at.z() = 0.02;
  slot.height = 0.04;
  slot.discharge = 0;
  slot.velocity = 1;
  slot.surface = InletSurface::full;
  slot.profile = InletProfile::uniform;
  scene.outlets[0].at.z() = 0.13;
  scene.outlets[0].height = 0.26;
  scene.outlets[0].level = 0.2;
  return scene;
}

}  // namespace thalweg::foam
