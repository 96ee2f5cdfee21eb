#include "gencase/openings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "case/models/openings.hpp"
#include "common/error.hpp"
#include "common/units.hpp"
#include "gencase/places.hpp"

namespace thalweg::gencase {
namespace {

/// An opening and the axes of its zone, in which places are told.
struct PlacedOpening {
  const Opening* opening;
  OpeningAxes axes;
  bool enters;
  double length;  // of its zone [m]
  bool in_space;
  bool falls = false;  // an outlet that holds nothing back

  /// Coordinates of a place along the flow, upwards and across, from the centre of the opening [m].
  [[nodiscard]] Vec3 coordinates(const Vec3& place) const {
    const Vec3 from = place - opening->at;
    return {from.dot(axes.flow), from.dot(axes.up), in_space ? from.dot(axes.across) : 0};
  }
  /// True if a place lies in the opening's section, which is made smaller all around by `rim` [m].
  [[nodiscard]] bool is_in_section(const Vec3& at, double rim) const {
    if (opening->is_round()) return std::hypot(at.y(), at.z()) <= 0.5 * opening->diameter - rim;
    return std::abs(at.y()) <= 0.5 * opening->extent_up() - rim &&
           (!in_space || std::abs(at.z()) <= 0.5 * opening->extent_across(3) - rim);
  }
  /// True if water stands in the zone.
  [[nodiscard]] bool holds_water() const { return !falls; }
  [[nodiscard]] std::string name() const {
    return fmt::format("{}.{}", enters ? Inlet::heading.name : Outlet::heading.name, opening->name);
  }
};

std::vector<PlacedOpening> placed_openings(const Case& scene) {
  std::vector<PlacedOpening> placed;
  const double length = zone_length(scene);
  const bool in_space = scene.info.dimension == 3;
  for (const Inlet& inlet : scene.inlets) placed.push_back({&inlet, inlet.axes(), true, length, in_space});
  for (const Outlet& outlet : scene.outlets) {
    placed.push_back({&outlet, outlet.axes(), false, length, in_space, outlet.kind == OutletKind::fall});
  }
  return placed;
}

/// Nodes that a zone finds in its way.
struct InZone {
  std::int64_t cleared = 0;
  std::int64_t walls = 0;  // in the opening itself or in its zone
  std::int64_t behind = 0;
  std::int64_t bare = 0;  // of sediment past the plane: where the zone ends, no water presses on it
  Vec3 sediment = Vec3::Zero();
  Vec3 wall = Vec3::Zero();
  Vec3 water = Vec3::Zero();
};

bool is_fluid_node(const std::vector<PlacedShape>& shapes, Label label) {
  return label != nothing && label != solid_core && shapes[label - 1U].is_fluid();
}

void take_node(const Case& scene, const std::vector<PlacedShape>& shapes, const PlacedOpening& opening,
               const Vec3& place, Label& label, InZone& found) {
  const double spacing = scene.numerics.spacing;
  const Vec3 in = opening.coordinates(place);
  const double rounding = 1e-6 * spacing;
  const bool fluid = is_fluid_node(shapes, label);
  const double along = opening.enters ? -in.x() : in.x();  // away from the scene
  if (along < -rounding) return;
  if (!fluid) {
    // A wall may touch the opening's rim; it closes it where it reaches half a spacing inwards.
    if (along > opening.length || !opening.is_in_section(in, 0.51 * spacing)) return;
    if (found.walls++ == 0) found.wall = place;
    return;
  }
  // Water that ends within this reach belongs to a shape that fills the longer zone of a coarser spacing.
  const double reach = 4 * opening.length;
  const bool past = along > opening.length + rounding && along < 2 * reach;
  const bool beside = std::abs(in.z()) <= 0.5 * opening.opening->extent_across(opening.in_space ? 3 : 2);
  const bool crosses = along > rounding && along < reach;
  if (crosses && beside && opening.holds_water() && shapes[label - 1U].shape->role == ShapeRole::sediment) {
    if (found.bare++ == 0) found.sediment = place;
    return;
  }
  if (!opening.is_in_section(in, -rounding)) return;
  const bool ends = !opening.enters && past && shapes[label - 1U].shape->role == ShapeRole::water;
  if (ends && along >= reach) {
    if (found.behind++ == 0) found.water = place;
  } else if (opening.enters || ends) {
    label = nothing;
    ++found.cleared;
  }
}

InZone search_zone(const Case& scene, const std::vector<PlacedShape>& shapes, const PlacedOpening& opening,
                   Filling& filling) {
  InZone found;
  const Lattice& lattice = filling.lattice;
  for (std::int64_t node = 0; node < lattice.nodes(); ++node) {
    Label& label = filling.label[static_cast<std::size_t>(node)];
    if (label != nothing) take_node(scene, shapes, opening, lattice.position(lattice.offset(node)), label, found);
  }
  return found;
}

/// Corners and centre of a zone, by which another is found to lie in it.
void check_apart(const Case& scene, const std::vector<PlacedOpening>& openings) {
  for (const PlacedOpening& one : openings) {
    for (const PlacedOpening& other : openings) {
      if (&one == &other) continue;
      for (const double along : {0.0, 0.5, 1.0}) {
        for (const double up : {-0.49, 0.0, 0.49}) {
          const double way = along * other.length * (other.enters ? -1 : 1);
          const Vec3 place =
              other.opening->at + way * other.axes.flow + up * other.opening->extent_up() * other.axes.up;
          const Vec3 in = one.coordinates(place);
          const double inside = one.enters ? -in.x() : in.x();
          if (!(inside >= 0 && inside <= one.length) || !one.is_in_section(in, 0)) continue;
          throw InputError(fmt::format("{}: the zones of {} and {} overlap; move them apart", scene.file.string(),
                                       one.name(), other.name()));
        }
      }
    }
  }
}

}  // namespace

void clear_openings(const Case& scene, const std::vector<PlacedShape>& shapes, Filling& filling, const Notes& notes) {
  const std::vector<PlacedOpening> openings = placed_openings(scene);
  if (openings.empty()) return;
  check_apart(scene, openings);
  for (const PlacedOpening& opening : openings) {
    const InZone found = search_zone(scene, shapes, opening, filling);
    if (found.walls > 0) {
      throw InputError(
          fmt::format("{}: {}: {} wall particles stand in its opening or its zone of {}, the first at {}; "
                      "clear the way with a shape of role \"empty\", or move the opening",
                      scene.file.string(), opening.name(), found.walls, format_quantity(opening.length, "m"),
                      placed_text(scene, found.wall)));
    }
    if (found.behind > 0 && found.cleared > 0) {  // one water; behind a gap it is another
      throw InputError(fmt::format("{}: {}: water stands behind its zone of {}, for one at {}; let the shape end there",
                                   scene.file.string(), opening.name(), format_quantity(opening.length, "m"),
                                   placed_text(scene, found.water)));
    }
    if (found.bare > 0) {
      throw InputError(fmt::format(
          "{}: {}: sediment lies past its plane, the first at {}; let a wall take its place from there on, as no water "
          "presses on a bed where the zone ends",
          scene.file.string(), opening.name(), placed_text(scene, found.sediment)));
    }
    if (found.cleared > 0) {
      notes.say(fmt::format("{}: {} particles are taken out {} its zone of {}{}", opening.name(), found.cleared,
                            opening.enters ? "of" : "behind", format_quantity(opening.length, "m"),
                            opening.enters ? ", which the solver fills" : ""));
    }
  }
  count_kept(shapes, filling);
}

}  // namespace thalweg::gencase
