#include "gencase/shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "common/error.hpp"
#include "common/units.hpp"
#include "gencase/booleans.hpp"
#include "gencase/combinations.hpp"
#include "gencase/coverage.hpp"
#include "gencase/hollows.hpp"
#include "gencase/places.hpp"
#include "gencase/polygon.hpp"
#include "gencase/polyhedron.hpp"
#include "gencase/primitives.hpp"
#include "gencase/rooms.hpp"
#include "gencase/tessellation.hpp"

namespace thalweg::gencase {
namespace {

[[noreturn]] void refuse(const Case& scene, const Shape& shape, const std::string& what) {
  throw InputError(where(scene, shape) + " " + what);
}

// Largest deviation of triangles from curved shapes, in spacings, if meshes are cut against these.
constexpr double deviation_of_triangles = 0.01;

/// The cut of a cone by the plane through its axis.
RegionPointer make_flat_cone(const Shape& shape) {
  const Vec3 axis = (shape.to - shape.from).normalized();
  const Vec3 away(-axis.z(), 0, axis.x());
  std::vector<Eigen::Vector2d> corners;
  const auto add = [&](const Vec3& p) { corners.emplace_back(p.x(), p.z()); };
  add(shape.from - shape.radius * away);
  if (shape.radius > 0) add(shape.from + shape.radius * away);
  add(shape.to + shape.end_radius * away);
  if (shape.end_radius > 0) add(shape.to - shape.end_radius * away);
  return make_polygon(edges_of(corners));
}

RegionPointer make_prism(const Case& scene, const Shape& shape) {
  if (!is_simple(shape.polygon))
    refuse(scene, shape, "has a polygon that crosses or touches itself; give its corners in order, each once");
  if (scene.info.dimension == 2) return make_polygon(edges_of(shape.polygon));
  return make_polyhedron(
      extrude(counter_clockwise(shape.polygon), static_cast<int>(shape.axis), shape.extent[0], shape.extent[1]));
}

/// A combination of shapes. Throws InputError if meshes among them cannot be cut against each other.
RegionPointer combine_shapes(const Case& scene, const Shape& shape, std::vector<RegionPointer> parts, Boolean how) {
  const bool meshes =
      std::any_of(parts.begin(), parts.end(), [](const RegionPointer& part) { return part->is_mesh(); });
  const RegionPointer pointwise = make_combination(std::move(parts), how);
  // Shapes with a formula of their own need no triangles: their combination is exact as it is.
  if (!meshes || shape.boolean == BooleanMethod::voxel) return pointwise;
  try {
    const auto surface = pointwise->triangles(deviation_of_triangles * scene.numerics.spacing);
    if (!surface) return pointwise;
    if (surface->corners.empty()) refuse(scene, shape, "is empty: its shapes leave nothing; correct or remove it");
    return make_polyhedron(*surface);
  } catch (const NoManifold& error) {
    refuse(
        scene, shape,
        fmt::format("cannot be combined exactly: {}; move or enlarge one of its shapes a little so that they overlap, "
                    "or write boolean = \"voxel\" to combine lattice points",
                    error.what()));
  }
}

/// Adds a placed shape to the room as container, solid or opening; fluids change nothing.
void add_to(FlowRoom& room, const PlacedShape& placed) {
  if (placed.is_container())
    room.add_container(placed.room, placed.body);
  else if (placed.is_wall())
    room.add_solid(placed.body);
  else if (placed.shape->role == ShapeRole::empty)
    room.add_opening(placed.body);
}

/// The earlier shapes of the case, for shapes that refer to them.
struct Earlier {
  std::map<std::string, RegionPointer> named;
  FlowRoom room;                     // that their walls leave to the flow
  std::optional<Bounds> containers;  // of the containers as given; open faces are not extended

