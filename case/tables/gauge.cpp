#include "case/tables/gauge.hpp"

#include <algorithm>

#include "case/case.hpp"
#include "case/tables/common_checks.hpp"

namespace thalweg {
namespace {

void check_inside_domain(const CheckContext& at, const Vec3& place, const Domain& domain) {
  for (int axis = 0; axis < 3; ++axis) {
    const bool inside = place[axis] >= domain.from[axis] && place[axis] <= domain.to[axis];
    if (inside || !at.uses(axis)) continue;
    at.reject(at.key("at"), fmt::format("{} lies outside the domain in {}", at.key("at"), axis_name(axis)),
              "move it inside");
  }
}

void check_rectangle(const CheckContext& at, const Vec3& from, const Vec3& to) {
  int equal = 0;
  for (int axis = 0; axis < 3; ++axis) equal += at.uses(axis) && from[axis] == to[axis] ? 1 : 0;
  if (equal == 1) return;
  at.reject(at.key("to"), fmt::format("{} and {} are equal along {} axes", at.key("from"), at.key("to"), equal),
            "give two corners of a rectangle across one axis");
}

}  // namespace

bool Gauge::uses_key(std::string_view key, int dimension) const {
  if (key == "name" || key == "kind") return true;
  const std::vector<std::string> place = needs_keys(dimension);
  return std::find(place.begin(), place.end(), key) != place.end();
}

std::vector<std::string> Gauge::needs_keys(int) const {
  switch (kind) {
    case GaugeKind::water_level:
    case GaugeKind::pressure:
    case GaugeKind::velocity:
      return {"at"};
    case GaugeKind::flux:
      return {"from", "to"};
  }
  return {};
}

void Gauge::check(const Case& whole, const CheckContext& context) const {
  check_file_name(context, name);
  check_keys(context, *this);
  switch (kind) {
    case GaugeKind::water_level:
    case GaugeKind::pressure:
    case GaugeKind::velocity:
      return check_inside_domain(context, at, whole.domain);
    case GaugeKind::flux:
      return check_rectangle(context, from, to);
  }
}

Gauge Gauge::without_defaults() {
  Gauge gauge;
  gauge.at = gauge.from = gauge.to = Vec3::Constant(required);
  return gauge;
}

}  // namespace thalweg
