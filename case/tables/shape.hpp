#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "case/tables/table.hpp"
#include "common/particles.hpp"

namespace thalweg {

enum class ShapeKind {
  box,
  cylinder,
  cone,
  sphere,
  prism,
  mesh,
  bathymetry,
  level,
  layer,
  combine_union,
  combine_difference,
  combine_intersection
};
enum class ShapeRole { none, water, sediment, wall, moving_wall, empty };
enum class WallSide { inside, outside, both };
enum class Axis { x, y, z };
enum class BooleanMethod { exact, voxel };

inline constexpr std::array<Choice<ShapeKind>, 12> choices(ShapeKind) {
  return {{{ShapeKind::box, "box", "between the corners `from` and `to`"},
           {ShapeKind::cylinder, "cylinder",
            "`radius` around the segment from `from` to `to` (3-D), or a disc around `center` (2-D)"},
           {ShapeKind::cone, "cone",
            "`radius` at `from`, `end_radius` at `to`: a cone or a frustum; in 2-D its cut through the axis"},
           {ShapeKind::sphere, "sphere", "`radius` around `center`; a disc in 2-D"},
           {ShapeKind::prism, "prism", "the `polygon`, in 3-D along `axis` over `extent`"},
           {ShapeKind::mesh, "mesh",
            "the closed surface in `file` (STL, OBJ, OFF, PLY or VTP), scaled, rotated, then moved; in 2-D its cut by "
            "the plane y = 0"},
           {ShapeKind::bathymetry, "bathymetry",
            "everything between the height `base` and the surface in `file`: points x, y, z in a CSV table, x, z for a "
            "surface without change in y, or an open surface mesh"},
           {ShapeKind::level, "level", "the inside of the containers before it in the case, up to `level`"},
           {ShapeKind::layer, "layer", "`thickness` above the floor that the walls before it leave in the containers"},
           {ShapeKind::combine_union, "union", "all of the shapes named in `of`"},
           {ShapeKind::combine_difference, "difference", "the first shape of `of` without the others"},
           {ShapeKind::combine_intersection, "intersection", "what the shapes of `of` share"}}};
}
inline constexpr std::array<Choice<ShapeRole>, 6> choices(ShapeRole) {
  return {{{ShapeRole::none, "none", "only for use in another shape's `of`"},
           {ShapeRole::water, "water", "filled with water"},
           {ShapeRole::sediment, "sediment", "filled with the sediment named by `material`"},
           {ShapeRole::wall, "wall", "a fixed wall"},
           {ShapeRole::moving_wall, "moving wall", "a wall that moves as the [[motion]] named by `motion` says"},
           {ShapeRole::empty, "empty", "takes away what earlier shapes put there"}}};
}
inline constexpr std::array<Choice<WallSide>, 3> choices(WallSide) {
  return {
      {{WallSide::inside, "inside", "the shape is a solid body in the flow"},
       {WallSide::outside, "outside", "the shape is a container and the wall lies around it"},
       {WallSide::both, "both", "meshes: the surface, open or closed, is a plate; half the wall lies on each side"}}};
}
inline constexpr std::array<Choice<Axis>, 3> choices(Axis) {
  return {{{Axis::x, "x", "the polygon's points are y, z"},
           {Axis::y, "y", "the polygon's points are x, z"},
           {Axis::z, "z", "the polygon's points are x, y"}}};
}
inline constexpr std::array<Choice<BooleanMethod>, 2> choices(BooleanMethod) {
  return {{{BooleanMethod::exact, "exact", "surface meshes are cut against each other with exact arithmetic"},
           {BooleanMethod::voxel, "voxel",
            "lattice points are combined one by one; for surfaces whose exact combination is refused"}}};
}

/// One [[shape]]. Later shapes take the place of earlier ones where they overlap.
struct Shape {
  static constexpr TableHeading heading{
      "shape", "Geometry: one such table for every shape, in the order in which they are filled.",
      "Which geometry a shape needs follows from its kind: a box `from` and `to`; a cylinder `from`, `to` and `radius` "
      "(in 2-D\n"
      "`center` and `radius`); a cone `from`, `to` and `radius`; a sphere `center` and `radius`; a prism `polygon` "
      "and, in 3-D,\n"
      "`extent`; a mesh `file`; a bathymetry `file` and `base`; a level `level`; a layer `thickness`; a union, "
      "difference or\n"
      "intersection `of`. A key that means nothing for a shape is an error. `docs/geometry.md` shows each of them.",
      true};

