// system/blockMeshDict, topoSetDict.*, setFieldsDict, decomposeParDict: the cells and their contents at the start.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "foam_reference/case_files.hpp"
#include "foam_reference/dictionary.hpp"
#include "foam_reference/openings.hpp"
#include "foam_reference/solid_faces.hpp"
#include "foam_reference/start_velocity.hpp"
#include "foam_reference/wall_patches.hpp"

namespace thalweg::foam {
namespace {

constexpr std::array<const char*, 6> face_vertices{"(0 4 7 3)", "(1 2 6 5)", "(0 1 5 4)",
                                                   "(3 7 6 2)", "(0 3 2 1)", "(4 5 6 7)"};
constexpr std::array<const char*, 6> face_words{"minusX", "plusX", "minusY", "plusY", "minusZ", "plusZ"};

std::string patch(const std::string& name, const std::string& type, const std::string& faces,
                  const std::string& more = "") {
  return "    " + name + "\n    {\n        type " + type + ";\n" + more + "        faces (" + faces + ");\n    }\n";
}

std::string patches(const FoamCase& foam_case) {
  const MeshPlan& plan = foam_case.plan;
  std::string walls, open, unused, cyclic;
  for (std::size_t face = 0; face < 6; ++face) {
    const std::string vertices = std::string(" ") + face_vertices[face];
    switch (plan.faces[face]) {
      case Face::wall:
        walls += vertices;
        break;
      case Face::open:
        open += vertices;
        break;
      case Face::unused:
        unused += vertices;
        break;
      case Face::periodic:
        cyclic += patch(face_words[face], "cyclic", vertices + " ",
                        std::string("        neighbourPatch ") + face_words[face ^ 1U] + ";\n");
        break;
    }
  }
  std::string text;
  if (!walls.empty()) text += patch("walls", "wall", walls + " ");
  if (!open.empty()) text += patch("atmosphere", "patch", open + " ");
  if (!unused.empty()) text += patch("frontAndBack", "empty", unused + " ");
  for (std::size_t i = 0; i < solid_roughnesses(foam_case).size(); ++i) text += patch(solids_patch(i), "wall", "");
  return text + cyclic;
}

std::string block_mesh(const FoamCase& foam_case) {
  const MeshPlan& plan = foam_case.plan;
  const auto corner = [&](bool x, bool y, bool z) {
    return "    " +
           vector(
               {x ? plan.high.x() : plan.low.x(), y ? plan.high.y() : plan.low.y(), z ? plan.high.z() : plan.low.z()}) +
           "\n";
  };
  return substitute(R"(convertToMeters 1;

vertices
(
%vertices%);

blocks
(
    hex (0 1 2 3 4 5 6 7) (%nx% %ny% %nz%) simpleGrading (1 1 1)
);

boundary
(
%patches%);
)",
                    {{"vertices", corner(false, false, false) + corner(true, false, false) + corner(true, true, false) +
                                      corner(false, true, false) + corner(false, false, true) +
                                      corner(true, false, true) + corner(true, true, true) + corner(false, true, true)},
                     {"nx", std::to_string(plan.cells[0])},
                     {"ny", std::to_string(plan.cells[1])},
                     {"nz", std::to_string(plan.cells[2])},
                     {"patches", patches(foam_case)}});
}

// The corner of a box, moved up by a thousandth of a cell where its faces run through cell centres. Rounding would
// decide for each of those cells by itself. Now it is the same for all of them, and for the shape next to this one.
Vec3 off_centres(const MeshPlan& plan, Vec3 corner) {
  const Vec3 size = plan.size();
  for (const int axis : {0, 1, 2}) {
    const double cells = (corner[axis] - plan.low[axis]) / size[axis] - 0.5;
    if (std::abs(cells - std::round(cells)) < 1e-6) corner[axis] += 1e-3 * size[axis];
  }
  return corner;
}

// A number, since a shape's name may hold characters that a set's name may not.
std::string combined_set(const Case& scene, const Shape& shape) {
  return "shape" + std::to_string(&shape - scene.shapes.data());
}

bool is_combined(const Shape& shape) {
  return shape.kind == ShapeKind::combine_union || shape.kind == ShapeKind::combine_difference ||
         shape.kind == ShapeKind::combine_intersection;
}

// A source of cells for topoSet and setFields: its name and its entries.
struct CellSource {
  std::string name;
  std::string entries;
};

// The cells in a shape; in 2-D through the whole width of the block.
CellSource cell_source(const FoamCase& foam_case, const Shape& given) {
  const Shape shape = as_filled_box(foam_case.scene, given);
  const MeshPlan& plan = foam_case.plan;
  const bool plane = foam_case.scene.info.dimension == 2;
  const auto at_y = [&](Vec3 point, double y) {
    if (plane) point.y() = y;
    return point;
  };
  const Vec3 low = plan.low, high = plan.high;
  if (is_combined(given)) return {"cellToCell", "set " + combined_set(foam_case.scene, given) + ";"};
  if (shape.kind == ShapeKind::box) {
    return {"boxToCell", "box " + vector(at_y(off_centres(plan, shape.from), low.y())) + " " +
                             vector(at_y(off_centres(plan, shape.to), high.y())) + ";"};
  }
  if (shape.kind == ShapeKind::sphere && !plane) {
    return {"sphereToCell", "origin " + vector(shape.center) + "; radius " + number(shape.radius) + ";"};
  }
  const Vec3 p1 = plane ? at_y(shape.center, low.y()) : shape.from;
  const Vec3 p2 = plane ? at_y(shape.center, high.y()) : shape.to;
  return {"cylinderToCell", "p1 " + vector(p1) + "; p2 " + vector(p2) + "; radius " + number(shape.radius) + ";"};
}

std::string set_action(const std::string& set, const std::string& action, const CellSource& source) {
  return substitute("    { name %set%; type cellSet; action %action%; source %source%; %entries% }\n",
                    {{"set", set}, {"action", action}, {"source", source.name}, {"entries", source.entries}});
}

std::string face_action(const std::string& set, const std::string& action, const CellSource& source) {
  return substitute("    { name %set%; type faceSet; action %action%; source %source%; %entries% }\n",
                    {{"set", set}, {"action", action}, {"source", source.name}, {"entries", source.entries}});
}

// Builds the cell set of a combined shape, its parts first.
std::string combine(const FoamCase& foam_case, const Shape& shape) {
  std::string text;
  std::vector<const Shape*> parts;
  for (const std::string& name : shape.of) parts.push_back(&find_shape(foam_case.scene, name, shape));
  for (const Shape* part : parts) {
    if (is_combined(*part)) text += combine(foam_case, *part);
  }
  const std::string join = shape.kind == ShapeKind::combine_union        ? "add"
                           : shape.kind == ShapeKind::combine_difference ? "subtract"
                                                                         : "subset";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text += set_action(combined_set(foam_case.scene, shape), i == 0 ? "new" : join, cell_source(foam_case, *parts[i]));
  }
  return text;
}

