#include "case/physics_checks.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "case/case.hpp"

namespace thalweg {
namespace {

constexpr double heavier_than_liquids = 2000;  // [kg/m^3] water with as much salt or mud as it can carry has less

std::string water_is_no_water(const Case& c) {
  return c.water.density > heavier_than_liquids ? "materials.water.density" : "";
}

/// The least depth [m] of a bed that is a box or a layer; infinite for others, whose extent only gencase knows.
double least_depth(const Case& c) {
  double least = HUGE_VAL;
  for (const Shape& shape : c.shapes) {
    if (shape.role != ShapeRole::sediment) continue;
    if (shape.kind == ShapeKind::box) least = std::min(least, shape.to.z() - shape.from.z());
    if (shape.kind == ShapeKind::layer) least = std::min(least, shape.thickness);
  }
  return least;
}

/// A single layer of stones still is a bed, roughly; grains twice as large as the bed is deep are a slip of the unit.
std::string grains_exceed_the_bed(const Case& c) {
  for (const auto& [name, material] : c.sediments)
    if (material.grain_diameter > 2 * least_depth(c)) return "materials." + name + ".grain_diameter";
  return "";
}

std::string falls_through_its_period(const Case& c) {
  Eigen::Index down = 0;
  if (c.domain.gravity.cwiseAbs().maxCoeff(&down) == 0) return "";
  const std::string axis(1, "xyz"[down]);
  const bool periodic = std::find(c.domain.periodic.begin(), c.domain.periodic.end(), axis) != c.domain.periodic.end();
  return periodic ? "domain.periodic" : "";
}

/// The way [m] that a motion along a line has gone at the end of the run; 0 for others.
double travelled(const Motion& motion, double end) {
  switch (motion.kind) {
    case MotionKind::piecewise_linear:
      return motion.displacements.empty() ? 0 : motion.displacements.back();
    case MotionKind::gate_lift: {
      const double time = std::max(0.0, end - motion.start);
      double way = motion.speed * time;
      if (motion.acceleration > 0) {
        const double rise = motion.speed > 0 ? std::min(time, motion.speed / motion.acceleration) : time;
        way = 0.5 * motion.acceleration * rise * rise + motion.speed * (time - rise);
      }
      return motion.distance > 0 ? std::min(way, motion.distance) : way;
    }
    case MotionKind::rotation:
    case MotionKind::sliding_surface:
    case MotionKind::oscillation:
      return 0;
  }
  return 0;
}

/// True if a box inside a container at the start has passed a closed face of it with its whole width at the end. The
/// face that gravity points away from is left out: gates slide through lids.
bool passes_a_closed_face(const Shape& box, const Vec3& way, const Shape& container, const Case& c) {
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2;
    if (c.info.dimension == 2 && axis == 1) continue;
    const double sign = face % 2 == 0 ? -1 : 1;
    const std::string name = std::string(face % 2 == 0 ? "-" : "+") + "xyz"[axis];
    const bool open = std::find(container.open.begin(), container.open.end(), name) != container.open.end();
    if (open || sign * c.domain.gravity[axis] < 0) continue;
    const double wall = face % 2 == 0 ? container.from[axis] : container.to[axis];
    const double near_side = face % 2 == 0 ? box.to[axis] : box.from[axis];  // the last to pass the face
    if (sign * (near_side - wall) < 0 && sign * (near_side + way[axis] - wall) > 0) return true;
  }
  return false;
}

std::string drives_through_a_wall(const Case& c) {
  for (const Motion& motion : c.motions) {
    if (motion.direction.norm() == 0) continue;
    const Vec3 way = travelled(motion, c.output.end) * motion.direction.normalized();
    for (const Shape& box : c.shapes) {
      if (box.motion != motion.name || box.kind != ShapeKind::box) continue;
      for (const Shape& container : c.shapes)
        if (container.role == ShapeRole::wall && container.side == WallSide::outside &&
            container.kind == ShapeKind::box && passes_a_closed_face(box, way, container, c))
          return "motion." + motion.name;
    }
  }
  return "";
}

constexpr double farthest = 1000;  // [domains] that a wall may go in a run

std::string leaves_for_good(const Case& c) {
  const double domain = (c.domain.to - c.domain.from).norm();
  for (const Motion& motion : c.motions)
    if (!(std::abs(travelled(motion, c.output.end)) <= farthest * domain)) return "motion." + motion.name;
  return "";
}

}  // namespace

std::vector<PhysicsCheck> physics_checks() {
  return {
      {"Water heavier than any watery liquid", water_is_no_water,
       fmt::format("materials.water.density is above {} kg/m^3, more than water can carry in salt or mud",
                   heavier_than_liquids),
       "give it in kg/m^3; water has 1000"},
      {"Grains twice as large as the bed is deep", grains_exceed_the_bed,
       "grain_diameter is more than twice the depth of a bed, which is a continuum of grains",
       "give grain_diameter in its unit, as in \"2 mm\", or make the bed deeper"},
      {"Gravity along a periodic direction", falls_through_its_period,
       "gravity points along a direction that domain.periodic names, so that fluid falls for ever",
       "take that direction out of periodic and close it with walls"},
      {"A moving wall driven through a container's wall", drives_through_a_wall,
       "a moving box passes a closed face of its container and takes the water with it",
       "shorten its way, turn its direction round, or open that face"},
      {"A wall that leaves by far more than the scene", leaves_for_good,
       fmt::format("a moving wall goes more than {} times the domain's length", farthest),
       "give its displacements or speed with their units"},
  };
}

void write_physics_checks(std::ostream& to) {
  fmt::print(to,
             "# Physics that is refused\n\n"
             "`thalweg explain --physics` writes this page from the checks themselves (`case/physics_checks.cpp`). "
             "A case that\nmatches one of them is refused before any program works on it. Ranges of single keys are "
             "in [case-file.md](case-file.md).\n\n"
             "| scene | cause | cure |\n|---|---|---|\n");
  for (const PhysicsCheck& check : physics_checks())
    fmt::print(to, "| {} | {} | {} |\n", check.scene, check.cause, check.cure);
}

}  // namespace thalweg
