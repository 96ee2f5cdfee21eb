#include "gencase/generate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "case/bed_on_ground.hpp"
#include "case/models/openings.hpp"
#include "case/models/surface_bed.hpp"
#include "case/scales.hpp"
#include "common/error.hpp"
#include "common/units.hpp"
#include "gencase/checks.hpp"
#include "gencase/closure.hpp"
#include "gencase/coverage.hpp"
#include "gencase/filling.hpp"
#include "gencase/flow_skin.hpp"
#include "gencase/hydrostatic.hpp"
#include "gencase/openings.hpp"
#include "gencase/particle_maker.hpp"
#include "gencase/places.hpp"
#include "gencase/pore_water.hpp"
#include "gencase/relaxation.hpp"
#include "gencase/start_flow.hpp"

namespace thalweg::gencase {
namespace {

// Scenes with more lattice nodes than this are first tried on a coarse lattice, so that a spacing mistyped by a factor
// of a thousand is refused at once.
constexpr double nodes_to_probe = 2e7;
constexpr double nodes_of_probe = 1e6;

[[noreturn]] void refuse_size(const Case& scene, double particles, double needed, double limit) {
  const double fits = spacing_that_fits(scene.numerics.spacing, needed, limit, scene.info.dimension);
  throw InputError(
      fmt::format("{}: {:.3g} particles at a spacing of {} need {} of memory and {} are available; "
                  "raise numerics.spacing to {} or more",
                  scene.file.string(), particles, format_quantity(scene.numerics.spacing, "m"), format_bytes(needed),
                  format_bytes(limit), format_quantity(fits, "m")));
}

/// Refuses a scene whose fluid or whose lattice needs more memory than there is, from the number of fluid nodes on a coarse
/// lattice. The exact number is checked after the filling.
void check_size_before_filling(const Case& scene, const std::vector<PlacedShape>& shapes, const Lattice& lattice,
                               const GenerateOptions& options) {
  const auto nodes = static_cast<double>(lattice.nodes());
  if (nodes <= nodes_to_probe) return;
  const double coarser = std::pow(nodes / nodes_of_probe, 1.0 / scene.info.dimension);
  Progress unseen;
  const Filling probe = claim_nodes(shapes, make_lattice(scene, shapes, lattice.spacing * coarser), unseen);
  double fluid = 0;
  for (std::size_t s = 0; s < shapes.size(); ++s)
    if (shapes[s].is_fluid()) fluid += static_cast<double>(probe.shapes[s].kept);
  fluid *= nodes / static_cast<double>(probe.lattice.nodes());
  const double run = options.larger_than_memory ? 0 : estimate_memory(fluid, scene.info.dimension).total();
  const double needed = std::max(run, nodes * sizeof(Label));
  if (needed > options.memory_limit) refuse_size(scene, fluid, needed, options.memory_limit);
}

/// Gravity along the lattice's columns [m/s^2], signed. Says so if gravity does not point along -z.
double column_gravity(const Case& scene, const Notes& notes) {
  const Vec3& gravity = scene.domain.gravity;
  const int axis = column_axis(scene);
  const double along = gravity[axis];
  if (along == 0) {
    notes.say("no gravity: the pressure starts at 0 everywhere");
  } else if (const double across = std::sqrt(gravity.squaredNorm() - along * along); across > 1e-9 * gravity.norm()) {
    notes.say(fmt::format(
        "gravity is tilted by {} from {}: the pressure starts hydrostatic along {} with {:.4g} m/s^2 "
        "alone, as in uniform flow down a slope",
        format_quantity(std::atan2(across, std::abs(along)), "rad"), "xyz"[axis], "xyz"[axis], std::abs(along)));
  } else if (!(axis == 2 && along < 0)) {
    notes.say(fmt::format("gravity points along {}{}: the pressure starts hydrostatic in that direction",
                          along < 0 ? '-' : '+', "xyz"[axis]));
  }
  return along;
}

/// The lattice node that the particle file names. It is the place of the first fixed wall particle, which readers of
/// files without the fact take, so that both give the same numbers to the last bit; without fixed walls, the node at
/// the lattice's anchor.
class NamedNode {
 public:
  explicit NamedNode(const Lattice& lattice)
      : anchor_(lattice.position({-lattice.first[0], -lattice.first[1], -lattice.first[2]})) {}
  void look(const ParticleSet& range) {
    if (wall_) return;
    const auto wall = std::find(range.type.begin(), range.type.end(), ParticleType::wall);
    if (wall != range.type.end()) wall_ = range.position[static_cast<std::size_t>(wall - range.type.begin())];
  }
  [[nodiscard]] const Vec3& anchor() const { return anchor_; }
  [[nodiscard]] Vec3 position() const { return wall_.value_or(anchor_); }

