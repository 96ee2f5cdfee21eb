#include "gencase/lattice.hpp"

#include <fmt/format.h>

#include "common/error.hpp"
#include "common/units.hpp"
#include "gencase/places.hpp"
#include "gencase/primitives.hpp"

namespace thalweg::gencase {
namespace {

// Distance from the lattice, in spacings, up to which faces and periods count as lying on it.
constexpr double tolerated_offset = 0.01;

}  // namespace

Vec3 Lattice::position(const Index3& offset) const {
  Vec3 result;
  for (int axis = 0; axis < 3; ++axis)
    result[axis] = anchor[axis] + (static_cast<double>(first[axis] + offset[axis]) + 0.5) * spacing;
  if (dimension == 2) result.y() = 0;
  return result;
}

Index3 Lattice::offset(std::int64_t flat_index) const {
  Index3 result{};
  for (int place = 2; place >= 0; --place) {
    result[axes[place]] = flat_index % count[axes[place]];
    flat_index /= count[axes[place]];
  }
  return result;
}

ColumnRange columns_within(const Lattice& lattice, const Bounds& bounds) {
  ColumnRange range;
  for (int axis = 0; axis < 3; ++axis) {
    range.end[axis] = lattice.count[axis];
    if (lattice.dimension == 2 && axis == 1) continue;
    const double low =
        (bounds.lower[axis] - lattice.anchor[axis]) / lattice.spacing - static_cast<double>(lattice.first[axis]);
    const double high =
        (bounds.upper[axis] - lattice.anchor[axis]) / lattice.spacing - static_cast<double>(lattice.first[axis]);
    const auto length = static_cast<double>(lattice.count[axis]);
    range.begin[axis] = static_cast<std::int64_t>(std::clamp(std::floor(low) - 1, 0.0, length));
    range.end[axis] = static_cast<std::int64_t>(std::clamp(std::ceil(high) + 1, 0.0, length));
  }
  return range;
}

Line line_of(const Lattice& lattice, std::int64_t column, const Vec3& nudge) {
  const Vec3 first = lattice.position(lattice.offset(column * lattice.column_length())) + nudge;
  const int axis = lattice.axes[2];
  return {first, axis, first[axis], lattice.spacing, lattice.column_length()};
}

namespace {

Vec3 anchor_of(const Case& scene, const std::vector<PlacedShape>& shapes) {
  switch (scene.gencase.anchor) {
    case LatticeAnchor::point:
      return scene.gencase.anchor_point;
    case LatticeAnchor::domain:
      return scene.domain.from;
    case LatticeAnchor::walls:
      break;
  }
  const auto container =
      std::find_if(shapes.begin(), shapes.end(), [](const PlacedShape& shape) { return shape.is_container(); });
  if (container == shapes.end()) return scene.domain.from;
  return container->shape->kind == ShapeKind::box ? container->shape->from : container->room->bounds().lower;
}

}  // namespace

Lattice make_lattice(const Case& scene, const std::vector<PlacedShape>& shapes, double spacing) {
  Lattice lattice;
  lattice.spacing = spacing;
  lattice.dimension = scene.info.dimension;
  lattice.anchor = anchor_of(scene, shapes);
  const int along = column_axis(scene);
  lattice.axes = along == 2 ? std::array{0, 1, 2} : (along == 0 ? std::array{1, 2, 0} : std::array{0, 2, 1});

  for (int axis = 0; axis < 3; ++axis) {
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (const PlacedShape& shape : shapes) {
      if (shape.shape->role == ShapeRole::empty) continue;
      low = std::min(low, shape.body->bounds().lower[axis]);
      high = std::max(high, shape.body->bounds().upper[axis]);
    }
    const double first = std::floor((low - lattice.anchor[axis]) / spacing);
    const double count = std::ceil((high - lattice.anchor[axis]) / spacing) - first;
    if (!(count < 1e6))  // also keeps the product of three within 64 bits
      throw InputError(
          fmt::format("{}: the shapes stretch over {:.3g} spacings in {}; use a larger numerics.spacing, "
                      "or check the shapes' coordinates and units",
                      scene.file.string(), count, "xyz"[axis]));
    lattice.first[axis] = static_cast<std::int64_t>(first);
    lattice.count[axis] = std::max<std::int64_t>(static_cast<std::int64_t>(count), 1);
  }
  if (lattice.dimension == 2) {
    lattice.first[1] = 0;
    lattice.count[1] = 1;
  }
  return lattice;
}

void check_periods(const Case& scene) {
  const double spacing = scene.numerics.spacing;
  for (int axis = 0; axis < 3; ++axis) {
    if (!scene.domain.is_periodic(axis)) continue;
    const double length = scene.domain.to[axis] - scene.domain.from[axis];
    const double cells = length / spacing;
    if (std::abs(cells - std::round(cells)) <= tolerated_offset) continue;
    throw InputError(fmt::format(
        "{}: the domain is periodic in {} and {} long, no multiple of the spacing of {}; make "
        "it {} or {} long",
        scene.file.string(), "xyz"[axis], placed_text(length, spacing), format_quantity(spacing, "m"),
        placed_text(std::floor(cells) * spacing, spacing), placed_text(std::ceil(cells) * spacing, spacing)));
  }
}

std::vector<std::string> faces_off_lattice(const Case& scene, const Lattice& lattice) {
  std::vector<std::string> lines;
  for (const Shape& shape : scene.shapes) {
    if (shape.kind != ShapeKind::box) continue;
    for (int face = 0; face < 6; ++face) {
      const int axis = face / 2;
      if (lattice.dimension == 2 && axis == 1) continue;
      const double place = face % 2 ? shape.to[axis] : shape.from[axis];
      const double layers = (place - lattice.anchor[axis]) / lattice.spacing;
      const double off = (layers - std::round(layers)) * lattice.spacing;
      if (std::abs(off) <= tolerated_offset * lattice.spacing) continue;
      lines.push_back(
          fmt::format("{}: face {} at {} lies {} off the lattice (spacing {} from {}); {} or {} would lie on it",
                      where(scene, shape), face_names[face], placed_text(place, lattice.spacing),
                      format_quantity(std::abs(off), "m"), format_quantity(lattice.spacing, "m"),
                      placed_text(lattice.anchor[axis], lattice.spacing),
                      placed_text(lattice.anchor[axis] + std::floor(layers) * lattice.spacing, lattice.spacing),
                      placed_text(lattice.anchor[axis] + std::ceil(layers) * lattice.spacing, lattice.spacing)));
    }
  }
  return lines;
}

}  // namespace thalweg::gencase