bool holds_fluid(const Shape& shape) {
  return shape.role == ShapeRole::water || shape.role == ShapeRole::sediment || shape.role == ShapeRole::empty;
}

// The cells of the flow: all cells that are not in solid walls of this roughness, and those that later shapes fill in
// such a wall's place. Cells that the flow does not reach, as those under a floor, go with the last walls.
std::string flow_set(const FoamCase& foam_case, double roughness, bool is_last) {
  const MeshPlan& plan = foam_case.plan;
  const Vec3 margin = plan.size();
  std::string text = set_action(
      "flow", "new", {"boxToCell", "box " + vector(plan.low - margin) + " " + vector(plan.high + margin) + ";"});
  for (const Shape& shape : foam_case.scene.shapes) {
    const bool solid =
        shape.role == ShapeRole::wall && !is_container(shape) && !is_meshed_solid(foam_case.scene, shape);
    if (!solid && !holds_fluid(shape)) continue;
    if (is_combined(shape)) text += combine(foam_case, shape);
    const bool taken_out = solid && roughness_of(foam_case, shape) == roughness;
    text += set_action("flow", taken_out ? "subtract" : "add", cell_source(foam_case, shape));
  }
  if (is_last && !plan.flow_points.empty()) {
    std::string points;
    for (const Vec3& point : plan.flow_points) points += " " + vector(point);
    text += set_action("flow", "subset", {"regionToCell", "set flow; insidePoints (" + points + " );"});
  }
  return "actions\n(\n" + text + ");\n";
}

