#include "case/case.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "case/reader/tables.hpp"
#include "common/error.hpp"

namespace thalweg {

Numerics numerics_at(Accuracy accuracy) {
  Numerics numerics;
  numerics.accuracy = accuracy;
  switch (accuracy) {
    case Accuracy::draft:
      numerics.cfl = 0.7;
      numerics.sound_speed_factor = 7;
      break;
    case Accuracy::standard:
      break;
    case Accuracy::fine:
      numerics.sound_speed_factor = 20;
      break;
  }
  return numerics;
}

bool Case::has_sediment() const {
  return std::any_of(shapes.begin(), shapes.end(),
                     [](const Shape& shape) { return shape.role == ShapeRole::sediment; });
}

const SedimentParameters& Case::sediment() const {
  if (sediments.empty()) {
    throw InputError(fmt::format("{}: no sediment is defined; add a table [materials.<name>]", file.string()));
  }
  if (sediments.size() > 1) {
    throw InputError(fmt::format("{}: {} sediments are defined, and the model takes one; remove the others",
                                 file.string(), sediments.size()));
  }
  return sediments.begin()->second;
}

bool shape_uses_key(const Shape& shape, std::string_view key, int dimension) {
  const bool is_wall = shape.role == ShapeRole::wall || shape.role == ShapeRole::moving_wall;
  if (key == "name" || key == "kind" || key == "role") return true;
  if (key == "material") return shape.role == ShapeRole::sediment;
  if (key == "motion") return shape.role == ShapeRole::moving_wall;
  const bool from_file = shape.kind == ShapeKind::mesh || shape.kind == ShapeKind::bathymetry;
  const bool combined = shape.kind == ShapeKind::combine_union || shape.kind == ShapeKind::combine_difference ||
                        shape.kind == ShapeKind::combine_intersection;
  if (key == "side") return is_wall;
  if (key == "thickness") return is_wall || shape.kind == ShapeKind::layer;
  if (key == "open") return is_wall && shape.kind == ShapeKind::box && shape.side == WallSide::outside;
  if (key == "scale" || key == "rotate" || key == "move" || key == "repair") return from_file;
  if (key == "end_radius") return shape.kind == ShapeKind::cone;
  if (key == "axis") return shape.kind == ShapeKind::prism && dimension == 3;
  if (key == "boolean") return combined;
  const std::vector<std::string> geometry = shape_needs_keys(shape, dimension);
  return std::find(geometry.begin(), geometry.end(), key) != geometry.end();
}

std::vector<std::string> shape_needs_keys(const Shape& shape, int dimension) {
  switch (shape.kind) {
    case ShapeKind::box:
      return {"from", "to"};
    case ShapeKind::cylinder:
      if (dimension == 2) return {"center", "radius"};
      return {"from", "to", "radius"};
    case ShapeKind::cone:
      return {"from", "to", "radius"};
    case ShapeKind::sphere:
      return {"center", "radius"};
    case ShapeKind::prism:
      if (dimension == 2) return {"polygon"};
      return {"polygon", "extent"};
    case ShapeKind::mesh:
      return {"file"};
    case ShapeKind::bathymetry:
      return {"file", "base"};
    case ShapeKind::level:
      return {"level"};
    case ShapeKind::layer:
      return {"thickness"};
    case ShapeKind::combine_union:
    case ShapeKind::combine_difference:
    case ShapeKind::combine_intersection:
      return {"of"};
  }
  return {};
}

bool motion_uses_key(const Motion& motion, std::string_view key, int dimension) {
  if (key == "name" || key == "kind") return true;
  const bool by_table = motion.kind == MotionKind::piecewise_linear || motion.kind == MotionKind::rotation;
  if (key == "times" || key == "file") return by_table;
  if (key == "displacements") return motion.kind == MotionKind::piecewise_linear;
  if (key == "angles" || key == "angular_speed" || key == "center") return motion.kind == MotionKind::rotation;
  if (key == "axis") return motion.kind == MotionKind::rotation && dimension == 3;
  if (key == "direction") return motion.kind != MotionKind::rotation;
  if (key == "start") return motion.kind != MotionKind::piecewise_linear;
  if (key == "speed" || key == "acceleration" || key == "distance") return motion.kind == MotionKind::gate_lift;
  return motion.kind == MotionKind::oscillation;  // amplitude, period
}

std::vector<std::string> motion_needs_keys(const Motion& motion, int dimension) {
  switch (motion.kind) {
    case MotionKind::piecewise_linear:
    case MotionKind::gate_lift:
      return {"direction"};
    case MotionKind::rotation:
      if (dimension == 2) return {"center"};
      return {"center", "axis"};
    case MotionKind::oscillation:
      return {"direction", "amplitude", "period"};
  }
  return {};
}

bool gauge_uses_key(const Gauge& gauge, std::string_view key) {
  if (key == "at") return gauge.kind != GaugeKind::flux;
  if (key == "from" || key == "to") return gauge.kind == GaugeKind::flux;
  return true;
}

}  // namespace thalweg
