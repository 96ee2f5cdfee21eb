#include "gencase/openings.hpp"

#include <fmt/format.h>

#include <algorithm>
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
  bool feeds = false;  // an inlet that brings bed load, in the highest row of the ground under its zone
  double row = 0;      // [m] height of the middle of that row over the centre of the opening

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
  /// True if a place lies in the row that is the bed load's, across the opening's width; spacing [m] of the lattice.
  [[nodiscard]] bool is_in_row(const Vec3& at, double spacing) const {
    return std::abs(at.y() - row) < 0.5 * spacing && (!in_space || std::abs(at.z()) <= 0.5 * opening->extent_across(3));
  }
  [[nodiscard]] std::string name() const {
    return fmt::format("{}.{}", enters ? Inlet::heading.name : Outlet::heading.name, opening->name);
  }
};

std::vector<PlacedOpening> placed_openings(const Case& scene, const Vec3& node) {
  std::vector<PlacedOpening> placed;
  const double length = zone_length(scene);
  const bool in_space = scene.info.dimension == 3;
  for (const Inlet& inlet : scene.inlets) {
    placed.push_back({&inlet, inlet.axes(), true, length, in_space});
    PlacedOpening& opening = placed.back();
    opening.feeds = inlet.bed_load != InletBedLoad::none;
    const Vec3 moved = centre_on_lattice(inlet, scene, node) - inlet.at;
    opening.row = moved.dot(opening.axes.up) - 0.5 * inlet.extent_up() - 0.5 * scene.numerics.spacing;
  }
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
  std::int64_t bare = 0;    // of sediment past the plane: where the zone ends, no water presses on it
  std::int64_t ground = 0;  // of walls, where bed load comes in
  bool begins = false;      // a bed begins behind the plane, as high as that
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
  if (opening.feeds && opening.is_in_row(in, spacing)) {
    const bool sediment = fluid && shapes[label - 1U].shape->role == ShapeRole::sediment;
    found.begins = found.begins || (sediment && along < 0 && -along < 1.5 * spacing);
    if (along > 0 && along < opening.length && !fluid) {
      label = nothing;
      ++found.ground;
    }
  }
  if (along < -rounding || label == nothing) return;
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

/// Number of particles of bed load that stand in a zone.
std::int64_t particles_of_bed_load(const Case& scene, const PlacedOpening& opening) {
  const double spacing = scene.numerics.spacing;
  const auto along = static_cast<std::int64_t>(std::floor(opening.length / spacing));
  const auto across =
      opening.in_space ? std::max<std::int64_t>(1, std::llround(opening.opening->extent_across(3) / spacing)) : 1;
  return along * across;
}

void check_ground(const Case& scene, const PlacedOpening& opening, const InZone& found, const Notes& notes) {
  if (!opening.feeds) return;
  const std::int64_t needed = particles_of_bed_load(scene, opening);
  if (found.ground < needed) {
    throw InputError(fmt::format(
        "{}: {}: {} of {} particles of ground lie under its zone of {}, as high as its lower edge, where its bed load "
        "comes in; let a wall go on under the zone, as high as the bed",
        scene.file.string(), opening.name(), found.ground, needed, format_quantity(opening.length, "m")));
  }
  if (!found.begins) {
    throw InputError(fmt::format(
        "{}: {}: its bed load comes in and no bed begins at its plane, as high as its lower edge; let the bed begin "
        "there, or write bed_load = \"none\"",
        scene.file.string(), opening.name()));
  }
  notes.say(
      fmt::format("{}: {} particles of the ground under its zone give way to bed load", opening.name(), found.ground));
}

}  // namespace

void clear_openings(const Case& scene, const std::vector<PlacedShape>& shapes, Filling& filling, const Notes& notes) {
  const std::vector<PlacedOpening> openings = placed_openings(scene, filling.lattice.position({}));
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
    check_ground(scene, opening, found, notes);
    if (found.cleared > 0) {
      notes.say(fmt::format("{}: {} particles are taken out {} its zone of {}{}", opening.name(), found.cleared,
                            opening.enters ? "of" : "behind", format_quantity(opening.length, "m"),
                            opening.enters ? ", which the solver fills" : ""));
    }
  }
  count_kept(shapes, filling);
}

}  // namespace thalweg::gencase
