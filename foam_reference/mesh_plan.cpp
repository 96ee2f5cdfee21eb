#include "foam_reference/mesh_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "case/models/surface_bed.hpp"
#include "common/error.hpp"
#include "common/units.hpp"
#include "foam_reference/current_block.hpp"
#include "foam_reference/openings.hpp"

namespace thalweg::foam {
namespace {

constexpr std::array<const char*, 6> face_names{"-x", "+x", "-y", "+y", "-z", "+z"};
constexpr double largest_block = 2e8;  // cells; their fields take about 200 GB, more than the memory of one machine

void check_kind(const Case& scene, const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::box:
    case ShapeKind::cylinder:
    case ShapeKind::sphere:
    case ShapeKind::combine_union:
    case ShapeKind::combine_difference:
    case ShapeKind::combine_intersection:
    case ShapeKind::level:
    case ShapeKind::layer:
      return;
    case ShapeKind::mesh:
      if (is_meshed_solid(scene, shape)) return;
      throw InputError(place(scene, shape) +
                       ": the mesh model takes a mesh as a solid wall in 3-D only, from an STL or "
                       "OBJ file and not turned (\"" +
                       shape.name + "\"); run this case with --no-foam");
    case ShapeKind::cone:
    case ShapeKind::prism:
    case ShapeKind::bathymetry:
      break;
  }
  throw InputError(place(scene, shape) + ": shape \"" + shape.name +
                   "\" is of a kind the mesh model does not have (it takes box, cylinder, sphere, level, layer, "
                   "mesh and combinations); run this case with --no-foam");
}

// The container; nullptr in a scene with a current that has none.
const Shape* find_container(const Case& scene) {
  const Shape* container = nullptr;
  for (const Shape& shape : scene.shapes) {
    if (shape.role == ShapeRole::moving_wall) {
      throw InputError(place(scene, shape) + ": shape \"" + shape.name +
                       "\" is a moving wall, which the mesh model does not have; run this case with --no-foam");
    }
    check_kind(scene, shape);
    if (!is_container(shape)) continue;
    if (container != nullptr) {
      throw InputError(place(scene, shape) + ": \"" + shape.name + "\" is a second container beside \"" +
                       container->name + "\"; the mesh model takes one wall shape with side = \"outside\"");
    }
    if (shape.kind != ShapeKind::box) {
      throw InputError(place(scene, shape) + ": the container \"" + shape.name +
                       "\" is not a box; the mesh model fills boxes only: use kind = \"box\" and solid wall shapes");
    }
    container = &shape;
  }
  if (container != nullptr || has_current(scene)) return container;
  throw InputError(place(scene) +
                   ": no container; the mesh model needs a wall shape with kind = \"box\" and side = \"outside\"");
}

std::array<Face, 6> face_kinds(const Case& scene, const Shape& container) {
  std::array<Face, 6> faces{};
  faces.fill(Face::wall);
  for (const std::string& name : container.open) {
    const auto found = std::ranges::find(face_names, name);
    if (found == face_names.end()) {
      throw InputError(place(scene, container) + ": unknown face \"" + name + "\" in `open` of \"" + container.name +
                       "\"; use any of \"-x\", \"+x\", \"-y\", \"+y\", \"-z\", \"+z\"");
    }
    faces[static_cast<std::size_t>(found - face_names.begin())] = Face::open;
  }
  for (const std::string& direction : scene.domain.periodic) {
    const std::size_t axis = direction == "x" ? 0 : direction == "y" ? 1 : 2;
    faces[2 * axis] = faces[2 * axis + 1] = Face::periodic;
  }
  if (scene.info.dimension == 2) faces[2] = faces[3] = Face::unused;
  return faces;
}

double highest_fluid(const Case& scene) {
  std::optional<double> highest;
  for (const Shape& shape : scene.shapes) {
    if (shape.role != ShapeRole::water && shape.role != ShapeRole::sediment) continue;
    const double top = bounds_of(scene, shape).high.z();
    highest = std::max(highest.value_or(top), top);
  }
  if (highest) return *highest;
  throw InputError(place(scene) + ": no water and no sediment; give at least one [[shape]] the role \"water\"");
}

void check_gravity(const Case& scene) {
  const Vec3& g = scene.domain.gravity;
  if (g.z() < 0 && std::abs(g.z()) >= g.head<2>().norm()) return;
  throw InputError(place(scene) +
                   ": gravity does not point down; the mesh model integrates columns along z: give domain.gravity a "
                   "negative z component that is its largest");
}

void check_surface_bed(const Case& scene) {
  if (!models::SurfaceBedOfCase::is_on(scene) || scene.surface_bed.factor == 1) return;
  throw InputError(
      place(scene) +
      ": the bed's time runs faster than the water's (surface_bed.factor), and the mesh model's bed keeps to "
      "the water's; give surface_bed.factor = 1 to compare them, or leave the mesh model out (--no-foam)");
}

void check_resolution(const Case& scene, const MeshPlan& plan) {
  for (const std::size_t axis : {0U, 1U, 2U}) {
    if (plan.faces[2 * axis] == Face::unused || plan.cells[axis] >= 2) continue;
    throw InputError(fmt::format("{}: cells of {} leave fewer than 2 along {}; use a smaller foam.cell (--cell)",
                                 place(scene), format_quantity(plan.cell, "m"), "xyz"[axis]));
  }
  const double count =
      static_cast<double>(plan.cells[0]) * static_cast<double>(plan.cells[1]) * static_cast<double>(plan.cells[2]);
  if (count <= largest_block) return;
  throw InputError(fmt::format("{}: cells of {} make a mesh of {:.3g} cells; use a larger foam.cell (--cell)",
                               place(scene), format_quantity(plan.cell, "m"), count));
}

MeshPlan plan_container(const Case& scene, const Shape& container) {
  MeshPlan plan;
  plan.cell = cell_size(scene);
  plan.faces = face_kinds(scene, container);
  plan.low = container.from;
  plan.high = container.to;
  for (const int axis : {0, 1, 2}) {
    if (plan.faces[2 * static_cast<std::size_t>(axis)] != Face::periodic) continue;
    plan.low[axis] = scene.domain.from[axis];
    plan.high[axis] = scene.domain.to[axis];
  }
  if (scene.info.dimension == 2) {
    plan.low.y() = -0.5;
    plan.high.y() = 0.5;
  }
  if (plan.faces[5] == Face::open) {
    const double top = highest_fluid(scene);
    const double above = scene.foam.open_above > 0 ? scene.foam.open_above : 0.5 * (top - plan.low.z());
    // Whole cells of the wanted size. The 1e-9 keeps a height that is a whole number of cells from gaining one.
    plan.high.z() = plan.low.z() + plan.cell * std::ceil((top + above - plan.low.z()) / plan.cell - 1e-9);
  }
  count_cells(scene, plan);
  return plan;
}

}  // namespace