std::string walls_beside(std::size_t solids) { return "beside_" + solids_patch(solids); }

// The faces of the block's outer face that solids close, by the patch of the solids.
using ClosedFaces = std::map<std::size_t, std::vector<Bounds>>;

ClosedFaces closed_faces(const FoamCase& foam_case) {
  ClosedFaces found;
  for (const SolidFaces& faces : solid_faces(foam_case)) found[faces.solids].push_back(faces.bounds);
  return found;
}

// A set for each patch of solids.
std::string wall_sets(const FoamCase& foam_case, const ClosedFaces& closed) {
  std::string text;
  for (const auto& [solids, boxes] : closed) {
    std::string action = "new";
    for (const Bounds& bounds : boxes) {
      text += face_action(walls_beside(solids), action,
                          {"boxToFace", "box " + vector(bounds.low) + " " + vector(bounds.high) + ";"});
      action = "add";
    }
    text += face_action(walls_beside(solids), "subset", {"patchToFace", "patch atmosphere;"});
    for (const OpeningPatch& patch : opening_patches(foam_case.scene)) {
      text += face_action(walls_beside(solids), "subtract", {"faceToFace", "set " + patch.patch + ";"});
    }
  }
  return text;
}

// The faces of each inlet and outlet, and of the solids beside them.
std::string opening_sets(const FoamCase& foam_case, const ClosedFaces& closed) {
  std::string text;
  for (const OpeningPatch& patch : opening_patches(foam_case.scene)) {
    const Bounds bounds = bounds_of(patch, foam_case.plan, foam_case.scene.info.dimension);
    CellSource source{"boxToFace", "box " + vector(off_centres(foam_case.plan, bounds.low)) + " " +
                                       vector(off_centres(foam_case.plan, bounds.high)) + ";"};
    if (patch.opening->is_round()) {
      const Vec3 along = 0.01 * foam_case.plan.size().minCoeff() * patch.opening->axes().flow;
      source = {"cylinderToFace", "p1 " + vector(patch.opening->at - along) + "; p2 " +
                                      vector(patch.opening->at + along) + "; radius " +
                                      number(0.5 * patch.opening->diameter) + ";"};
    }
    text += face_action(patch.patch, "new", source) +
            face_action(patch.patch, "subset", {"patchToFace", "patch \"(walls|atmosphere)\";"});
  }
  return "actions\n(\n" + text + wall_sets(foam_case, closed) + ");\n";
}

std::string create_patches(const FoamCase& foam_case, const ClosedFaces& closed) {
  std::string text;
  for (const OpeningPatch& patch : opening_patches(foam_case.scene)) {
    text +=
        substitute("    { name %name%; patchInfo { type patch; } constructFrom set; set %name%; }  // \"%called%\"\n",
                   {{"name", patch.patch}, {"called", patch.opening->name}});
  }
  for (const auto& [solids, boxes] : closed) {
    text += substitute("    { name %name%; patchInfo { type wall; } constructFrom set; set %set%; }\n",
                       {{"name", solids_patch(solids)}, {"set", walls_beside(solids)}});
  }
  return "pointSync false;\n\npatches\n(\n" + text + ");\n";
}

std::string combined_sets(const FoamCase& foam_case) {
  std::string text;
  for (const Shape& shape : foam_case.scene.shapes) {
    if (holds_fluid(shape) && is_combined(shape)) text += combine(foam_case, shape);
  }
  return text;
}

