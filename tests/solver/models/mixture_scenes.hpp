#pragma once

#include <gtest/gtest.h>

#include "solver/step.hpp"
#include "tests/solver/scenes.hpp"

// Columns of grains and pore water on one lattice, for the tests of the mixture.
namespace thalweg::test::mixture {

inline constexpr double grain_density = 1540;
inline constexpr double diameter = 3.5e-3;
inline constexpr double g = 9.81;

/// A box around `width` x `height`, periodic in x, with walls 3 spacings thick below and, if closed, above.
struct Column {
  double spacing = 5e-3;
  double width = 0.06;
  double height = 0.06;
  double porosity = 0.45;         // filled with everywhere
  double porosity_packed = 0.45;  // at which grains touch
  double sound_speed = 2;
  double cohesion = 0;
  Vec<2, float> gravity{};
  bool periodic_height = false;
};

inline Scene<2> scene_of(const Column& c) {
  LatticeSetup<2> setup;
  setup.spacing = c.spacing;
  setup.sound_speed = c.sound_speed;
  Scene<2> s = make_scene_of(setup);
  const double walls = c.periodic_height ? 0 : 3 * c.spacing;
  s.domain_from = {0, -walls};
  s.domain_to = {c.width, c.height + walls};
  s.lattice_node = {0.5 * c.spacing, 0.5 * c.spacing - walls};
  const bool periodic[2] = {true, c.periodic_height};
  s.lattice = Lattice<2>(s.domain_from, s.domain_to, periodic, s.list_reach);
  s.gravity = c.gravity;
  s.has_sediment = true;
  s.sediment_density = static_cast<float>(grain_density);
  s.sediment.yield_coefficient = 0.6F;
  s.sediment.yield_cohesion = static_cast<float>(c.cohesion);
  s.sediment.regularisation = 100;
  s.sediment.consistency = 1e-3F;
  s.viscous_tolerance = 1e-5;
  const double solids = 1 - c.porosity_packed;
  s.sediment.submerged_weight = static_cast<float>(solids * (grain_density - 1000) * -double(c.gravity[1]));
  s.seepage.mixture = true;
  s.seepage.solids_at_rest = static_cast<float>(solids);
  s.seepage.grain_diameter = static_cast<float>(diameter);
  s.seepage.skeleton_stiffness = static_cast<float>(solids * (grain_density - 1000) * c.sound_speed * c.sound_speed);
  s.fast_wave = std::sqrt(1 + solids * 1000 / (c.porosity_packed * grain_density));
  return s;
}

/// Adds a particle at rest, with the next id. Density [kg/m^3], mass [kg].
inline void add(ParticleSet& to, ParticleType type, const Vec3& x, double density, double mass) {
  to.id.push_back(static_cast<std::int64_t>(to.id.size()));
  to.type.push_back(type);
  to.position.push_back(x);
  to.velocity.push_back(Eigen::Vector3f::Zero());
  to.pressure.push_back(0);
  to.density.push_back(static_cast<float>(density));
  to.mass.push_back(static_cast<float>(mass));
}

/// Grains and pore water on every node of the column, the water carrying the weight of both.
inline ParticleSet fill(const Column& c, const Scene<2>& scene, bool open_above) {
  ParticleSet p = fill_lattice(scene, [&](const Vec3& x) {
    const bool inside = c.periodic_height || (x.z() > 0 && x.z() < c.height);
    return inside ? ParticleType::sediment : ParticleType::wall;
  });
  const double cell = c.spacing * c.spacing;
  const std::size_t nodes = p.size();
  ParticleSet kept;
  for (std::size_t i = 0; i < nodes; ++i) {
    const Vec3 x = p.position[i];
    if (p.type[i] == ParticleType::wall) {
      if (!open_above || x.z() < 0) add(kept, ParticleType::wall, x, 1000, 1000 * cell);
      continue;
    }
    const double mixed = c.porosity * 1000 + (1 - c.porosity) * grain_density;
    const double pressure = mixed * -double(c.gravity[1]) * (c.height - x.z());
    const double water = 1000 * std::pow(1 + 7 * pressure / (1000 * c.sound_speed * c.sound_speed), 1.0 / 7);
    add(kept, ParticleType::sediment, x, double(density_in_files(scene, kind::deposit)),
        (1 - c.porosity) * grain_density * cell);
    add(kept, ParticleType::water, x, water, c.porosity * water * cell);
  }
  return kept;
}

/// Steps until `time`.
template <class On>
void run(Loaded<2, On>& l, Workspace<On>& work, double time) {
  Timing timing;
  for (double t = 0; t < time * (1 - 1e-9);) {
    const StepResult r = advance(l.on, l.p, l.scene, work, time - t, timing);
    ASSERT_FALSE(has_diverged(r)) << "t = " << t << " s";
    t += r.step.dt;
  }
}

struct Mean {
  double velocity = 0;  // summed [m/s]
  int count = 0;
  [[nodiscard]] double value() const { return velocity / count; }
};

/// Mean velocity component of the particles of a kind between two heights.
inline Mean mean_velocity(const Seen& seen, float kind, int component, double from, double to) {
  Mean m;
  for (Index i = 0; i < seen.fluid_count; ++i) {
    const double z = seen.position[i].x[2];
    if (seen.record[i].kind != kind || z < from || z > to) continue;
    m.velocity += double(seen.record[i].velocity[component]);
    ++m.count;
  }
  return m;
}

}  // namespace thalweg::test::mixture