Vec3 MeshPlan::size() const {
  return (high - low)
      .cwiseQuotient(Vec3(static_cast<double>(cells[0]), static_cast<double>(cells[1]), static_cast<double>(cells[2])));
}

bool MeshPlan::open(Face kind) const { return std::ranges::find(faces, kind) != faces.end(); }

double cell_size(const Case& scene) { return scene.foam.cell > 0 ? scene.foam.cell : 2 * scene.numerics.spacing; }

void count_cells(const Case& scene, MeshPlan& plan) {
  for (const std::size_t axis : {0U, 1U, 2U}) {
    if (plan.faces[2 * axis] == Face::unused) continue;
    const double length = plan.high[static_cast<int>(axis)] - plan.low[static_cast<int>(axis)];
    plan.cells[axis] = std::llround(length / plan.cell);
  }
  check_resolution(scene, plan);
}

MeshPlan plan_mesh(const Case& scene) {
  const Shape* container = find_container(scene);
  check_gravity(scene);
  check_surface_bed(scene);
  MeshPlan plan = container != nullptr ? plan_container(scene, *container) : plan_current(scene);
  check_openings(scene, plan);
  plan.has_solids = std::ranges::any_of(scene.shapes, [&](const Shape& shape) {
    return shape.role == ShapeRole::wall && !is_container(shape) && !is_meshed_solid(scene, shape);
  });
  plan.has_surfaces =
      std::ranges::any_of(scene.shapes, [&](const Shape& shape) { return is_meshed_solid(scene, shape); });
  return plan;
}

SceneContents measure_contents(const Case& scene, const MeshPlan& plan) {
  const int points = scene.info.dimension == 2 ? 4 : 2;  // in a cell, along each direction
  const int across = plan.faces[2] == Face::unused ? 1 : points;
  const Vec3 step = plan.size().cwiseQuotient(Vec3(points, across, points));
  const double sample = step.prod();

  SceneContents contents;
  double columns_with_sediment = 0;
  for (std::int64_t i = 0; i < plan.cells[0] * points; ++i) {
    for (std::int64_t j = 0; j < plan.cells[1] * across; ++j) {
      double sediment = 0;
      bool wet = false;
      for (std::int64_t k = 0; k < plan.cells[2] * points; ++k) {
        const Vec3 index(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
        const Material material = material_at(scene, plan.low + (index.array() + 0.5).matrix().cwiseProduct(step));
        if (material == Material::water) contents.water_volume += sample;
        wet = wet || material == Material::water;
        if (material == Material::sediment) sediment += sample;
      }
      contents.sediment_volume += sediment;
      if (wet) contents.water_area += step.x() * step.y();
      if (sediment > 0) ++columns_with_sediment;
    }
  }
  if (columns_with_sediment > 0) {
    contents.bed_thickness = contents.sediment_volume / (columns_with_sediment * step.x() * step.y());
  }
  if (contents.water_volume + contents.sediment_volume <= 0 && scene.inlets.empty()) {
    throw InputError(place(scene) + ": water and sediment lie outside the container; move the shapes inside it");
  }
  return contents;
}

}  // namespace thalweg::foam
