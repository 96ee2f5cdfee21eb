#include "case/tables/opening.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "case/case.hpp"
#include "case/models/openings.hpp"
#include "case/models/tilted_gravity.hpp"
#include "case/tables/between.hpp"
#include "case/tables/common_checks.hpp"
#include "common/units.hpp"

namespace thalweg {
namespace {

std::string metres(double length) { return format_quantity(length, "m"); }

void check_size(const Opening& opening, const Case& whole, const CheckContext& at) {
  const bool in_space = whole.info.dimension == 3;
  if (opening.is_round() && (at.given("height") || at.given("width"))) {
    at.reject(at.key("diameter"), at.path() + " has a diameter and a height or width", "choose one of the two");
  }
  if (!opening.is_round() && !(opening.height > 0)) {
    at.reject(at.path(), at.path() + " has no height", in_space ? "give height and width, or diameter" : "give height");
  }
  if (in_space && !opening.is_round() && !(opening.width > 0)) {
    at.reject(at.path(), at.path() + " has no width", "give width, or a diameter in place of height and width");
  }
  const double least = 2 * whole.numerics.spacing;
  const double smallest = std::min(opening.extent_up(), in_space ? opening.extent_across(3) : opening.extent_up());
  if (smallest >= least * (1 - 1e-9)) return;
  at.reject(at.path(), fmt::format("{} is {} wide, less than two spacings", at.path(), metres(smallest)),
            "make it wider or numerics.spacing smaller");
}

/// The corners of the zone where the opening holds its particles have to lie in the domain.
void check_zone(const Opening& opening, const Case& whole, const CheckContext& at, double from, double to) {
  const OpeningAxes axes = opening.axes();
  const bool in_space = whole.info.dimension == 3;
  for (const double along : {from, to}) {
    for (const double side : {-0.5, 0.5}) {
      for (const double end : {-0.5, 0.5}) {
        const Vec3 corner = opening.at + along * axes.flow + side * opening.extent_up() * axes.up +
                            (in_space ? end * opening.extent_across(3) : 0) * axes.across;
        for (int axis = 0; axis < 3; ++axis) {
          const double low = whole.domain.from[axis] - 1e-9;
          const double high = whole.domain.to[axis] + 1e-9;
          if (!at.uses(axis) || (corner[axis] >= low && corner[axis] <= high)) continue;
          at.reject(at.path(),
                    fmt::format("the zone of {} leaves the domain in {}: it reaches {} {} of its plane", at.path(),
                                axis_name(axis), metres(std::max(std::abs(from), std::abs(to))),
                                from < 0 ? "upstream" : "downstream"),
                    "move the opening into the domain, or make the domain larger there");
        }
      }
    }
  }
}

}  // namespace

double value_at(const std::vector<double>& times, const std::vector<double>& values, double time, double otherwise) {
  if (values.empty()) return otherwise;
  // Tables of unequal length are refused, but other tables are checked against them before that is told.
  const std::size_t rows = std::min(times.size(), values.size());
  if (rows == 0) return values.front();
  const Between row = between(times, rows, time);
  return row.mix(values[row.below], values[row.above()]);
}

bool Opening::is_place(std::string_view key) {
  return key == "name" || key == "at" || key == "direction" || key == "height" || key == "width" || key == "diameter";
}

bool Opening::uses_place(std::string_view key, int dimension) const {
  if (key == "height") return height > 0 || !is_round();
  if (key == "width") return dimension == 3 && (width > 0 || !is_round());
  if (key == "diameter") return dimension == 3 && (is_round() || !(height > 0));
  return is_place(key);
}

double Opening::extent_across(int dimension) const {
  if (dimension == 2) return 1;
  return is_round() ? diameter : width;
}

double Opening::area(int dimension) const {
  if (is_round()) return std::numbers::pi / 4 * diameter * diameter;
  return height * extent_across(dimension);
}

OpeningAxes Opening::axes() const {
  OpeningAxes axes;
  if (!(direction.norm() > 0)) return axes;
  axes.flow = direction.normalized();
  const Vec3 rising = Vec3::UnitZ() - axes.flow.z() * axes.flow;
  constexpr double vertical = 1e-6;
  axes.up = rising.norm() > vertical ? rising.normalized() : Vec3::UnitX();
  axes.across = axes.up.cross(axes.flow);
  return axes;
}

double Opening::level_at(double time) const { return value_at(times, levels, time, level); }

void Opening::check_place(const Case& whole, const CheckContext& at_table) const {
  check_file_name(at_table, name);
  for (const char* needed : {"at", "direction"}) {
    if (!at_table.given(needed)) {
      at_table.reject(at_table.path(), at_table.key(needed) + " is missing", std::string("give ") + needed);
    }
  }
  check_size(*this, whole, at_table);
  const bool enters = std::any_of(whole.inlets.begin(), whole.inlets.end(),
                                  [&](const Inlet& inlet) { return static_cast<const Opening*>(&inlet) == this; });
  const double length = zone_length(whole);
  check_zone(*this, whole, at_table, enters ? -length : 0, enters ? 0 : length);
  check_names_of_openings(whole, at_table);
}

void Opening::check_times(const CheckContext& at_table, const std::string& column,
                          const std::vector<double>& values) const {
  check_table_over_time(at_table, column, times, values);
}

void Opening::check_levels(const Case& whole, const CheckContext& at_table) const {
  if (has_tilted_gravity(whole)) {
    at_table.reject(at_table.key("level"),
                    at_table.path() + " has a level, which needs gravity straight down, along -z",
                    "let gravity point along -z");
  }
  if (std::abs(axes().flow.z()) > 1e-6) {
    at_table.reject(at_table.key("direction"), at_table.path() + " has a level, and its plane does not stand upright",
                    "let the direction be horizontal");
  }
  if (is_round()) {
    at_table.reject(at_table.key("diameter"), at_table.path() + " has a level, and is round",
                    "give height and width in place of the diameter");
  }
  const auto check_one = [&](const char* key, double z) {
    const double least = lower_edge() + whole.numerics.spacing;
    if (z < least * (1 - 1e-12) - 1e-12 || z > upper_edge() + 1e-12) {
      at_table.reject(at_table.key(key),
                      fmt::format("{} stands at {}, and the opening reaches from {} to {}", at_table.path(), metres(z),
                                  metres(lower_edge()), metres(upper_edge())),
                      "let the level lie in the opening, a spacing above its lower edge at least");
    }
  };
  if (levels.empty()) return check_one("level", level);
  for (const double z : levels) check_one("levels", z);
}

void check_names_of_openings(const Case& whole, const CheckContext& at_table) {
  std::set<std::string> names;
  const auto add = [&](const std::string& name) {
    if (names.insert(name).second) return;
    at_table.reject(at_table.path(), fmt::format("two openings have the name \"{}\"", name), "rename one of them");
  };
  for (const Inlet& inlet : whole.inlets) add(inlet.name);
  for (const Outlet& outlet : whole.outlets) add(outlet.name);
}

}  // namespace thalweg
