#include "case/tables/shape.hpp"

#include <algorithm>

#include "case/case.hpp"

namespace thalweg {
namespace {

bool is_wall(ShapeRole role) {
  switch (role) {
    case ShapeRole::wall:
    case ShapeRole::moving_wall:
      return true;
    case ShapeRole::none:
    case ShapeRole::water:
    case ShapeRole::sediment:
    case ShapeRole::empty:
      return false;
  }
  return false;
}

/// Properties that several kinds of shape share.
struct KindTraits {
  bool from_file = false;
  bool combined = false;
};

KindTraits traits_of(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::mesh:
    case ShapeKind::bathymetry:
      return {.from_file = true};
    case ShapeKind::combine_union:
    case ShapeKind::combine_difference:
    case ShapeKind::combine_intersection:
      return {.combined = true};
    case ShapeKind::box:
    case ShapeKind::cylinder:
    case ShapeKind::cone:
    case ShapeKind::sphere:
    case ShapeKind::prism:
    case ShapeKind::level:
    case ShapeKind::layer:
      return {};
  }
  return {};
}

}  // namespace

bool Shape::uses_key(std::string_view key, int dimension) const {
  if (key == "name" || key == "kind" || key == "role") return true;
  if (key == "material") return role == ShapeRole::sediment;
  if (key == "concentration") return role == ShapeRole::water;
  if (key == "motion") return role == ShapeRole::moving_wall;
  if (key == "side" || key == "roughness") return is_wall(role);
  if (key == "thickness") return is_wall(role) || kind == ShapeKind::layer;
  if (key == "open") return is_wall(role) && kind == ShapeKind::box && side == WallSide::outside;
  if (key == "scale" || key == "rotate" || key == "move" || key == "repair") return traits_of(kind).from_file;
  if (key == "end_radius") return kind == ShapeKind::cone;
  if (key == "axis") return kind == ShapeKind::prism && dimension == 3;
  if (key == "boolean") return traits_of(kind).combined;
  const std::vector<std::string> geometry = needs_keys(dimension);
  return std::find(geometry.begin(), geometry.end(), key) != geometry.end();
}

std::vector<std::string> Shape::needs_keys(int dimension) const {
  switch (kind) {
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

void Shape::complete(const Case& whole) {
  const bool only_one = whole.sediments.size() == 1;
  if (only_one && role == ShapeRole::sediment && material.empty()) material = whole.sediments.begin()->first;
}

std::vector<std::string> Shape::hashed_files() const {
  if (file.empty()) return {};
  return {file};
}

Shape Shape::without_defaults() {
  Shape shape;
  shape.from = shape.to = shape.center = Vec3::Constant(required);
  shape.radius = required;
  return shape;
}

}  // namespace thalweg
