#include "device_scenes.hpp"

#include <algorithm>
#include <map>

#include "solver/models/openings/make_openings.hpp"
#include "solver/models/surface_bed/make_surface_bed.hpp"
#include "tests/solver/pvc_grains.hpp"

namespace thalweg::test {
namespace {

constexpr float g = 9.81F;

/// A tank 0.2 m wide with a step of sediment under water, about to slump.
template <int Dim>
DeviceScene tank(const std::string& name) {
  LatticeSetup<Dim> setup;
  if (Dim == 3) setup.length = 0.12;
  setup.gravity.vertical() = -g;
  Scene<Dim> scene = make_scene_of(setup);
  scene.has_sediment = true;
  scene.sediment.yield_coefficient = 0.6F;
  scene.sediment.friction_tangent = 0.78F;
  scene.sediment.regularisation = 100;
  scene.sediment.consistency = 1e-3F;
  scene.sediment.submerged_weight = 300 * g;
  scene.sediment.pore_stiffness = 1000.0F * 20 * 20 / 7;
  scene.sediment.laplace_tolerance = 0.01F;
  const double wall = 0.03;
  const double length = setup.length;
  ParticleSet particles = fill_lattice(scene, [&](const Vec3& x) {
    if (x.z() < wall || x.x() < wall || x.x() > length - wall) return ParticleType::wall;
    return x.x() < 0.45 * length && x.z() < 0.6 * length ? ParticleType::sediment : ParticleType::water;
  });
  return {name, scene, std::move(particles)};
}

Scene<2>& plane(DeviceScene& s) { return std::get<Scene<2>>(s.scene); }

/// Rest, bed load and suspension under a current.
DeviceScene eroding() {
  DeviceScene s = tank<2>("three states");
  Scene<2>& scene = plane(s);
  scene.has_states = scene.may_rest = true;
  scene.rest = {0.04F, 0.06F, 3e-3F, 0.001F};
  scene.erosion = erosion_of_pvc<2>();
  for (std::size_t i = 0; i < s.particles.size(); ++i) {
    if (s.particles.type[i] == ParticleType::water) s.particles.velocity[i].x() = 0.4F;
  }
  s.steps = 40;
  return s;
}

/// The same with bed load that drifts at the rate of a law.
DeviceScene drifting() {
  DeviceScene s = eroding();
  s.name = "bed load by a law";
  Scene<2>& scene = plane(s);
  scene.has_drift = scene.erosion.by_law = true;
  const auto dp = static_cast<float>(scene.spacing);
  scene.bed_load = {
      true,   false,  BedLoad::meyer_peter_mueller, SlopeEffect::friction, 4.766e-4F, 0.53F * dp, dp, 0.2F,
      3 * dp, 300 * g};
  return s;
}

/// The same with water that carries grains, some of it packed.
DeviceScene loaded() {
  DeviceScene s = drifting();
  s.name = "grains in the water";
  Scene<2>& scene = plane(s);
  scene.water_has_grains = true;
  const auto dp = static_cast<float>(scene.spacing);
  scene.suspended_load = {true, PickUp::van_rijn, 0.1365F, 0.54F, 0.53F, 3.5e-3F, 1e-5F, 1, dp, 0.2F};
  std::vector<double>& grains = s.particles.doubles[field::grains.name];
  for (std::size_t i = 0; i < s.particles.size(); ++i) {
    const bool water = s.particles.type[i] == ParticleType::water;
    grains.push_back(water ? (i % 11 == 0 ? 0.5 : 0.02) * double(s.particles.mass[i]) / 1000 : 0);
  }
  return s;
}

/// Three states between a wall that pushes and one that turns, partly out of the domain.
DeviceScene pushed() {
  DeviceScene s = eroding();
  s.name = "moving walls";
  plane(s).has_moving_walls = plane(s).walls_move = true;
  auto& motion = s.particles.scalars[motion_array];
  for (std::size_t i = 0; i < s.particles.size(); ++i) {
    const double x = s.particles.position[i].x();
    const bool moves = s.particles.type[i] == ParticleType::wall && (x < 0.03 || x > 0.17);
    if (moves) s.particles.type[i] = ParticleType::moving_wall;
    motion.push_back(moves ? (x < 0.03 ? 1.0F : 2.0F) : 0.0F);
  }
  s.motions = {{{{1, 0, 0}, {0, 0, 0}, false}, {{0, 0, 0, 20}}},
               {{{0, -1, 0}, {0.185, 0, 0.1}, true}, {{1e-3, 0, 0.5}}}};
  return s;
}

/// Grains and pore water in the same places.
DeviceScene mixture() {
  DeviceScene s = tank<2>("mixture");
  Scene<2>& scene = plane(s);
  scene.sediment_density = 1540;
  scene.seepage.mixture = true;
  scene.seepage.solids_at_rest = 0.55F;
  scene.seepage.grain_diameter = 3.5e-3F;
  scene.seepage.skeleton_stiffness = 0.55F * 540 * 20 * 20;
  scene.fast_wave = std::sqrt(1 + 0.55 * 1000 / (0.45 * 1540));
  ParticleSet& p = s.particles;
  const std::size_t n = p.size();
  const double cell = scene.spacing * scene.spacing;
  for (std::size_t i = 0; i < n; ++i) {
    if (p.type[i] != ParticleType::sediment) continue;
    p.density[i] = density_in_files(scene, kind::deposit);
    p.mass[i] = static_cast<float>(0.55 * 1540 * cell);
    p.id.push_back(static_cast<std::int64_t>(p.id.size()));
    p.type.push_back(ParticleType::water);
    p.position.push_back(p.position[i]);
    p.velocity.push_back(p.velocity[i]);
    p.pressure.push_back(0);
    p.density.push_back(1000);
    p.mass.push_back(static_cast<float>(0.45 * 1000 * cell));
  }
  return s;
}

DeviceScene with(DeviceScene s, const std::string& name, void (*change)(Scene<2>&)) {
  s.name = name;
  change(plane(s));
  return s;
}

void damp_sound(Scene<2>& s) { s.acoustic_damping = 0.5F * s.sound_speed * static_cast<float>(s.smoothing_length); }

void feel_walls(Scene<2>& s) {
  s.needs_near_walls = true;
  s.wall_stress = {true, 1e-6F, 0.1F, 1};
}

/// Fills the scene with water that runs over a floor between two openings; with a layer of sand in place of the floor's
/// highest row, which under the zone of the inlet is left for bed load that comes in.
void fill_channel(DeviceScene& s, bool fed) {
  const ParticleSet all = fill_lattice(plane(s), [fed](const Vec3& x) {
    if (x.z() > 0.03) return ParticleType::water;
    return fed && x.z() > 0.02 && x.x() > 0.06 && x.x() < 0.14 ? ParticleType::sediment : ParticleType::wall;
  });
  s.particles = {};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Vec3& x = all.position[i];
    const bool water = all.type[i] == ParticleType::water;
    if (water && (x.x() < 0.06 || x.x() > 0.19 || x.z() > 0.11)) continue;
    if (fed && x.x() < 0.06 && x.z() > 0.02) continue;
    s.particles.id.push_back(all.id[i]);
    s.particles.type.push_back(all.type[i]);
    s.particles.position.push_back(x);
    s.particles.density.push_back(all.density[i]);
    s.particles.mass.push_back(all.mass[i]);
    s.particles.velocity.emplace_back(water ? 0.5F : 0, 0, 0);
    s.particles.pressure.push_back(0);
  }
}

/// Water that runs over a floor from an inlet to a tail water.
DeviceScene open_channel() {
  DeviceScene s = tank<2>("openings");
  plane(s).has_sediment = false;
  plane(s).has_openings = true;
  fill_channel(s, false);
  s.steps = 40;
  s.has_openings = true;
  return s;
}

/// The same over a bed that moves, with bed load that comes in through the inlet.
DeviceScene fed_channel() {
  DeviceScene s = drifting();
  s.name = "openings with bed load";
  plane(s).has_openings = true;
  fill_channel(s, true);
  s.has_openings = true;
  return s;
}

/// The case of a bed that is a surface, with windows so short that the bed moves and arrives.
Case case_of_surface_bed() {
  Case of;
  of.info.dimension = 2;
  of.domain.gravity = Vec3(0, 0, -9.81);
  of.numerics.spacing = 0.01;
  of.numerics.smoothing_ratio = 1.5;
  of.numerics.maximum_speed = 2;
  of.water.density = 1000;
  of.water.viscosity = 1e-3;
  of.model.sediment = SedimentModel::surface;
  SedimentTable& sand = of.sediments["sand"];
  sand.grain_density = 2650;
  sand.grain_diameter = 1e-3;
  sand.porosity = 0.4;
  sand.friction_angle = 0.56;
  of.surface_bed.window = 1e-3;
  of.surface_bed.step = 0.01;
  return of;
}

/// Water that runs over a bed that is a surface, with a hump.
DeviceScene over_a_surface() {
  DeviceScene s = tank<2>("bed as a surface");
  Scene<2>& scene = plane(s);
  scene.has_sediment = false;
  feel_walls(scene);
  scene.surface_bed = {true, 1e-3F, 1000, 4};
  scene.walls_move = scene.keeps_wall_shear = true;
  s.particles = fill_lattice(scene, [](const Vec3& x) {
    if (x.z() < 0.03 || x.x() < 0.03 || x.x() > 0.17) return ParticleType::wall;
    return x.z() < (x.x() < 0.1 ? 0.08 : 0.07) ? ParticleType::sediment : ParticleType::water;
  });
  for (std::size_t i = 0; i < s.particles.size(); ++i) {
    if (s.particles.type[i] == ParticleType::water) s.particles.velocity[i].x() = 0.5F;
  }
  s.before_laying = s.particles;
  make_surface_bed(case_of_surface_bed(), s.particles);
  s.steps = 60;
  return s;
}

/// A driven current with the eddies of a mixing length.
void drive_a_current(Scene<2>& s) {
  feel_walls(s);
  s.mixing_length = true;
  s.current.on = s.current.controlled = true;
  s.bed_load.holds_surface = true;
  s.current.start = {0.5, 0.2, 0, 0, 2.5};
}

/// The same where a zone guides it.
void guide_a_current(Scene<2>& s) {
  drive_a_current(s);
  s.current.start_friction = 0.03;
  s.current.guide = {true, 0, 0.06, 0.1, 0.2, 1e-3, 1e-6};
}

}  // namespace

