#include "case/physics_checks.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <array>
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

/// Paste alone, which walls hold back, comes to a steady flow; water hardly does.
std::string falls_through_its_period(const Case& c) {
  const auto is_water = [](const Shape& shape) { return shape.role == ShapeRole::water; };
  const auto is_wall = [](const Shape& shape) { return shape.role == ShapeRole::wall; };
  const bool is_held = std::none_of(c.shapes.begin(), c.shapes.end(), is_water) &&
                       std::any_of(c.shapes.begin(), c.shapes.end(), is_wall);
  if (is_held) return "";
  Eigen::Index down = 0;
  if (c.domain.gravity.cwiseAbs().maxCoeff(&down) == 0) return "";
  return c.domain.is_periodic(static_cast<int>(down)) ? "domain.periodic" : "";
}

/// The least and the greatest way [m] that a motion along a line has gone in the course of the run; 0 for others.
std::array<double, 2> reach(const Motion& motion, double end) {
  switch (motion.kind) {
    case MotionKind::piecewise_linear: {
      std::array<double, 2> ways{0, 0};
      for (std::size_t i = 0; i < motion.displacements.size() && i < motion.times.size(); ++i) {
        if (i > 0 && motion.times[i - 1] >= end) break;  // the run ends before this row is on the way
        const double way = motion.displacements[i] - motion.displacements.front();  // counted from t = 0
        ways = {std::min(ways[0], way), std::max(ways[1], way)};
      }
      return ways;
    }
    case MotionKind::gate_lift: {
      const double time = std::max(0.0, end - motion.start);
      double way = motion.speed * time;
      if (motion.acceleration > 0) {
        const double rise = motion.speed > 0 ? std::min(time, motion.speed / motion.acceleration) : time;
        way = 0.5 * motion.acceleration * rise * rise + motion.speed * (time - rise);
      }
      return {0, motion.distance > 0 ? std::min(way, motion.distance) : way};
    }
    case MotionKind::oscillation:
      return {0, end > motion.start ? 2 * motion.amplitude : 0};
    case MotionKind::rotation:
    case MotionKind::sliding_surface:
      return {0, 0};
  }
  return {0, 0};
}

/// A side of a box along an axis, seen in the direction of `sign`: the one that comes last, or first.
double last_side(const Shape& box, int axis, double sign) { return sign > 0 ? box.from[axis] : box.to[axis]; }
double first_side(const Shape& box, int axis, double sign) { return sign > 0 ? box.to[axis] : box.from[axis]; }

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
    const double wall = first_side(container, axis, sign);
    const double last = last_side(box, axis, sign);
    if (sign * (last - wall) < 0 && sign * (last + way[axis] - wall) > 0) return true;
  }
  return false;
}

/// True if a box passes a solid one with its whole width, along an axis and from one side to the other. Lids are left
/// out as above.
bool passes_a_solid(const Shape& box, const Vec3& way, const Shape& solid, const Case& c) {
  Eigen::Index axis = 0;
  const double length = way.cwiseAbs().maxCoeff(&axis);
  if (!(length > 0) || (way.cwiseAbs().sum() - length) > 1e-9 * length) return false;
  const double sign = way[axis] > 0 ? 1 : -1;
  if (sign * c.domain.gravity[axis] < 0) return false;
  for (int other = 0; other < 3; ++other) {
    if (other == axis || (c.info.dimension == 2 && other == 1)) continue;
    if (box.to[other] <= solid.from[other] || box.from[other] >= solid.to[other]) return false;
  }
  const int along = static_cast<int>(axis);
  const double rounding = 1e-9 * length;
  return sign * (first_side(box, along, sign) - last_side(solid, along, sign)) <= rounding &&
         sign * (last_side(box, along, sign) + way[axis] - first_side(solid, along, sign)) >= -rounding;
}

bool passes_a_wall(const Shape& box, const Vec3& way, const Case& c) {
  return std::any_of(c.shapes.begin(), c.shapes.end(), [&](const Shape& wall) {
    if (wall.role != ShapeRole::wall || wall.kind != ShapeKind::box) return false;
    return wall.side == WallSide::outside ? passes_a_closed_face(box, way, wall, c) : passes_a_solid(box, way, wall, c);
  });
}

std::string drives_through_a_wall(const Case& c) {
  for (const Motion& motion : c.motions) {
    if (motion.direction.norm() == 0) continue;
    for (const double length : reach(motion, c.output.end)) {
      const Vec3 way = length * motion.direction.normalized();
      for (const Shape& box : c.shapes)
        if (box.motion == motion.name && box.kind == ShapeKind::box && passes_a_wall(box, way, c))
          return "motion." + motion.name;
    }
  }
  return "";
}

constexpr double farthest = 1000;  // [domains] that a wall may go in a run

std::string leaves_for_good(const Case& c) {
  const double domain = (c.domain.to - c.domain.from).norm();
  for (const Motion& motion : c.motions)
    for (const double way : reach(motion, c.output.end))
      if (!(std::abs(way) <= farthest * domain)) return "motion." + motion.name;
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
      {"A moving wall driven through a wall", drives_through_a_wall,
       "a moving box passes a closed face of its container, or a solid box, and takes the water with it",
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