std::string phase_values(const FoamCase& foam_case, const std::string& filled) {
  std::string text;
  if (foam_case.application() == "interFoam") {
    const bool bed = filled == "sediment";
    const bool wet = filled == "water" || (bed && foam_case.scene.sediment().pore_density > 0);
    text = std::string(" volScalarFieldValue alpha.water ") + (wet ? "1" : "0");
    if (foam_case.has_eroding_bed()) text += std::string(" volScalarFieldValue bed ") + (bed ? "1" : "0");
    return text + " ";
  }
  for (const std::string& phase : phases(foam_case)) {
    text += " volScalarFieldValue alpha." + phase + (phase == filled ? " 1" : " 0");
  }
  return text + " ";
}

std::string set_fields(const FoamCase& foam_case) {
  std::string regions;
  for (const Shape& shape : foam_case.scene.shapes) {
    if (!holds_fluid(shape)) continue;
    const std::string phase = shape.role == ShapeRole::water      ? "water"
                              : shape.role == ShapeRole::sediment ? "sediment"
                                                                  : "air";
    const CellSource source = cell_source(foam_case, shape);
    regions += substitute(R"(    %source%  // shape "%name%"
    {
        %entries%
        fieldValues (%values%);
    }
)",
                          {{"source", source.name},
                           {"name", shape.name},
                           {"entries", source.entries},
                           {"values", phase_values(foam_case, phase)}});
  }
  return "defaultFieldValues (" + phase_values(foam_case, "air") + ");\n\nregions\n(\n" + regions +
         start_regions(foam_case) + ");\n";
}

std::string decompose(const FoamCase& foam_case) {
  const MeshPlan& plan = foam_case.plan;
  // Slabs along the ground: each holds its columns from floor to top.
  const auto longest = plan.cells[1] > plan.cells[0] ? 1 : 0;
  Eigen::Vector3i parts = Eigen::Vector3i::Ones();
  parts[longest] = foam_case.ranks;
  return substitute(R"(numberOfSubdomains %ranks%;
method simple;
simpleCoeffs
{
    n (%x% %y% %z%);
    delta 0.001;
}
)",
                    {{"ranks", std::to_string(foam_case.ranks)},
                     {"x", std::to_string(parts.x())},
                     {"y", std::to_string(parts.y())},
                     {"z", std::to_string(parts.z())}});
}

}  // namespace

CaseFiles mesh_files(const FoamCase& foam_case) {
  const Case& scene = foam_case.scene;
  const MeshPlan& plan = foam_case.plan;
  CaseFiles files;
  const auto add = [&](const std::string& name, const std::string& purpose, const std::string& body) {
    files["system/" + name] = foam_file(scene, "dictionary", name, purpose, body);
  };
  add("blockMeshDict",
      fmt::format("The inside of the container in {} x {} x {} cells of {} m{}.\nLengths in m; z is up.", plan.cells[0],
                  plan.cells[1], plan.cells[2], vector(plan.size()),
                  scene.info.dimension == 2 ? ", 1 m wide so that volumes are per metre of width" : ""),
      block_mesh(foam_case));
  const std::vector<double> solids = solid_roughnesses(foam_case);
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const std::string of = solids[i] > 0 ? fmt::format(" with a roughness of {:g} m", solids[i]) : "";
    add("topoSetDict." + solids_patch(i),
        "The cells left when solid walls" + of + " are taken out, whole cells by their centres.",
        flow_set(foam_case, solids[i], i + 1 == solids.size()));
  }
  if (!opening_patches(scene).empty()) {
    const ClosedFaces closed = closed_faces(foam_case);
    add("topoSetDict.openings", "The faces of inlets and outlets and of walls beside them, by their centres.",
        opening_sets(foam_case, closed));
    add("createPatchDict", "Inlets and outlets as patches of their own; walls beside them to the solids.",
        create_patches(foam_case, closed));
  }
  if (const std::string sets = combined_sets(foam_case); !sets.empty()) {
    add("topoSetDict.shapes", "Cell sets of the combined shapes that setFields fills.", "actions\n(\n" + sets + ");\n");
  }
  add("setFieldsDict",
      "The shapes in the case's order: later ones take the place of earlier ones. Cells by their centres.",
      set_fields(foam_case));
  if (foam_case.ranks > 1) {
    add("decomposeParDict", "Slabs along the longer side on the ground, one a rank.", decompose(foam_case));
  }
  return files;
}

}  // namespace thalweg::foam