 private:
  Vec3 anchor_;
  std::optional<Vec3> wall_;
};

std::vector<ShapeSummary> summarise(const std::vector<PlacedShape>& shapes, const Filling& filling) {
  std::vector<ShapeSummary> summaries;
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    const ShapeFill& fill = filling.shapes[s];
    const bool fluid = shapes[s].is_fluid();
    const double cell = filling.lattice.cell();
    const double exact = fluid ? shapes[s].body->measure().value_or(0) : 0;
    // A body whose parts cancel has no volume to compare with.
    summaries.push_back({shapes[s].shape->name, fill.kept, fluid ? static_cast<double>(fill.kept) * cell : 0,
                         exact > cell ? exact : 0});
  }
  return summaries;
}

/// Searches of the flow's skin: one for fixed walls, one for the walls of each motion. Fixed walls are searched as if
/// there were no moving ones, because these leave them bare when they move; the walls of a motion are searched alone,
/// because all of their surface may come to face the flow.
struct Skins {
  std::map<std::string, FlowRoom> rooms;  // by motion
  std::map<std::string, std::unique_ptr<SkinSearch>> searches;
  std::vector<const SkinSearch*> of_shape;

  Skins(const Case& scene, const std::vector<PlacedShape>& shapes, const Bounds& around, const Notes& notes) {
    for (const PlacedShape& shape : shapes) {
      const std::string& motion = shape.shape->motion;
      if (!rooms.contains(motion)) {
        const FlowRoom& room = rooms.emplace(motion, flow_room(shapes, motion)).first->second;
        searches[motion] = make_flow_skin(room, around, scene.numerics.spacing, scene.info.dimension, notes);
      }
      of_shape.push_back(searches.at(motion).get());
    }
  }
};

/// Bounds that contain all walls and all skin that may be the nearest to one of them.
Bounds around(const Case& scene, const Lattice& lattice) {
  const Index3 last{lattice.count[0] - 1, lattice.count[1] - 1, lattice.count[2] - 1};
  const Vec3 margin = Vec3::Constant(10 * kernel_support(scene));
  return {lattice.position({0, 0, 0}).cwiseMin(scene.domain.from) - margin,
          lattice.position(last).cwiseMax(scene.domain.to) + margin};
}

void report_closure(const Case& scene, const std::vector<PlacedShape>& shapes, const FlowRoom& room,
                    const Filling& filling, const Notes& notes) {
  const std::optional<Leak> leak = find_leak(scene, shapes, room, filling);
  if (!leak) return notes.say("closure: no leak, fluid at rest stays inside");
  const Vec3& end = leak->path.back();
  const std::string picture = notes.draw("leak", {"Leak", {leak->path}, {1}});
  notes.warn(
      fmt::format("{}: fluid at rest can leave {} at x = {}, y = {}, z = {}, {} spacings away; close the wall there, "
                  "or open that face on purpose: an [[outlet]] takes what leaves{}",
                  scene.file.string(), leak->out_of_rooms ? "the containers" : "the domain",
                  placed_text(end.x(), scene.numerics.spacing), placed_text(end.y(), scene.numerics.spacing),
                  placed_text(end.z(), scene.numerics.spacing), leak->path.size() - 1,
                  picture.empty() ? "" : "; the path is in " + picture));
}

/// Finds the maximum speed and the sound speed from the fluid's height. Warns of a maximum speed below that of waves.
void resolve_speeds(Generated& result, const Notes& notes) {
  Case& resolved = result.resolved;
  Summary& summary = result.summary;
  resolved.numerics.maximum_speed = maximum_speed(resolved, summary.fluid_height);
  summary.sound_speed = sound_speed(resolved, summary.fluid_height);
  const double wave_speed = std::sqrt(resolved.domain.gravity.norm() * summary.fluid_height);
  if (resolved.numerics.maximum_speed < wave_speed * (1 - 1e-9))
    notes.warn(
        fmt::format("{}: numerics.maximum_speed of {:.4g} m/s is below the fluid's sqrt(g H) of {:.4g} m/s; "
                    "its density will vary by more than a percent",
                    resolved.file.string(), resolved.numerics.maximum_speed, wave_speed));
}

/// True if a part of gencase works with all particles at once.
bool needs_all_particles(const Case& scene) {
  return scene.gencase.relaxation > 0 || scene.model.seepage != SeepageModel::off;
}

/// Memory of gencase itself while it makes particles [bytes].
double own_memory(const Filling& filling, double host, bool in_ranges) {
  constexpr double of_range = 1e8;  // the particles of a range, and the file's blocks under way
  const double of_filling = static_cast<double>(filling.label.size() * sizeof(Label)) +
                            static_cast<double>(filling.walls.size() * sizeof(WallPoint));
  return in_ranges ? std::min(host, of_filling + of_range) : host;
}

}  // namespace

void Summary::count(const ParticleSet& range) {
  for (std::size_t i = 0; i < range.size(); ++i) {
    const auto type = static_cast<std::size_t>(range.type[i]);
    ++counts[type];
    masses[type] += double{range.mass[i]};
    bounds.extend(range.position[i]);
  }
}