std::vector<DeviceScene> device_scenes() {
  const DeviceScene slump = tank<2>("slump");
  return {slump,
          tank<3>("slump in space"),
          eroding(),
          drifting(),
          loaded(),
          pushed(),
          mixture(),
          with(slump, "pressure from Laplace's equation",
               [](Scene<2>& s) { s.sediment.effective_pressure = EffectivePressure::laplace; }),
          with(slump, "pressure of state", [](Scene<2>& s) { s.sediment.effective_pressure = EffectivePressure::eos; }),
          with(slump, "capped viscosity", [](Scene<2>& s) { s.viscosity = ViscosityTreatment::capped; }),
          with(slump, "stress on walls", feel_walls),
          with(pushed(), "stress on moving walls", feel_walls),
          with(slump, "water that sticks to walls", [](Scene<2>& s) { s.water_sticks = s.needs_near_walls = true; }),
          with(slump, "sub-particle stress", [](Scene<2>& s) { s.sub_particle_stress = true; }),
          with(slump, "current with a mixing length", drive_a_current),
          with(loaded(), "current with a mixing length over loose grains", drive_a_current),
          with(slump, "current with a guide zone", guide_a_current),
          with(slump, "shifting", [](Scene<2>& s) { use_shifting(s); }),
          with(slump, "acoustic damper", damp_sound),
          with(mixture(), "mixture with acoustic damper", damp_sound),
          open_channel(),
          fed_channel(),
          over_a_surface(),
          with(slump, "pore pressure", [](Scene<2>& s) {
            s.pores.on = true;
            s.pores.consolidation = 1e-3F;
            s.pores.stiffness = 1300.0F * 20 * 20;
          })};
}