  std::string name;
  ShapeKind kind = ShapeKind::box;
  ShapeRole role = ShapeRole::none;
  Vec3 from = Vec3::Zero();              // [m]
  Vec3 to = Vec3::Zero();                // [m]
  Vec3 center = Vec3::Zero();            // [m]
  double radius = 0;                     // [m]
  double end_radius = 0;                 // [m]
  std::vector<Eigen::Vector2d> polygon;  // [m]
  Axis axis = Axis::y;
  std::vector<double> extent;  // [m]
  std::string file;
  double scale = 1;            // [-]
  std::vector<double> rotate;  // [rad]
  std::vector<double> move;    // [m]
  bool repair = false;
  double base = 0;   // [m]
  double level = 0;  // [m]
  std::vector<std::string> of;
  BooleanMethod boolean = BooleanMethod::exact;
  std::string material;
  std::string motion;
  WallSide side = WallSide::inside;
  std::vector<std::string> open;
  double thickness = 0;      // [m]
  double roughness = 0;      // [m]
  double concentration = 0;  // [-]
  int line = 0;              // where it stands in the case file, for messages; not a key

  template <class V>
  void describe(V& v) {
    v.text("name", name, "Name of the shape, unique in the case.");
    v.choice("kind", kind, "What it is.");
    v.choice("role", role, "What it is made of.");
    v.point("from", from, "m", "box: lower corner; cylinder, cone: one end of the axis.");
    v.point("to", to, "m", "box: upper corner; cylinder, cone: other end of the axis.");
    v.point("center", center, "m", "sphere: its centre; cylinder in 2-D: centre of the disc.");
    v.quantity("radius", radius, "m", 0, 1e6, "sphere, cylinder: the radius; cone: the radius at `from`.");
    v.quantity("end_radius", end_radius, "m", 0, 1e6, "cone: the radius at `to`; 0: a point.");
    v.polygon("polygon", polygon, "m", "prism: corners in order, in the plane across `axis`; 2-D: x, z.");
    v.choice("axis", axis, "prism in 3-D: the direction along which the polygon extends.");
    v.quantities("extent", extent, "m", -1e9, 1e9, "prism in 3-D: where it begins and ends along `axis`.");
    v.text("file", file, "mesh, bathymetry: the file, relative to the case's folder.");
    v.number("scale", scale, 1e-9, 1e9, "mesh, bathymetry: metres in one unit of the file; 0.001 for millimetres.");
    v.quantities("rotate", rotate, "rad", -7, 7,
                 "mesh, bathymetry: three angles by which it is turned about the x, then the y, then the z axis.");
    v.quantities("move", move, "m", -1e9, 1e9,
                 "mesh, bathymetry: three distances by which it is moved in x, y, z, after scaling and turning.");
    v.flag("repair", repair,
           "mesh, bathymetry: stitch gaps, turn faces alike and fill small holes, and say so; else such a file is "
           "refused.");
    v.quantity("base", base, "m", -1e9, 1e9, "bathymetry: the height down to which the body reaches.");
    v.quantity("level", level, "m", -1e9, 1e9, "level: the height up to which the containers are filled.");
    v.texts("of", of, "union, difference, intersection: names of the shapes combined.");
    v.choice("boolean", boolean, "union, difference, intersection with a mesh among their shapes: how to combine.");
    v.text("material", material, "role = \"sediment\": name of the material; may be left out when there is only one.");
    v.text("motion", motion, "role = \"moving wall\": name of its [[motion]]; shapes with the same one move together.");
    v.choice("side", side, "Walls: which side of the surface is wall.");
    v.texts("open", open,
            "Container walls (side = \"outside\") of a box: faces without wall, any of \"-x\", \"+x\", \"-y\", \"+y\", "
            "\"-z\", \"+z\".");
    v.quantity("thickness", thickness, "m", 0, 1e6,
               "layer: height above the floor. Walls: thickness; default: as much as the kernel's support needs.");
    v.quantity("roughness", roughness, "m", 0, 1,
               "Walls with model.wall_friction = \"rough\": Nikuradse's sand-grain roughness; 0: smooth.");
    v.number(
        "concentration", concentration, 0, 0.7,
        "role = \"water\" with suspended_load.carried_by = \"water\": volume share of the grains in it at the start.");
  }

  [[nodiscard]] bool uses_key(std::string_view key, int dimension) const;
  [[nodiscard]] std::vector<std::string> needs_keys(int dimension) const;
  /// The material of sediment is the only one there is, unless the case names it.
  void complete(const Case& whole);
  void check(const Case& whole, const CheckContext& at) const;
  static void check_all(const Case& whole, const CheckContext& at);
  [[nodiscard]] std::vector<std::string> hashed_files() const;
  static Shape without_defaults();
};

}  // namespace thalweg
