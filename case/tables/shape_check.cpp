#include <algorithm>
#include <optional>
#include <utility>

#include "case/case.hpp"
#include "case/nearest.hpp"
#include "case/tables/common_checks.hpp"

namespace thalweg {
namespace {

void check_radius(const CheckContext& at, const Shape& s) {
  if (s.radius > 0) return;
  at.reject(at.key("radius"), at.key("radius") + " is zero", "give a positive radius");
}

void check_axis(const CheckContext& at, const Shape& s) {
  if (s.from != s.to) return;
  at.reject(at.key("to"), fmt::format("{} equals {}", at.key("to"), at.key("from")), "give the axis some length");
}

void check_prism(const CheckContext& at, const Shape& s) {
  if (s.polygon.size() < 3) {
    at.reject(at.key("polygon"), fmt::format("{} has {} corners", at.key("polygon"), s.polygon.size()),
              "give at least three");
  }
  if (at.dimension() == 3 && (s.extent.size() != 2 || s.extent[0] >= s.extent[1])) {
    at.reject(at.key("extent"), at.key("extent") + " is no range",
              "give two places along the axis, the lower one first");
  }
}

void check_layer(const CheckContext& at, const Shape& s) {
  if (s.thickness > 0) return;
  at.reject(at.key("thickness"), at.key("thickness") + " is zero", "give the layer some height");
}

// The shapes that a union, difference or intersection names stand before it in the case.
void check_members(const CheckContext& at, const Shape& s, const std::vector<Shape>& all) {
  if (s.of.size() < 2) {
    at.reject(at.key("of"), fmt::format("{} names {} shapes", at.key("of"), s.of.size()), "name at least two");
  }
  std::vector<std::string> earlier;
  std::vector<std::string> later;
  bool before = true;
  for (const Shape& other : all) {
    if (other.name == s.name) before = false;
    (before ? earlier : later).push_back(other.name);
  }
  const auto among = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const std::string& name : s.of) {
    if (among(earlier, name)) continue;
    if (among(later, name)) {
      at.reject(at.key("of"), fmt::format("{} names \"{}\", which does not come before it", at.key("of"), name),
                "move that shape up");
    }
    const auto near = nearest(name, earlier);
    at.reject(at.key("of"), fmt::format("{} names \"{}\", which is no shape", at.key("of"), name),
              near ? fmt::format("did you mean \"{}\"?", *near)
                   : fmt::format("the shapes before it are {}", fmt::join(earlier, ", ")));
  }
}

void check_fill(const CheckContext& at, const Shape& s) {
  switch (s.role) {
    case ShapeRole::wall:
    case ShapeRole::moving_wall:
      at.reject(at.key("role"), fmt::format("{} fills a container and cannot be a wall", at.path()),
                "give it the role \"water\" or \"sediment\"");
    case ShapeRole::none:
    case ShapeRole::water:
    case ShapeRole::sediment:
    case ShapeRole::empty:
      return;
  }
}

void check_geometry(const CheckContext& at, const Shape& s, const Case& whole) {
  switch (s.kind) {
    case ShapeKind::box:
      return check_corners(at, s.from, s.to);
    case ShapeKind::cylinder:
      check_radius(at, s);
      if (at.dimension() == 3) check_axis(at, s);
      return;
    case ShapeKind::cone:
      check_radius(at, s);
      return check_axis(at, s);
    case ShapeKind::sphere:
      return check_radius(at, s);
    case ShapeKind::prism:
      return check_prism(at, s);
    case ShapeKind::level:
      return check_fill(at, s);
    case ShapeKind::layer:
      check_layer(at, s);
      return check_fill(at, s);
    case ShapeKind::combine_union:
    case ShapeKind::combine_difference:
    case ShapeKind::combine_intersection:
      return check_members(at, s, whole.shapes);
    case ShapeKind::mesh:
    case ShapeKind::bathymetry:
      return;
  }
}

void check_three_entries(const CheckContext& at, std::string_view key, const std::vector<double>& values) {
  if (values.empty() || values.size() == 3) return;
  at.reject(at.key(key), fmt::format("{} has {} entries", at.key(key), values.size()), "give three, for x, y and z");
}

void check_side(const CheckContext& at, const Shape& s) {
  switch (s.side) {
    case WallSide::inside:
    case WallSide::outside:
      return;
    case WallSide::both:
      if (s.kind == ShapeKind::mesh) return;
      at.reject(at.key("side"), at.key("side") + " = \"both\" is for meshes",
                "use \"inside\" for a solid, \"outside\" for a container");
  }
}

void check_roughness(const CheckContext& at, const Shape& s, const Case& whole) {
  if (s.roughness == 0 || whole.model.wall_friction == WallFriction::rough) return;
  at.reject(at.key("roughness"), at.key("roughness") + " means nothing unless walls are rough",
            "write wall_friction = \"rough\" in [model], or remove it");
}

void check_use(const CheckContext& at, const Shape& s, const Case& whole) {
  const bool used = std::any_of(whole.shapes.begin(), whole.shapes.end(), [&](const Shape& other) {
    return std::find(other.of.begin(), other.of.end(), s.name) != other.of.end();
  });
  if (!used) at.reject(at.path(), at.path() + " has no role and no other shape uses it", "give it a role");
}

void check_motion(const CheckContext& at, const Shape& s, const Case& whole) {
  if (s.motion.empty()) {
    at.reject(at.key("role"), at.path() + " is a moving wall without a motion",
              "add motion = \"...\" and a table [[motion]] of that name");
  }
  std::vector<std::string> known;
  for (const Motion& each : whole.motions) known.push_back(each.name);
  if (std::find(known.begin(), known.end(), s.motion) != known.end()) return;
  const auto near = nearest(s.motion, known);
  at.reject(at.key("motion"), fmt::format("{} = \"{}\" is no motion", at.key("motion"), s.motion),
            known.empty() ? "add a table [[motion]] of that name"
            : near        ? fmt::format("did you mean \"{}\"?", *near)
                          : fmt::format("the motions are {}", fmt::join(known, ", ")));
}

void check_material(const CheckContext& at, const Shape& s, const Case& whole) {
  std::vector<std::string> known;
  for (const auto& [name, parameters] : whole.sediments) known.push_back(name);
  if (known.empty()) {
    at.reject(at.path(), at.path() + " is sediment, and no sediment is defined",
              "add a table [materials.<name>] for it");
  }
  if (s.material.empty()) {
    at.reject(at.path(), at.key("material") + " is missing",
              fmt::format("there are several sediments; name one of {}", fmt::join(known, ", ")));
  }
  if (!whole.sediments.contains(s.material)) {
    at.reject(at.key("material"), fmt::format("{} = \"{}\" is no sediment", at.key("material"), s.material),
              fmt::format("the sediments are {}", fmt::join(known, ", ")));
  }
}

void check_open_faces(const CheckContext& at, const Shape& s) {
  for (const std::string& face : s.open) {
    const bool known = face.size() == 2 && (face[0] == '-' || face[0] == '+') &&
                       (face[1] == 'x' || face[1] == 'z' || (face[1] == 'y' && at.uses(1)));
    if (known) continue;
    at.reject(at.key("open"), fmt::format("{} names \"{}\"", at.key("open"), face),
              at.uses(1) ? "the faces are -x, +x, -y, +y, -z, +z" : "the faces are -x, +x, -z, +z with dimension = 2");
  }
}

using Corners = std::pair<Vec3, Vec3>;

// Lower and upper corner of a simple solid; nothing for the others, whose extent only gencase knows.
std::optional<Corners> bounds(const Shape& s, int dimension) {
  const auto around_center = [&] {
    return Corners{s.center - Vec3::Constant(s.radius), s.center + Vec3::Constant(s.radius)};
  };
  switch (s.kind) {
    case ShapeKind::box:
      return Corners{s.from, s.to};
    case ShapeKind::sphere:
      return around_center();
    case ShapeKind::cylinder: {
      if (dimension == 2) return around_center();
      const Vec3 axis = (s.to - s.from).normalized();
      const Vec3 reach =
          s.radius * (Vec3::Ones() - axis.cwiseAbs2()).cwiseMax(0).cwiseSqrt();  // of the discs at its ends
      return Corners{s.from.cwiseMin(s.to) - reach, s.from.cwiseMax(s.to) + reach};
    }
    case ShapeKind::cone:
    case ShapeKind::prism:
    case ShapeKind::mesh:
    case ShapeKind::bathymetry:
    case ShapeKind::level:
    case ShapeKind::layer:
    case ShapeKind::combine_union:
    case ShapeKind::combine_difference:
    case ShapeKind::combine_intersection:
      return std::nullopt;
  }
  return std::nullopt;
}

void check_inside_domain(const CheckContext& at, const Shape& s, const Domain& domain) {
  const auto extent = bounds(s, at.dimension());
  if (!extent) return;
  for (int axis = 0; axis < 3; ++axis) {
    if (!at.uses(axis)) continue;
    if (extent->first[axis] >= domain.from[axis] && extent->second[axis] <= domain.to[axis]) continue;
    at.reject(at.path(), fmt::format("{} reaches beyond the domain in {}", at.path(), axis_name(axis)),
              "enlarge [domain] or reduce the shape");
  }
}

void check_concentration(const CheckContext& at, const Shape& s, const Case& whole) {
  if (s.concentration == 0) return;
  const std::string key = at.key("concentration");
  if (!models::SuspendedLoadOfWater::is_on(whole)) {
    at.reject(key, key + " means nothing unless the water carries grains",
              "write carried_by = \"water\" in [suspended_load], or remove it");
  }
  const double packed = 1 - whole.sediment().porosity;
  if (s.concentration < packed) return;
  at.reject(key,
            fmt::format("{} = {} is that of a bed or more ({} of the volume of a bed are grains)", key, s.concentration,
                        packed),
            "give less, or the shape the role \"sediment\"");
}

void check_role(const CheckContext& at, const Shape& s, const Case& whole) {
  switch (s.role) {
    case ShapeRole::none:
      return check_use(at, s, whole);
    case ShapeRole::moving_wall:
      return check_motion(at, s, whole);
    case ShapeRole::water:
      check_concentration(at, s, whole);
      return check_inside_domain(at, s, whole.domain);
    case ShapeRole::sediment:
      check_material(at, s, whole);
      return check_inside_domain(at, s, whole.domain);
    case ShapeRole::wall:
    case ShapeRole::empty:
      return;
  }
}

}  // namespace

void Shape::check(const Case& whole, const CheckContext& at) const {
  check_word(at, "shape", name);
  check_keys(at, *this, " and this role");
  check_geometry(at, *this, whole);
  check_three_entries(at, "rotate", rotate);
  check_three_entries(at, "move", move);
  check_side(at, *this);
  check_roughness(at, *this, whole);
  check_role(at, *this, whole);
  check_open_faces(at, *this);
}

void Shape::check_all(const Case& whole, const CheckContext& at) {
  const bool has_fluid = std::any_of(whole.shapes.begin(), whole.shapes.end(), [](const Shape& s) {
    return s.role == ShapeRole::water || s.role == ShapeRole::sediment;
  });
  if (!has_fluid && whole.inlets.empty()) {
    at.reject(at.path(), "no shape has the role water or sediment", "add one, or there is nothing to move");
  }
}

}  // namespace thalweg