std::shared_ptr<Openings> DeviceScene::openings() const {
  if (!has_openings) return nullptr;
  Case of;
  of.info.dimension = 2;
  of.numerics.spacing = 0.01;
  of.numerics.smoothing_ratio = 1.5;
  of.numerics.list_skin = 0.1;
  of.numerics.sound_speed_factor = 10;
  of.numerics.maximum_speed = 2;
  of.water.density = 1000;
  of.water.viscosity = 1e-3;
  const bool fed = std::get<Scene<2>>(scene).has_sediment;
  if (fed) {
    SedimentTable& sand = of.sediments["sand"];
    sand.grain_density = 1540;
    sand.grain_diameter = 3.5e-3;
    sand.porosity = 0.47;
  }
  Inlet& inlet = of.inlets.emplace_back();
  inlet.name = "west";
  if (fed) {
    inlet.bed_load = InletBedLoad::fixed;
    inlet.bed_load_rate = 1e-3;  // a layer at 0.19 m/s: some particles cross the plane within the run
  }
  inlet.at = Vec3(0.06, 0, 0.08);
  inlet.direction = Vec3::UnitX();
  inlet.height = 0.1;
  inlet.velocity = 0.5;
  inlet.surface = InletSurface::level;
  inlet.level = 0.11;
  Outlet& outlet = of.outlets.emplace_back();
  outlet.name = "east";
  outlet.at = Vec3(0.14, 0, 0.08);
  outlet.direction = Vec3::UnitX();
  outlet.height = 0.1;
  outlet.kind = OutletKind::level;
  outlet.level = 0.11;
  return make_openings(of, std::nullopt);
}

std::shared_ptr<SurfaceBed> DeviceScene::surface_bed(const ParticleSet& from) const {
  if (before_laying.size() == 0) return nullptr;
  ParticleSet start = from.facts.contains(surface_bed_fact) ? from : before_laying;
  return make_surface_bed(case_of_surface_bed(), start);
}

Difference difference(const ParticleSet& start, const ParticleSet& a, const ParticleSet& b) {
  std::map<std::int64_t, std::size_t> in_a;
  std::map<std::int64_t, std::size_t> in_b;
  for (std::size_t i = 0; i < a.size(); ++i) in_a[a.id[i]] = i;
  for (std::size_t i = 0; i < b.size(); ++i) in_b[b.id[i]] = i;
  Difference d;
  for (std::size_t i = 0; i < start.size(); ++i) {
    // Particles may have left through an opening, in both or in none.
    if (!in_a.contains(start.id[i]) && !in_b.contains(start.id[i])) continue;
    const std::size_t at_a = in_a.at(start.id[i]);
    const std::size_t at_b = in_b.at(start.id[i]);
    d.moved = std::max(d.moved, (a.position[at_a] - start.position[i]).norm());
    d.apart = std::max(d.apart, (a.position[at_a] - b.position[at_b]).norm());
    if (!a.state.empty() && a.state[at_a] != b.state[at_b]) ++d.other_states;
  }
  return d;
}

}  // namespace thalweg::test
