#include "case/case.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/error.hpp"

namespace thalweg {

bool Case::has_sediment() const {
  return std::any_of(shapes.begin(), shapes.end(),
                     [](const Shape& shape) { return shape.role == ShapeRole::sediment || shape.concentration > 0; });
}

bool Case::has_water() const {
  return std::any_of(shapes.begin(), shapes.end(), [](const Shape& shape) { return shape.role == ShapeRole::water; });
}

bool Case::has_concentration() const {
  return std::any_of(shapes.begin(), shapes.end(), [](const Shape& shape) { return shape.concentration > 0; });
}

bool Case::has_lasting_current() const { return flow.drive != Drive::off || !inlets.empty(); }

bool Case::has_rough_walls() const {
  return std::any_of(shapes.begin(), shapes.end(), [](const Shape& shape) { return shape.roughness > 0; });
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

}  // namespace thalweg
