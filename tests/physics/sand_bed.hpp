#pragma once

#include <cmath>

#include "physics/bed/grains.hpp"

namespace thalweg::test {

/// Sand of 1 mm.
inline Grains sand() {
  Grains of;
  of.density = 2650;
  of.diameter = 0.001;
  of.porosity = 0.4;
  of.tan_friction = std::tan(32 * M_PI / 180);
  of.lift_ratio = 0.85;
  of.roughness = 0.0025;
  of.critical_shields = 0.047;
  of.water_density = 1000;
  of.water_viscosity = 1e-6;
  of.gravity = 9.81;
  return of;
}

/// A flat bed; width [m] of its columns, thickness [m].
inline GrainColumns bed_of(int nx, int ny, double width, const Grains& of, double thickness) {
  GrainColumns bed;
  bed.grid = {nx, ny, width, ny > 1 ? width : 1.0, false, false};
  bed.packing = 1 - of.porosity;
  const auto columns = static_cast<std::size_t>(bed.grid.columns());
  bed.area.assign(columns, bed.grid.dx * bed.grid.dy);
  bed.floor.assign(columns, 0.0);
  bed.grains.assign(columns, bed.packing * bed.area[0] * thickness);
  return bed;
}

}  // namespace thalweg::test