Generated generate(const Case& scene, const GenerateOptions& options) {
  ParticleSet all;
  GenerateOptions at_once = options;
  at_once.nodes_at_once = std::numeric_limits<std::int64_t>::max();
  Generated result = generate_in_ranges(scene, at_once, [&](ParticleSet range) { all = std::move(range); });
  all.info = result.particles.info;
  result.particles = std::move(all);
  return result;
}

Generated generate_in_ranges(const Case& scene, const GenerateOptions& options,
                             const std::function<void(ParticleSet)>& take) {
  const Notes& notes = options.notes;
  Progress progress(options.progress);
  const std::vector<PlacedShape> shapes = place_shapes(scene, notes);
  check_periods(scene);
  const Lattice lattice = make_lattice(scene, shapes, scene.numerics.spacing);
  for (const std::string& line : faces_off_lattice(scene, lattice)) notes.warn(line);
  check_size_before_filling(scene, shapes, lattice, options);

  const FlowRoom room = flow_room(shapes);
  Filling filling = claim_nodes(shapes, lattice, progress);
  clear_openings(scene, shapes, filling, notes);
  const Skins skins(scene, shapes, around(scene, lattice), notes);
  settle_walls(shapes, skins.of_shape, filling, progress);
  check_filling(scene, shapes, room, filling);
  warn_of_filling(scene, shapes, filling, notes.warn);
  warn_of_coverage(scene, shapes, notes.warn);
  if (models::OpenBoundaries::is_on(scene)) {
    notes.say("closure: not searched, as water enters or leaves on purpose");
  } else {
    report_closure(scene, shapes, room, filling, notes);
  }
  progress.finish();

  const auto particles = static_cast<double>(filling.particles);
  const MemoryEstimate memory = estimate_memory(particles, scene.info.dimension);
  const bool in_ranges = !needs_all_particles(scene) && options.nodes_at_once < lattice.nodes();
  const double own = own_memory(filling, memory.host, in_ranges);
  notes.say(fmt::format("{} particles; the solver will need about {} for them, gencase {}", filling.particles,
                        format_bytes(memory.solver), format_bytes(own)));
  const double needed = options.larger_than_memory ? own : memory.total();
  if (needed > options.memory_limit) refuse_size(scene, particles, needed, options.memory_limit);

  Generated result{scene, {}, {}};
  const double gravity = column_gravity(scene, notes);
  const HydrostaticStart start(filling, shapes, gravity);
  Summary& summary = result.summary;
  summary.lattice_nodes = lattice.nodes();
  std::vector<ShapeRole> flowing = {ShapeRole::water};
  if (!models::SurfaceBedOfCase::is_on(scene)) flowing.push_back(ShapeRole::sediment);  // such a bed holds itself
  summary.fluid_height = start.fluid_height(flowing);
  resolve_speeds(result, notes);
  ParticleMaker maker(result.resolved, shapes, filling, start, summary.sound_speed);
  NamedNode node(lattice);
  Seam seam(result.resolved);
  const auto next_range = [&] {
    const Columns columns = maker.next_columns(in_ranges ? options.nodes_at_once : lattice.nodes());
    ParticleSet made = maker.make(columns);
    node.look(made);
    seam.look(made);
    made.info.lattice_node = node.anchor();
    require_bed_on_ground(result.resolved, made);
    start_flow(result.resolved, shapes, filling, columns, made);
    return made;
  };
  ParticleSet range = next_range();
  while (!maker.is_done()) {
    summary.count(range);
    take(std::move(range));
    range = next_range();
  }
  seam.require_water();
  summary.largest_pressure = maker.largest_pressure();
  if (scene.gencase.relaxation > 0) {
    const auto skin = make_flow_skin(room, around(scene, lattice), scene.numerics.spacing, scene.info.dimension, notes);
    const Relaxation relaxed =
        relax(range, shapes, *skin, filling, scene.gencase.relaxation, gravity, summary.sound_speed);
    notes.say(fmt::format(
        "relaxation: {} sweeps over {} particles beside walls; unevenness {:.3g} before, {:.3g} after; "
        "farthest move {}",
        relaxed.sweeps, relaxed.particles, relaxed.before, relaxed.after, format_quantity(relaxed.farthest, "m")));
  }
  switch (scene.model.seepage) {
    case SeepageModel::off:
      break;
    case SeepageModel::mixture:
      const std::size_t added = split_into_mixture(scene, shapes, filling, gravity, summary.sound_speed, range);
      notes.say(fmt::format("{} particles of pore water in the places of the grains (model.seepage)", added));
      break;
  }
  summary.shapes = summarise(shapes, filling);
  result.particles.info = range.info;
  result.particles.info.lattice_node = node.position();
  summary.count(range);
  take(std::move(range));
  return result;
}

}  // namespace thalweg::gencase
