#include "gencase/coverage.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "common/error.hpp"
#include "gencase/places.hpp"

namespace thalweg::gencase {
namespace {

/// Lines parallel to one axis through the middles of a grid of cells over a box.
class Grid {
 public:
  Grid(Bounds box, int cells) : box_(std::move(box)), cells_(cells) {}
  [[nodiscard]] double middle(int axis, int cell) const {
    return box_.lower[axis] + (cell + 0.5) / cells_ * (box_.upper[axis] - box_.lower[axis]);
  }
  [[nodiscard]] Line line(int axis, int first, int second) const {
    Line line;
    line.axis = axis;
    line.origin[(axis + 1) % 3] = middle((axis + 1) % 3, first);
    line.origin[(axis + 2) % 3] = middle((axis + 2) % 3, second);
    line.first = box_.lower[axis];
    line.step = (box_.upper[axis] - box_.lower[axis]) / cells_;
    line.count = cells_;
    return line;
  }

 private:
  Bounds box_;
  int cells_;
};

/// The box over whose floor a survey has to reach: that of all containers, within the domain.
Bounds floor_of(const Case& scene, const std::vector<PlacedShape>& shapes) {
  std::optional<Bounds> all;
  for (const PlacedShape& shape : shapes) {
    if (!shape.is_container()) continue;
    const Bounds own = shape.room->bounds();
    if (!all) all = own;
    all->lower = all->lower.cwiseMin(own.lower);
    all->upper = all->upper.cwiseMax(own.upper);
  }
  const Bounds domain{scene.domain.from, scene.domain.to};
  if (!all) return domain;
  return {all->lower.cwiseMax(domain.lower), all->upper.cwiseMin(domain.upper)};
}

/// Share of the floor, where there is room, over which the shape has a part.
double covered_share(const Case& scene, const std::vector<PlacedShape>& shapes, const PlacedShape& survey,
                     const Bounds& box) {
  constexpr int cells = 100;
  const Grid grid(box, cells);
  int open = 0;
  int covered = 0;
  const bool has_container =
      std::any_of(shapes.begin(), shapes.end(), [](const PlacedShape& shape) { return shape.is_container(); });
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < (scene.info.dimension == 2 ? 1 : cells); ++j) {
      Line line = grid.line(2, i, j);
      if (scene.info.dimension == 2) line.origin.y() = 0;
      const bool room = !has_container || std::any_of(shapes.begin(), shapes.end(), [&](const PlacedShape& shape) {
        return shape.is_container() && !shape.room->cut(line).empty();
      });
      open += room;
      covered += room && !survey.body->cut(line).empty();
    }
  return open == 0 ? 1.0 : static_cast<double>(covered) / open;
}

/// "x = 3 m": the sides of the box that the shape does not reach.
std::vector<std::string> ends_of(const Case& scene, const Bounds& survey, const Bounds& box) {
  const double spacing = scene.numerics.spacing;
  std::vector<std::string> ends;
  for (int axis = 0; axis < (scene.info.dimension == 2 ? 1 : 2); ++axis) {
    if (survey.lower[axis] > box.lower[axis] + 0.5 * spacing)
      ends.push_back(fmt::format("begins at {} = {}", "xy"[axis], placed_text(survey.lower[axis], spacing)));
    if (survey.upper[axis] < box.upper[axis] - 0.5 * spacing)
      ends.push_back(fmt::format("ends at {} = {}", "xy"[axis], placed_text(survey.upper[axis], spacing)));
  }
  if (ends.empty()) ends.emplace_back("has gaps");
  return ends;
}

}  // namespace

void warn_of_coverage(const Case& scene, const std::vector<PlacedShape>& shapes,
                      const std::function<void(const std::string&)>& warn) {
  constexpr double enough = 0.99;  // survey lines may end a little before a wall
  for (const PlacedShape& survey : shapes) {
    if (survey.shape->kind != ShapeKind::bathymetry || survey.shape->role == ShapeRole::water) continue;
    const Bounds box = floor_of(scene, shapes);
    const double share = covered_share(scene, shapes, survey, box);
    if (share >= enough) continue;
    warn(fmt::format("{}: {} covers {:.0f} % of the {} floor: it {}; extend the survey, or shorten the tank to it",
                     where(scene, *survey.shape), survey.shape->file, 100 * share,
                     shapes.front().is_container() ? "containers'" : "domain's",
                     fmt::join(ends_of(scene, survey.body->bounds(), box), " and ")));
  }
}

void check_container(const Case& scene, const Shape& shape, const Region& body) {
  if (scene.info.dimension == 2) return;
  constexpr int cells = 24;
  const Grid grid(body.bounds(), cells);
  std::array<std::vector<Spans>, 3> cuts;  // by axis, of the lines through (first, second) of the other two
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < cells; ++i)
      for (int j = 0; j < cells; ++j) cuts[static_cast<std::size_t>(axis)].push_back(body.cut(grid.line(axis, i, j)));
  int material = 0;
  int hollow = 0;  // cells below which and at all four sides of which there is material
  for (int x = 0; x < cells; ++x)
    for (int y = 0; y < cells; ++y)
      for (int z = 0; z < cells; ++z) {
        const std::array<int, 3> cell{x, y, z};
        bool between = true;
        bool inside = false;
        for (int axis = 0; axis < 3; ++axis) {
          const auto row = static_cast<std::size_t>(cell[static_cast<std::size_t>((axis + 1) % 3)]);
          const auto column = static_cast<std::size_t>(cell[static_cast<std::size_t>((axis + 2) % 3)]);
          const Spans& spans = cuts[static_cast<std::size_t>(axis)][row * static_cast<std::size_t>(cells) + column];
          const double at = grid.middle(axis, cell[static_cast<std::size_t>(axis)]);
          inside = inside || covers(spans, at);
          between = between && !spans.empty() && spans.front().low < at && (axis == 2 || spans.back().high > at);
        }
        material += inside;
        hollow += between && !inside;
      }
  if (hollow <= material) return;
  const Vec3 size = body.bounds().upper - body.bounds().lower;
  const double cell = size.prod() / (cells * cells * cells);
  throw InputError(fmt::format(
      "{}: {} is a tank with a wall of its own: with side = \"outside\" water fills its material ({:.2g} m^3), not its "
      "hollow ({:.2g} m^3); write side = \"inside\", and a level fills its hollow",
      where(scene, shape), shape.file, material * cell, hollow * cell));
}

}  // namespace thalweg::gencase