  void add(const PlacedShape& placed, const RegionPointer& region) {
    add_to(room, placed);
    if (!placed.is_container()) return;
    const Bounds own = region->bounds();
    if (!containers) containers = own;
    containers->lower = containers->lower.cwiseMin(own.lower);
    containers->upper = containers->upper.cwiseMax(own.upper);
  }
};

void require_heights_along_z(const Case& scene, const Shape& shape) {
  if (column_axis(scene) != 2 || scene.domain.gravity.z() > 0)
    refuse(scene, shape, "counts heights along z, and gravity points elsewhere; use a box");
}

/// The box in which containers can be filled: up to their rims, within the domain.
Bounds filling_box(const Case& scene, const Earlier& earlier) {
  Bounds box{earlier.containers->lower.cwiseMax(scene.domain.from),
             earlier.containers->upper.cwiseMin(scene.domain.to)};
  if (scene.info.dimension == 2) box.lower.y() = box.upper.y() = 0;
  return box;
}

/// The hollows of solid walls, for cases without a container.
RegionPointer make_held(const Case& scene, const Shape& shape, const Earlier& earlier) {
  if (!earlier.room.has_solids())
    refuse(scene, shape, "fills containers, and no wall with side = \"outside\" comes before it; put one before it");
  const bool layer = shape.kind == ShapeKind::layer;
  RegionPointer held =
      layer ? make_hollow_layer(scene, earlier.room, shape.thickness) : make_hollow(scene, earlier.room, shape.level);
  if (held == nullptr)
    refuse(scene, shape,
           fmt::format("finds no hollow that the walls before it hold {}: what it fills would run out; make the walls "
                       "thicker and their gaps narrower than {}, lower the level, or use a box",
                       layer ? std::string("up to their upper end") : "up to " + length_text(shape.level),
                       length_text(scene.numerics.spacing)));
  return held;
}

RegionPointer make_level(const Case& scene, const Shape& shape, const Earlier& earlier) {
  require_heights_along_z(scene, shape);
  if (!earlier.containers) return make_held(scene, shape, earlier);
  Bounds box = filling_box(scene, earlier);
  if (shape.level <= box.lower.z())
    refuse(scene, shape,
           fmt::format("has its level at {}, below the floor at {}; raise the level", length_text(shape.level),
                       length_text(box.lower.z())));
  box.upper.z() = std::min(box.upper.z(), shape.level);
  return make_filled(earlier.room, box);
}

RegionPointer make_bed_layer(const Case& scene, const Shape& shape, const Earlier& earlier) {
  require_heights_along_z(scene, shape);
  if (!earlier.containers) return make_held(scene, shape, earlier);
  return make_layer(earlier.room, filling_box(scene, earlier), shape.thickness, 2);
}

/// The geometry of a shape.
RegionPointer make_region(const Case& scene, const Shape& shape, const Earlier& earlier, double thickness,
                          const Notes& notes) {
  const int dimension = scene.info.dimension;
  std::vector<RegionPointer> parts;
  for (const std::string& name : shape.of) parts.push_back(earlier.named.at(name));
  switch (shape.kind) {
    case ShapeKind::box:
      return make_box(shape.from, shape.to, dimension);
    case ShapeKind::cylinder:
      return dimension == 2 ? make_disc(shape.center, shape.radius) : make_cylinder(shape.from, shape.to, shape.radius);
    case ShapeKind::cone:
      return dimension == 2 ? make_flat_cone(shape) : make_cone(shape.from, shape.to, shape.radius, shape.end_radius);
    case ShapeKind::sphere:
      return dimension == 2 ? make_disc(shape.center, shape.radius) : make_sphere(shape.center, shape.radius);
    case ShapeKind::prism:
      return make_prism(scene, shape);
    case ShapeKind::mesh:
      return make_mesh(scene, shape, thickness, notes);
    case ShapeKind::bathymetry: {
      RegionPointer body = make_bathymetry(scene, shape, notes);
      const bool fluid = shape.role == ShapeRole::water || shape.role == ShapeRole::sediment;
      return fluid ? make_within(earlier.room, std::move(body)) : body;  // a survey is wider than the flume
    }
    case ShapeKind::level:
      return make_level(scene, shape, earlier);
    case ShapeKind::layer:
      return make_bed_layer(scene, shape, earlier);
    case ShapeKind::combine_union:
      return combine_shapes(scene, shape, std::move(parts), Boolean::unite);
    case ShapeKind::combine_difference:
      return combine_shapes(scene, shape, std::move(parts), Boolean::subtract);
    case ShapeKind::combine_intersection:
      return combine_shapes(scene, shape, std::move(parts), Boolean::intersect);
  }
  throw std::logic_error("a kind of shape without geometry");
}

Faces open_faces(const Case& scene, const Shape& shape) {
  Faces open{};
  for (std::size_t face = 0; face < open.size(); ++face)
    open[face] = std::find(shape.open.begin(), shape.open.end(), face_names[face]) != shape.open.end();
  for (const std::string& direction : scene.domain.periodic)
    for (std::size_t face = 0; face < open.size(); ++face)
      if (face_names[face] + 1 == direction && !open[face])
        refuse(scene, shape,
               fmt::format("walls off {0}, in which the domain is periodic; add \"-{0}\" and \"+{0}\" to its `open`",
                           direction));
  return open;
}

double density_at_rest(const Case& scene, const Shape& shape) {
  if (shape.role != ShapeRole::sediment) return scene.water.density;
  return shape.material.empty() ? scene.sediment().bed_density() : scene.sediments.at(shape.material).bed_density();
}

/// The same of the water with the grains that it carries.
double density_with_grains(const Case& scene, const Shape& shape) {
  const double at_rest = density_at_rest(scene, shape);
  if (shape.concentration == 0) return at_rest;
  return at_rest + shape.concentration * (scene.sediment().grain_density - at_rest);
}

void check_extent(const Case& scene, const Shape& shape, const Bounds& bounds) {
  const double spacing = scene.numerics.spacing;
  for (int axis = 0; axis < 3; ++axis) {
    if (scene.info.dimension == 2 && axis == 1) continue;
    const double extent = bounds.upper[axis] - bounds.lower[axis];
    if (extent < spacing * (1 - 1e-9))
      refuse(scene, shape,
             fmt::format(
                 "measures {} in {}, less than the spacing of {}; use a smaller numerics.spacing or a larger shape",
                 length_text(extent), "xyz"[axis], length_text(spacing)));
  }
}

}  // namespace

ParticleType PlacedShape::type() const {
  switch (shape->role) {
    case ShapeRole::water:
      return ParticleType::water;
    case ShapeRole::sediment:
      return ParticleType::sediment;
    case ShapeRole::moving_wall:
      return ParticleType::moving_wall;
    case ShapeRole::wall:
      return ParticleType::wall;
    case ShapeRole::none:
    case ShapeRole::empty:
      break;
  }
  throw std::logic_error("a shape without particles has no type");
}

double kernel_support(const Case& scene) { return 2 * scene.smoothing_length(); }

int column_axis(const Case& scene) {
  int strongest = 2;
  for (int axis : {0, 1})
    if (std::abs(scene.domain.gravity[axis]) > std::abs(scene.domain.gravity[strongest])) strongest = axis;
  return strongest;
}

std::vector<PlacedShape> place_shapes(const Case& scene, const Notes& notes) {
  Earlier earlier;
  std::vector<PlacedShape> placed;
  for (const Shape& shape : scene.shapes) {
    const double spacing = scene.numerics.spacing;
    // Whole layers, so that the support of a particle at the wall is filled.
    const double layers = std::ceil(kernel_support(scene) / spacing - 1e-6) * spacing;
    const double thickness = shape.thickness > 0 ? shape.thickness : layers;
    const RegionPointer region = make_region(scene, shape, earlier, thickness, notes);
    earlier.named[shape.name] = region;
    if (shape.role == ShapeRole::none) continue;
    PlacedShape result{
        &shape, region, nullptr, thickness, density_at_rest(scene, shape), density_with_grains(scene, shape)};
    check_extent(scene, shape, region->bounds());
    if (result.is_wall() && shape.side == WallSide::outside) {
      if (shape.kind == ShapeKind::box) {
        const Faces open = open_faces(scene, shape);
        result.room = make_open_box(shape.from, shape.to, open, scene.info.dimension);
        result.body = make_container_wall(shape.from, shape.to, open, thickness, scene.info.dimension);
      } else {
        if (region->is_mesh()) check_container(scene, shape, *region);
        result.room = region;
        result.body = make_shell(region, thickness, scene.info.dimension);
      }
    }
    earlier.add(result, region);
    placed.push_back(std::move(result));
  }
  return placed;
}

FlowRoom flow_room(const std::vector<PlacedShape>& shapes) {
  FlowRoom room;
  for (const PlacedShape& placed : shapes) add_to(room, placed);
  return room;
}

FlowRoom flow_room(const std::vector<PlacedShape>& shapes, const std::string& motion) {
  FlowRoom room;
  for (const PlacedShape& placed : shapes) {
    const bool opening = placed.shape->role == ShapeRole::empty;
    if (placed.shape->motion == motion || opening) add_to(room, placed);
  }
  return room;
}

}  // namespace thalweg::gencase
