#include "foam_reference/openings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "common/units.hpp"

namespace thalweg::foam {
namespace {

std::string words_for(const OpeningPatch& patch) {
  return (patch.inlet != nullptr ? "inlet." : "outlet.") + patch.opening->name;
}

int axis_of(const OpeningPatch& patch) { return static_cast<int>(patch.face / 2); }

// The face whose outward normal is `outwards`; 6 if it is normal to none.
std::size_t face_of(const Vec3& outwards) {
  for (std::size_t face = 0; face < 6; ++face) {
    Vec3 normal = Vec3::Zero();
    normal[static_cast<int>(face / 2)] = face % 2 == 0 ? -1 : 1;
    if ((outwards - normal).norm() < 1e-6) return face;
  }
  return 6;
}

OpeningPatch patch_of(const Case& scene, std::string name, const Opening& opening, bool enters) {
  OpeningPatch patch;
  patch.patch = std::move(name);
  patch.opening = &opening;
  const Vec3 flow = opening.axes().flow;
  patch.face = face_of(enters ? Vec3(-flow) : flow);
  if (patch.face < 6) return patch;
  throw InputError(
      fmt::format("{}: {}.{} runs obliquely; the mesh model's openings lie in faces of its block: give it a "
                  "direction along an axis, or run this case with --no-foam",
                  place(scene), enters ? "inlet" : "outlet", opening.name));
}

// A cell on the inner side of an opening's plane that no wall fills.
bool has_free_cell(const Case& scene, const MeshPlan& plan, const OpeningPatch& patch) {
  const Bounds bounds = bounds_of(patch, plan, scene.info.dimension);
  const int axis = axis_of(patch);
  const Vec3 size = plan.size();
  const int first = (axis + 1) % 3;
  const int second = (axis + 2) % 3;
  const auto steps = [&](int along) {
    return std::max(1.0, std::round((bounds.high[along] - bounds.low[along]) / size[along]));
  };
  Vec3 point;
  point[axis] = plane_of(patch) + (patch.face % 2 == 0 ? 0.5 : -0.5) * size[axis];
  for (double i = 0.5; i < steps(first); ++i) {
    for (double j = 0.5; j < steps(second); ++j) {
      point[first] = bounds.low[first] + i / steps(first) * (bounds.high[first] - bounds.low[first]);
      point[second] = bounds.low[second] + j / steps(second) * (bounds.high[second] - bounds.low[second]);
      if (material_at(scene, point) != Material::solid) return true;
    }
  }
  return false;
}

void check_inlet(const Case& scene, const Inlet& inlet) {
  if (inlet.grains == InletGrains::none) return;
  throw InputError(
      fmt::format("{}: inlet.{} brings grains, which no mesh model takes in; write grains = \"none\", or run "
                  "this case with --no-foam",
                  place(scene), inlet.name));
}

// A pump's discharge is that of the inlets, and one that is given as velocity under a surface that follows the scene's
// is known only while the solver runs.
void check_pump(const Case& scene, const Outlet& outlet) {
  if (outlet.kind != OutletKind::pump) return;
  for (const Inlet& inlet : scene.inlets) {
    const bool is_velocity = inlet.velocity > 0 || !inlet.velocities.empty();
    if (!is_velocity || inlet.surface != InletSurface::follow) continue;
    throw InputError(
        fmt::format("{}: outlet.{} pumps what inlet.{} brings, which its velocity does not tell before its level "
                    "is known; give the inlet a discharge, or run this case with --no-foam",
                    place(scene), outlet.name, inlet.name));
  }
}

}  // namespace

bool has_current(const Case& scene) { return scene.has_lasting_current() || !scene.outlets.empty(); }

std::vector<OpeningPatch> opening_patches(const Case& scene) {
  std::vector<OpeningPatch> patches;
  for (const Inlet& inlet : scene.inlets) {
    patches.push_back(patch_of(scene, fmt::format("inlet{}", &inlet - scene.inlets.data()), inlet, true));
    patches.back().inlet = &inlet;
  }
  for (const Outlet& outlet : scene.outlets) {
    patches.push_back(patch_of(scene, fmt::format("outlet{}", &outlet - scene.outlets.data()), outlet, false));
    patches.back().outlet = &outlet;
  }
  return patches;
}

double plane_of(const OpeningPatch& patch) { return patch.opening->at[axis_of(patch)]; }

bool is_upright(const OpeningPatch& patch) { return patch.face < 4; }

Bounds bounds_of(const OpeningPatch& patch, const MeshPlan& plan, int dimension) {
  const Opening& opening = *patch.opening;
  const OpeningAxes axes = opening.axes();
  const Vec3 half =
      0.5 * (opening.extent_up() * axes.up.cwiseAbs() + opening.extent_across(dimension) * axes.across.cwiseAbs());
  Bounds bounds{opening.at - half, opening.at + half};
  const int axis = axis_of(patch);
  bounds.low[axis] = opening.at[axis] - 0.01 * plan.size()[axis];
  bounds.high[axis] = opening.at[axis] + 0.01 * plan.size()[axis];
  if (dimension == 2) {
    bounds.low.y() = plan.low.y();
    bounds.high.y() = plan.high.y();
  }
  return bounds;
}

double depth_at(const Case& scene, const MeshPlan& plan, const OpeningPatch& patch) {
  const Opening& opening = *patch.opening;
  const bool has_level =
      patch.inlet != nullptr ? patch.inlet->surface == InletSurface::level : patch.outlet->kind == OutletKind::level;
  if (has_level) return opening.level_at(0) - opening.lower_edge();
  if (patch.inlet == nullptr || patch.inlet->surface == InletSurface::full) return opening.extent_up();
  const double dz = plan.size().z();
  Vec3 point = opening.at;
  point[axis_of(patch)] += (patch.face % 2 == 0 ? 0.5 : -0.5) * plan.size()[axis_of(patch)];
  double depth = 0;
  for (double z = opening.lower_edge() + 0.5 * dz; z < opening.upper_edge(); z += dz) {
    point.z() = z;
    if (material_at(scene, point) == Material::water) depth += dz;
  }
  return depth > 0 ? depth : opening.extent_up();
}

void check_openings(const Case& scene, const MeshPlan& plan) {
  for (const OpeningPatch& patch : opening_patches(scene)) {
    if (patch.inlet != nullptr) check_inlet(scene, *patch.inlet);
    if (patch.outlet != nullptr) check_pump(scene, *patch.outlet);
    const int axis = axis_of(patch);
    const double end = patch.face % 2 == 0 ? plan.low[axis] : plan.high[axis];
    const char name = "xyz"[axis];
    if (std::abs(plane_of(patch) - end) > 1e-6 * plan.size()[axis]) {
      throw InputError(fmt::format(
          "{}: {} lies at {} = {}, inside the mesh model's block, which ends at {}; let it lie in "
          "the container's face, or run this case with --no-foam",
          place(scene), words_for(patch), name, format_quantity(plane_of(patch), "m"), format_quantity(end, "m")));
    }
    if (plan.faces[patch.face] == Face::periodic) {
      throw InputError(fmt::format("{}: {} lies at an end of a period along {}; take {} out of domain.periodic",
                                   place(scene), words_for(patch), name, name));
    }
    if (has_free_cell(scene, plan, patch)) continue;
    throw InputError(
        fmt::format("{}: {} lies behind walls on cells of {}; use a smaller foam.cell (--cell), or move it",
                    place(scene), words_for(patch), format_quantity(plan.cell, "m")));
  }
}

}  // namespace thalweg::foam
