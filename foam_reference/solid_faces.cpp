#include "foam_reference/solid_faces.hpp"

#include <algorithm>

#include "foam_reference/openings.hpp"
#include "foam_reference/wall_patches.hpp"

namespace thalweg::foam {
namespace {

// One face of the block: its axis, the two axes in its plane, and the middle of the cells behind it along its axis.
struct Side {
  int axis = 0;
  int across = 0;
  int up = 0;
  double plane = 0;   // [m]
  double behind = 0;  // [m]
};

Side side_of(const MeshPlan& plan, std::size_t face) {
  const int axis = static_cast<int>(face / 2);
  const bool low = face % 2 == 0;
  const double plane = (low ? plan.low : plan.high)[axis];
  return {axis, (axis + 1) % 3 == 2 ? (axis + 2) % 3 : (axis + 1) % 3, axis == 2 ? 1 : 2, plane,
          plane + (low ? -0.5 : 0.5) * plan.size()[axis]};
}

// A strip of faces along `up`, from one to before another.
struct Strip {
  std::size_t solids = 0;
  std::int64_t from = 0;
  std::int64_t to = 0;
  bool operator==(const Strip&) const = default;
};

class Walls {
 public:
  explicit Walls(const FoamCase& foam_case) : foam_case_(foam_case), roughnesses_(solid_roughnesses(foam_case)) {}

  // The strips of solid cells behind the `column`-th column of faces.
  [[nodiscard]] std::vector<Strip> behind(const Side& side, std::int64_t column) const {
    const MeshPlan& plan = foam_case_.plan;
    const Vec3 size = plan.size();
    std::vector<Strip> strips;
    Vec3 point;
    point[side.axis] = side.behind;
    point[side.across] = plan.low[side.across] + (static_cast<double>(column) + 0.5) * size[side.across];
    for (std::int64_t row = 0; row < plan.cells[static_cast<std::size_t>(side.up)]; ++row) {
      point[side.up] = plan.low[side.up] + (static_cast<double>(row) + 0.5) * size[side.up];
      const Shape* shape = shape_at(foam_case_.scene, point);
      if (shape == nullptr || shape->role != ShapeRole::wall) continue;
      const auto found = std::ranges::find(roughnesses_, roughness_of(foam_case_, *shape));
      const auto solids = static_cast<std::size_t>(found - roughnesses_.begin());
      if (!strips.empty() && strips.back().solids == solids && strips.back().to == row) {
        ++strips.back().to;
      } else {
        strips.push_back({solids, row, row + 1});
      }
    }
    return strips;
  }

 private:
  const FoamCase& foam_case_;
  std::vector<double> roughnesses_;
};

SolidFaces faces_of(const MeshPlan& plan, const Side& side, const Strip& strip, std::int64_t from, std::int64_t to) {
  const Vec3 size = plan.size();
  SolidFaces faces;
  faces.solids = strip.solids;
  faces.bounds.low[side.axis] = side.plane - 0.01 * size[side.axis];
  faces.bounds.high[side.axis] = side.plane + 0.01 * size[side.axis];
  const auto extent = [&](int along, std::int64_t first, std::int64_t end) {
    faces.bounds.low[along] = plan.low[along] + static_cast<double>(first) * size[along];
    faces.bounds.high[along] = plan.low[along] + static_cast<double>(end) * size[along];
  };
  extent(side.across, from, to);
  extent(side.up, strip.from, strip.to);
  return faces;
}

}  // namespace

std::vector<SolidFaces> solid_faces(const FoamCase& foam_case) {
  const MeshPlan& plan = foam_case.plan;
  const Walls walls(foam_case);
  std::vector<SolidFaces> found;
  for (std::size_t face = 0; face < 6; ++face) {
    const auto lies_here = [face](const OpeningPatch& patch) { return patch.face == face; };
    if (plan.faces[face] != Face::open || std::ranges::none_of(opening_patches(foam_case.scene), lies_here)) continue;
    const Side side = side_of(plan, face);
    const std::int64_t columns = plan.cells[static_cast<std::size_t>(side.across)];
    std::vector<Strip> strips = walls.behind(side, 0);
    std::int64_t first = 0;
    for (std::int64_t column = 1; column <= columns; ++column) {
      std::vector<Strip> next;
      if (column < columns) next = walls.behind(side, column);
      if (column < columns && next == strips) continue;
      for (const Strip& strip : strips) found.push_back(faces_of(plan, side, strip, first, column));
      strips = std::move(next);
      first = column;
    }
  }
  return found;
}

}  // namespace thalweg::foam
