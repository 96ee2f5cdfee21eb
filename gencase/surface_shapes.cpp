#include "gencase/surface_shapes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "common/error.hpp"
#include "common/units.hpp"
#include "gencase/height_field.hpp"
#include "gencase/mesh_bodies.hpp"
#include "gencase/mesh_defects.hpp"
#include "gencase/mesh_reader.hpp"
#include "gencase/mesh_repair.hpp"
#include "gencase/mesh_sheets.hpp"
#include "gencase/places.hpp"
#include "gencase/polygon.hpp"
#include "gencase/polyhedron.hpp"
#include "gencase/survey_reader.hpp"
#include "gencase/tessellation.hpp"

namespace thalweg::gencase {
namespace {

std::string place(const Case& scene, const Vec3& p) {
  const auto text = [&](double metres) { return placed_text(metres, scene.numerics.spacing); };
  return fmt::format("x = {}, y = {}, z = {}", text(p.x()), text(p.y()), text(p.z()));
}

/// "case.toml:12: shape "pier": pier.stl".
std::string begin_of(const Case& scene, const Shape& shape) { return where(scene, shape) + ": " + shape.file; }

[[noreturn]] void refuse_surface(const Case& scene, const Shape& shape, const std::string& what) {
  throw InputError(begin_of(scene, shape) + " " + what);
}

Vec3 placed(const Shape& shape, const Vec3& p) {
  Vec3 result = shape.scale * p;
  for (int axis = 0; axis < 3 && !shape.rotate.empty(); ++axis)
    result = Eigen::AngleAxisd(shape.rotate[static_cast<std::size_t>(axis)], Vec3::Unit(axis)) * result;
  if (!shape.move.empty()) result += Vec3(shape.move[0], shape.move[1], shape.move[2]);
  return result;
}

Triangles read_surface(const Case& scene, const Shape& shape, const Notes& notes) {
  Triangles surface;
  try {
    const MeshFile file = read_mesh(scene.folder / shape.file);
    for (const std::string& remark : file.remarks) notes.say(fmt::format("{}: {}", begin_of(scene, shape), remark));
    surface = triangulate(file.soup);
  } catch (const InputError& error) {
    throw InputError(where(scene, shape) + ": " + error.what());
  }
  for (Vec3& p : surface.points) p = placed(shape, p);
  return surface;
}

/// Refuses a body that is far larger than the domain and would fit if its numbers were millimetres.
void check_unit(const Case& scene, const Shape& shape, const Bounds& bounds) {
  Vec3 domain = scene.domain.to - scene.domain.from;
  Vec3 body = bounds.upper - bounds.lower;
  if (scene.info.dimension == 2) domain.y() = body.y() = 0;
  constexpr double far_larger = 20;
  constexpr double thousandth = 1e-3;
  if (body.maxCoeff() < far_larger * domain.maxCoeff() || thousandth * body.maxCoeff() > domain.maxCoeff()) return;
  refuse_surface(scene, shape,
                 fmt::format("measures {} and the domain {}: its numbers look like millimetres; write scale = {}",
                             length_text(body.maxCoeff()), length_text(domain.maxCoeff()), shape.scale * thousandth));
}

void check_inside_domain(const Case& scene, const Shape& shape, const Bounds& bounds) {
  const auto text = [&](double metres) { return placed_text(metres, scene.numerics.spacing); };
  for (int axis = 0; axis < 3; ++axis) {
    if (scene.info.dimension == 2 && axis == 1) continue;
    if (bounds.upper[axis] > scene.domain.from[axis] && bounds.lower[axis] < scene.domain.to[axis]) continue;
    refuse_surface(
        scene, shape,
        fmt::format("lies outside of the domain: it reaches from {} to {} in {}, the domain from {} to {}; `move` it "
                    "or enlarge [domain]",
                    text(bounds.lower[axis]), text(bounds.upper[axis]), "xyz"[axis], text(scene.domain.from[axis]),
                    text(scene.domain.to[axis])));
  }
}

/// Limits of a repair: it welds points and closes slits that the lattice cannot resolve, and fills holes of a few
/// spacings or of a small share of the body.
RepairLimits limits_of(const Case& scene, const Triangles& surface) {
  const Bounds bounds = bounds_of(surface);
  const double spacing = scene.numerics.spacing;
  return {1e-3 * spacing, 0.1 * spacing, std::max(4 * spacing, 0.05 * (bounds.upper - bounds.lower).norm())};
}

void refuse_defects(const Case& scene, const Shape& shape, const Triangles& surface, const MeshDefects& defects,
                    const Notes& notes) {
  const std::string picture = notes.draw(shape.name + ".defects", defects.places);
  const std::string fills = fmt::format("holes up to {} across", length_text(limits_of(scene, surface).hole));
  std::string cure;
  if (shape.repair) {
    cure = fmt::format("the repair, which fills {}, could not cure this; mend the surface in the program that made it",
                       fills);
  } else if (defects.intersections > defects.between_bodies) {
    cure = "mend the surface in the program that made it";
  } else {
    cure = fmt::format("mend it in the program that made it, or run gencase with --repair, which fills {}", fills);
  }
  if (!picture.empty()) cure += "; the places are in " + picture;
  refuse_surface(scene, shape, fmt::format("has {}; {}", defects.text(), cure));
}

Triangles repaired(const Case& scene, const Shape& shape, const Triangles& surface, const Notes& notes) {
  Repaired result = repair(surface, limits_of(scene, surface));
  if (!result.changes.empty())
    notes.say(fmt::format("{} repaired: {}", begin_of(scene, shape), fmt::join(result.changes, ", ")));
  for (const std::string& change : result.judgement) notes.say(begin_of(scene, shape) + " " + change);
  return std::move(result.surface);
}

/// Refuses a surface that cannot be used as it is meant to; turns bodies that are inside out.
Triangles checked(const Case& scene, const Shape& shape, Triangles surface, SurfaceUse use, const Notes& notes) {
  if (shape.repair && use != SurfaceUse::plate) surface = repaired(scene, shape, surface, notes);
  if (use == SurfaceUse::body) {
    if (const std::size_t faces = cancel_back_to_back(surface); faces > 0)
      notes.say(fmt::format("{}: {} faces between two bodies dropped", begin_of(scene, shape), faces));
    part_sheets(surface);
  }
  const MeshDefects defects = find_defects(surface, use);
  if (defects.any()) refuse_defects(scene, shape, surface, defects, notes);
  if (use != SurfaceUse::body) return surface;
  Judged judged = judge_bodies(surface);
  for (const std::string& change : judged.changes) notes.say(begin_of(scene, shape) + " " + change);
  return std::move(judged.surface);
}

void check_thickness(const Case& scene, const Shape& shape, const Triangles& surface) {
  const double limit = 2 * scene.numerics.spacing;
  constexpr double share_of_edges = 0.01;  // sharp edges are thin everywhere
  const Thickness thickness = thickness_of(surface, limit * (1 - 1e-6));
  if (thickness.thin_share <= share_of_edges) return;
  refuse_surface(scene, shape,
                 fmt::format("is {} thin at {}, less than two spacings of {}, over {:.2g} % of its skin; use a smaller "
                             "numerics.spacing, thicken it, or make it a plate with side = \"both\"",
                             length_text(thickness.least), place(scene, thickness.where),
                             length_text(scene.numerics.spacing), 100 * thickness.thin_share));
}

RegionPointer make_body(const Case& scene, const Shape& shape, Triangles surface) {
  if (scene.info.dimension == 3) return make_polyhedron(std::move(surface));
  std::vector<Edge> cut = slice(surface);
  if (cut.empty()) refuse_surface(scene, shape, "does not meet the plane y = 0, in which a 2-D scene lies; `move` it");
  return make_polygon(std::move(cut));
}

bool is_wall(const Shape& shape) { return shape.role == ShapeRole::wall || shape.role == ShapeRole::moving_wall; }

/// Measured points [m], placed as the shape says. Reports what the reader took for granted, and takes the mean of
/// heights at one place that differ by no more than a hundredth of the spacing.
SurveyFile placed_survey(const Case& scene, const Shape& shape, const Notes& notes) {
  SurveyFile survey;
  try {
    survey = read_survey(scene.folder / shape.file);
  } catch (const InputError& error) {
    throw InputError(where(scene, shape) + ": " + error.what());
  }
  for (const std::string& remark : survey.remarks) notes.say(fmt::format("{}: {}", begin_of(scene, shape), remark));
  for (Vec3& p : survey.points) p = placed(shape, p);
  const std::vector<Vec3> given = survey.points;
  const Repeated repeated = merge_repeated(survey.points);
  if (repeated.places == 0) return survey;
  const Vec3& p = given[repeated.first];
  const double spacing = scene.numerics.spacing;
  const std::string found =
      fmt::format("gives two heights at {} place{}; the largest difference is {} at x = {}{}, lines {} and {}",
                  repeated.places, repeated.places == 1 ? "" : "s", length_text(repeated.largest),
                  placed_text(p.x(), spacing), survey.has_y ? fmt::format(", y = {}", placed_text(p.y(), spacing)) : "",
                  survey.lines[repeated.first], survey.lines[repeated.second]);
  constexpr double tolerance = 0.01;  // [spacings]
  if (repeated.largest > tolerance * spacing * (1 + 1e-6))
    refuse_surface(scene, shape, found + "; remove the points that are wrong");
  notes.warn(fmt::format("{} {}; their means are taken", begin_of(scene, shape), found));
  return survey;
}

void check_base(const Case& scene, const Shape& shape, const std::vector<Vec3>& points) {
  const auto lowest =
      std::min_element(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
  if (lowest->z() > shape.base) return;
  refuse_surface(scene, shape,
                 fmt::format("reaches down to {} at {}, and `base` is {}; lower the base", length_text(lowest->z()),
                             place(scene, *lowest), length_text(shape.base)));
}

/// The polygon (x, z) between a surface that does not change in y and the base.
std::vector<Eigen::Vector2d> section(const Case& scene, const Shape& shape, std::vector<Vec3> points) {
  std::sort(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) { return a.x() < b.x(); });
  if (points.size() < 2) refuse_surface(scene, shape, "has fewer than two points; give at least two");
  std::vector<Eigen::Vector2d> polygon{{points.front().x(), shape.base}, {points.back().x(), shape.base}};
  for (auto p = points.rbegin(); p != points.rend(); ++p) polygon.emplace_back(p->x(), p->z());
  return polygon;
}

/// The points that the lattice can tell apart: more than some ten thousand, which exact cuts against other walls take
/// minutes for, are averaged over squares of a quarter of the spacing.
std::vector<Vec3> resolved(const Case& scene, const Shape& shape, const std::vector<Vec3>& points, const Notes& notes) {
  constexpr std::size_t many = 20000;
  if (points.size() <= many) return points;
  const double square = 0.25 * scene.numerics.spacing;
  std::vector<Vec3> means = averaged(points, square);
  notes.say(fmt::format("{}: {} points are averaged over squares of {}, a quarter of the spacing, to {}",
                        begin_of(scene, shape), points.size(), length_text(square), means.size()));
  return means;
}

RegionPointer make_survey(const Case& scene, const Shape& shape, const Notes& notes) {
  const SurveyFile survey = placed_survey(scene, shape, notes);
  if (survey.points.empty()) refuse_surface(scene, shape, "has no point; give at least three");
  check_base(scene, shape, survey.points);
  if (!survey.has_y) {
    const auto polygon = section(scene, shape, survey.points);
    if (scene.info.dimension == 2) return make_polygon(edges_of(polygon));
    // It reaches beyond the domain, so that its ends lie in no wall.
    const double beyond = scene.domain.to.y() - scene.domain.from.y();
    return make_polyhedron(
        extrude(counter_clockwise(polygon), 1, scene.domain.from.y() - beyond, scene.domain.to.y() + beyond));
  }
  const std::vector<Vec3> points = resolved(scene, shape, survey.points, notes);
  try {
    // A triangulation of points above the base bounds a body by its making; no search for defects is needed.
    return make_body(scene, shape, closed_downward(triangulated(points), shape.base));
  } catch (const NoHeightField& error) {
    refuse_surface(scene, shape, error.what());
  }
}

}  // namespace

std::string where(const Case& scene, const Shape& shape) {
  return fmt::format("{}:{}: shape \"{}\"", scene.file.string(), shape.line, shape.name);
}

RegionPointer make_mesh(const Case& scene, const Shape& shape, double plate_thickness, const Notes& notes) {
  Triangles surface = read_surface(scene, shape, notes);
  check_unit(scene, shape, bounds_of(surface));
  check_inside_domain(scene, shape, bounds_of(surface));
  const bool plate = is_wall(shape) && shape.side == WallSide::both;
  surface = checked(scene, shape, std::move(surface), plate ? SurfaceUse::plate : SurfaceUse::body, notes);
  if (plate && scene.info.dimension == 2)
    refuse_surface(scene, shape, "is a plate (side = \"both\"), which 3-D scenes have only; use a thin box or prism");
  if (plate) return make_plate(std::move(surface), plate_thickness);
  if (is_wall(shape) && shape.side == WallSide::inside && scene.info.dimension == 3)
    check_thickness(scene, shape, surface);
  return make_body(scene, shape, std::move(surface));
}

RegionPointer make_bathymetry(const Case& scene, const Shape& shape, const Notes& notes) {
  if (is_survey(shape.file)) return make_survey(scene, shape, notes);
  Triangles surface = read_surface(scene, shape, notes);
  check_unit(scene, shape, bounds_of(surface));
  check_inside_domain(scene, shape, bounds_of(surface));
  check_base(scene, shape, surface.points);
  surface = checked(scene, shape, std::move(surface), SurfaceUse::ground, notes);
  try {
    return make_body(scene, shape,
                     checked(scene, shape, closed_downward(surface, shape.base), SurfaceUse::body, notes));
  } catch (const NoHeightField& error) {
    refuse_surface(scene, shape, error.what());
  }
}

}  // namespace thalweg::gencase
