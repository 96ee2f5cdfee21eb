#include "foam_reference/current_block.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "common/error.hpp"
#include "common/units.hpp"
#include "foam_reference/openings.hpp"

namespace thalweg::foam {
namespace {

bool is_fluid(const Shape& shape) { return shape.role == ShapeRole::water || shape.role == ShapeRole::sediment; }

// Lowest and highest point [m] of fluids and of upright openings.
struct Reach {
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  void add(double from, double to) {
    low = std::min(low, from);
    high = std::max(high, to);
  }
};

Reach reach_of(const Case& scene) {
  Reach reach;
  for (const Shape& shape : scene.shapes) {
    if (is_fluid(shape)) reach.add(bounds_of(scene, shape).low.z(), bounds_of(scene, shape).high.z());
  }
  for (const OpeningPatch& patch : opening_patches(scene)) {
    reach.add(patch.opening->lower_edge(), patch.opening->upper_edge());
  }
  if (reach.low <= reach.high) return reach;
  throw InputError(place(scene) + ": no water and no sediment; give at least one [[shape]] the role \"water\"");
}

// The coordinates of the faces that openings fix.
std::array<std::optional<double>, 6> planes_of_openings(const Case& scene) {
  std::array<std::optional<double>, 6> planes;
  for (const OpeningPatch& patch : opening_patches(scene)) {
    std::optional<double>& plane = planes[patch.face];
    if (plane && std::abs(*plane - plane_of(patch)) > 1e-9) {
      throw InputError(
          fmt::format("{}: two openings on one side lie at {} and at {}, and the mesh model's block ends at one "
                      "place; let them lie in one plane, or run this case with --no-foam",
                      place(scene), format_quantity(*plane, "m"), format_quantity(plane_of(patch), "m")));
    }
    plane = plane_of(patch);
  }
  return planes;
}

// The cells that fluid or an opening's water can reach, around walls: their lowest layer and a point in each region of
// them.
class Flood {
 public:
  Flood(const Case& scene, const MeshPlan& plan)
      : scene_(scene), plan_(plan), reached_(static_cast<std::size_t>(plan.cell_count()), false) {}

  void from(const Vec3& point) {
    std::array<std::int64_t, 3> cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int a = static_cast<int>(axis);
      cell[axis] = static_cast<std::int64_t>(std::floor((point[a] - plan_.low[a]) / plan_.size()[a]));
      if (cell[axis] < 0 || cell[axis] >= plan_.cells[axis]) return;
    }
    if (!enter(cell)) return;
    points_.push_back(centre(cell));
    while (!front_.empty()) {
      const std::array<std::int64_t, 3> at = front_.back();
      front_.pop_back();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const int step : {-1, 1}) {
          std::array<std::int64_t, 3> next = at;
          next[axis] += step;
          if (next[axis] >= 0 && next[axis] < plan_.cells[axis]) enter(next);
        }
      }
    }
  }

  [[nodiscard]] std::int64_t lowest() const { return lowest_; }
  [[nodiscard]] const std::vector<Vec3>& points() const { return points_; }

 private:
  [[nodiscard]] Vec3 centre(const std::array<std::int64_t, 3>& cell) const {
    const Vec3 index(static_cast<double>(cell[0]), static_cast<double>(cell[1]), static_cast<double>(cell[2]));
    return plan_.low + (index.array() + 0.5).matrix().cwiseProduct(plan_.size());
  }

  bool enter(const std::array<std::int64_t, 3>& cell) {
    const auto number = static_cast<std::size_t>(cell[0] + plan_.cells[0] * (cell[1] + plan_.cells[1] * cell[2]));
    if (reached_[number] || material_at(scene_, centre(cell)) == Material::solid) return false;
    reached_[number] = true;
    lowest_ = std::min(lowest_, cell[2]);
    front_.push_back(cell);
    return true;
  }

  const Case& scene_;
  const MeshPlan& plan_;
  std::vector<bool> reached_;
  std::vector<std::array<std::int64_t, 3>> front_;
  std::vector<Vec3> points_;
  std::int64_t lowest_ = std::numeric_limits<std::int64_t>::max();
};

Flood flood(const Case& scene, const MeshPlan& plan) {
  Flood flood(scene, plan);
  const Vec3 size = plan.size();
  for (std::int64_t i = 0; i < plan.cells[0]; ++i) {
    for (std::int64_t j = 0; j < plan.cells[1]; ++j) {
      for (std::int64_t k = 0; k < plan.cells[2]; ++k) {
        const Vec3 index(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
        const Vec3 point = plan.low + (index.array() + 0.5).matrix().cwiseProduct(size);
        const Shape* shape = shape_at(scene, point);
        if (shape != nullptr && is_fluid(*shape)) flood.from(point);
      }
    }
  }
  for (const OpeningPatch& patch : opening_patches(scene)) {
    const int axis = static_cast<int>(patch.face / 2);
    Vec3 point = patch.opening->at;
    if (scene.info.dimension == 2) point.y() = 0;
    point[axis] += (patch.face % 2 == 0 ? 0.5 : -0.5) * size[axis];
    flood.from(point);
  }
  return flood;
}

std::int64_t cells_between(double low, double high, double cell) {
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil((high - low) / cell - 1e-9)));
}

}  // namespace

MeshPlan plan_current(const Case& scene) {
  MeshPlan plan;
  plan.cell = cell_size(scene);
  plan.low = scene.domain.from;
  plan.high = scene.domain.to;
  plan.faces.fill(Face::open);
  for (const std::string& direction : scene.domain.periodic) {
    const std::size_t axis = direction == "x" ? 0 : direction == "y" ? 1 : 2;
    plan.faces[2 * axis] = plan.faces[2 * axis + 1] = Face::periodic;
  }
  if (scene.info.dimension == 2) {
    plan.faces[2] = plan.faces[3] = Face::unused;
    plan.low.y() = -0.5;
    plan.high.y() = 0.5;
  }
  const auto planes = planes_of_openings(scene);
  for (std::size_t face = 0; face < 6; ++face) {
    if (planes[face]) (face % 2 == 0 ? plan.low : plan.high)[static_cast<int>(face / 2)] = *planes[face];
  }
  const Reach reach = reach_of(scene);
  const bool has_top = plan.faces[5] == Face::periodic || planes[5].has_value();
  const bool has_floor = plan.faces[4] == Face::periodic || planes[4].has_value();
  if (!has_floor) {
    const double at = has_top ? plan.high.z() : reach.low;
    plan.low.z() = at - plan.cell * static_cast<double>(cells_between(plan.low.z(), at, plan.cell));
  }
  if (!has_top) {
    plan.high.z() =
        plan.low.z() + plan.cell * static_cast<double>(cells_between(plan.low.z(), plan.high.z(), plan.cell));
  }
  count_cells(scene, plan);

  const Flood reached = flood(scene, plan);
  plan.flow_points = reached.points();
  if (plan.flow_points.empty()) return plan;  // measure_contents tells that the scene is empty
  const double bottom = plan.low.z() + plan.cell * static_cast<double>(reached.lowest());
  if (!has_top) {
    const double above = scene.foam.open_above > 0 ? scene.foam.open_above : 0.5 * (reach.high - bottom);
    const double top = std::min(plan.high.z(), reach.high + above);
    plan.high.z() = plan.low.z() + plan.cell * static_cast<double>(cells_between(plan.low.z(), top, plan.cell));
  }
  if (!has_floor && reached.lowest() > 0) plan.low.z() = bottom - plan.cell;
  count_cells(scene, plan);
  return plan;
}

}  // namespace thalweg::foam
