#pragma once

#include <numbers>
#include <string>

#include "case/case.hpp"

namespace thalweg::foam {

inline Shape box(const std::string& name, ShapeRole role, const Vec3& from, const Vec3& to) {
  Shape shape;
  shape.name = name;
  shape.role = role;
  shape.from = from;
  shape.to = to;
  return shape;
}

/// A tank of 0.4 m x 0.2 m, open above, with 0.05 m of bed under 0.05 m of water; cells of 10 mm, 0.1 s.
inline Case still_tank() {
  Case scene;
  scene.file = "tank/case.toml";
  scene.info.name = "tank";
  scene.domain.from = Vec3(-0.1, 0, -0.1);
  scene.domain.to = Vec3(0.5, 0, 0.3);
  Shape container = box("tank", ShapeRole::wall, Vec3(0, 0, 0), Vec3(0.4, 0, 0.2));
  container.side = WallSide::outside;
  container.open = {"+z"};
  container.line = 7;
  scene.shapes = {container, box("bed", ShapeRole::sediment, Vec3(0, 0, 0), Vec3(0.4, 0, 0.05)),
                  box("pool", ShapeRole::water, Vec3(0, 0, 0.05), Vec3(0.4, 0, 0.1))};
  SedimentParameters sand;
  sand.grain_density = 1600;
  sand.porosity = 0.5;
  sand.grain_diameter = 0.002;
  sand.friction_angle = std::numbers::pi / 6;
  scene.sediments["sand"] = sand;
  scene.model.sediment = SedimentModel::viscoplastic;
  scene.numerics.spacing = 0.005;
  scene.output.end = 0.1;
  scene.compare.times = {0.05, 0.1};
  scene.foam.cell = 0.01;
  return scene;
}

/// The same tank without bed, water from the floor to 0.1 m.
inline Case water_tank() {
  Case scene = still_tank();
  scene.sediments.clear();
  scene.model.sediment = SedimentModel::off;
  scene.shapes.erase(scene.shapes.begin() + 1);
  scene.shapes[1].from.z() = 0;
  return scene;
}

}  // namespace thalweg::foam
