#pragma once

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "tests/solver/scenes.hpp"

// Currents along walls made by hand, and what the walls do to them.
namespace thalweg::test {

/// A periodic scene without gravity that feels its walls.
template <int Dim>
Scene<Dim> friction_scene(double spacing, double length) {
  LatticeSetup<Dim> setup;
  setup.spacing = spacing;
  setup.length = length;
  setup.periodic = true;
  Scene<Dim> scene = make_scene_of(setup);
  scene.needs_near_walls = true;
  scene.wall_stress = {true, 1e-6F, 0.1F, 1};
  return scene;
}

/// Particles with the elements of their walls on the device, lists built.
template <class On, int Dim>
Loaded<Dim, On> load_with_elements(const Scene<Dim>& scene, const ParticleSet& from,
                                   const std::vector<WallMotion>& motions = {}) {
  Loaded<Dim, On> l{On{}, {}, scene};
  load_particles(l.on, l.p, scene, from);
  if (!motions.empty()) load_motions(l.on, l.p, motions, from);
  load_wall_elements(l.on, l.p, scene, from);
  rebuild_lists(l.on, l.p, scene);
  return l;
}

/// Gives water the velocity (u*/kappa) ln(height/z0) along a direction, with noise of u* to all sides, and walls of the
/// roughness ks [m].
inline void log_profile(ParticleSet& particles, const std::function<Vec3(const Vec3&)>& along, double friction_velocity,
                        double ks, const std::function<double(const Vec3&)>& height) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> noise(-friction_velocity, friction_velocity);
  const double z0 = 0.11 * 1e-6 / friction_velocity + 0.033 * ks;
  auto& roughness = particles.scalars[roughness_array];
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const bool water = particles.type[i] == ParticleType::water;
    roughness.push_back(water ? 0 : static_cast<float>(ks));
    if (!water) continue;
    const Vec3& x = particles.position[i];
    const double speed = friction_velocity / 0.41 * std::log(std::max(height(x), 0.1e-3) / z0);
    particles.velocity[i] = (speed * along(x) + Vec3(noise(random), 0, noise(random))).cast<float>();
  }
}

/// Gives all water one velocity [m/s].
inline void uniform_current(ParticleSet& particles, double speed) {
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const bool water = particles.type[i] == ParticleType::water;
    particles.velocity[i] = Eigen::Vector3f(water ? static_cast<float>(speed) : 0, 0, 0);
  }
}

/// Summed area of the elements [m^(dim-1)].
template <int Dim, class On>
double area_of(const Loaded<Dim, On>& l) {
  double sum = 0;
  for (const WallElement& element : copy_of(l.on, l.p.wall_element)) sum += double(element.area);
  return sum;
}

/// Takes out the particles i for which stays(i) is false, of a set as fill_lattice makes it.
template <class Stays>
void keep(ParticleSet& particles, const Stays& stays) {
  ParticleSet kept;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (!stays(i)) continue;
    kept.id.push_back(static_cast<std::int64_t>(kept.id.size()));
    kept.type.push_back(particles.type[i]);
    kept.position.push_back(particles.position[i]);
    kept.density.push_back(particles.density[i]);
    kept.mass.push_back(particles.mass[i]);
    kept.velocity.push_back(particles.velocity[i]);
    kept.pressure.push_back(particles.pressure[i]);
  }
  particles = kept;
}

/// Force of the walls on each particle of the fluid [N, in 2-D N/m], by the model's sweeps alone.
template <int Dim, class On, class Visit>
void each_force(Loaded<Dim, On>& l, const Visit& visit) {
  change(l, [](Seen& seen) {
    for (Rates& r : seen.rates) r = {};
  });
  add_wall_stress(l.on, l.p, l.scene);
  const Seen seen = look(l);
  for (Index i = 0; i < seen.fluid_count; ++i) {
    const float* a = seen.rates[i].acceleration;
    visit(Vec3(seen.position[i].x[0], seen.position[i].x[1], seen.position[i].x[2]),
          Vec3(double(seen.mass[i]) * Vec3(a[0], a[1], a[2])));
  }
}

/// Their sum.
template <int Dim, class On>
Vec3 drag_on_water(Loaded<Dim, On>& l) {
  Vec3 sum = Vec3::Zero();
  each_force(l, [&](const Vec3&, const Vec3& force) { sum += force; });
  return sum;
}
/// The sum of their parts along a direction that depends on the place.
template <int Dim, class On, class Direction>
double drag_on_water(Loaded<Dim, On>& l, const Direction& along) {
  double sum = 0;
  each_force(l, [&](const Vec3& x, const Vec3& force) { sum += force.dot(along(x)); });
  return sum;
}

/// Momentum of the fluid [kg m/s].
template <int Dim, class On>
Vec3 momentum(const Loaded<Dim, On>& l) {
  const Seen seen = look(l);
  Vec3 sum = Vec3::Zero();
  for (Index i = 0; i < seen.fluid_count; ++i) {
    const float* u = seen.record[i].velocity;
    sum += double(seen.mass[i]) * Vec3(u[0], u[1], u[2]);
  }
  return sum;
}

/// Mean velocity of the water [m/s].
inline Vec3 mean_velocity(const ParticleSet& particles) {
  Vec3 sum = Vec3::Zero();
  int water = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.type[i] != ParticleType::water) continue;
    sum += particles.velocity[i].cast<double>();
    ++water;
  }
  return sum / water;
}

}  // namespace thalweg::test
