#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/solver/scenes.hpp"

// The scene and the stages that tests of the implicit and of the explicit viscosity share.
namespace thalweg::test {

/// A block of sediment and water between two walls, stirred, with viscosities from 0.01 to 1e4 Pa s.
template <class On>
Loaded<2, On> stirred_block() {
  LatticeSetup<2> setup;
  setup.length = 0.12;
  setup.gravity = {0, -9.81F};
  Scene<2> scene = make_scene_of(setup);
  scene.has_sediment = true;
  scene.viscous_tolerance = 1e-6;
  ParticleSet p = fill_lattice(
      scene,
      [](const Vec3& x) {
        if (x.z() < 0.02) return ParticleType::wall;
        return x.z() < 0.08 ? ParticleType::sediment : ParticleType::water;
      },
      0.2);
  std::mt19937 random(5);
  std::uniform_real_distribution<float> number(-1, 1);
  p.viscosity.resize(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.type[i] != ParticleType::wall) p.velocity[i] = 0.1F * Eigen::Vector3f(number(random), 0, number(random));
    p.viscosity[i] = std::pow(10.0F, 3 * number(random) + 1);
  }
  auto l = load<On>(scene, p);
  apply_equation_of_state(l.on, l.p, scene);
  return l;
}

/// The viscous part of a step by itself, with all it tries, as the step does it (step.hpp, advance).
template <class On>
ViscousResult apply_viscosity(TestStep<2, On>& s) {
  const auto iterate_and_end = [&] {
    ViscosityModel::iterate_implicit(s.step);
    ViscosityModel::end_implicit(s.step);
  };
  ViscosityModel::begin_implicit(s.step);
  iterate_and_end();
  s.step.now = s.read();
  ViscosityModel::finish(s.step, iterate_and_end);
  EXPECT_EQ(s.step.now.moves, s.step.now.viscous.converged);
  return s.work.viscous_result;
}
template <class On>
ViscousResult apply_viscosity(Loaded<2, On>& l, double dt) {
  TestStep s(l, dt);
  return apply_viscosity(s);
}

/// Takes the walls out of every sum.
template <class On>
void remove_walls(Loaded<2, On>& l) {
  change(l, [](Seen& seen) {
    for (Index i = seen.fluid_count; i < seen.count; ++i) seen.record[i].volume = 0;
  });
}

/// Without walls in reach momentum stays, and energy falls.
inline void expect_momentum_kept(const Totals& before, const Totals& after) {
  const double scale = std::sqrt(2 * before.kinetic_energy * (before.water_mass + before.sediment_mass));
  EXPECT_LT(std::abs(after.momentum[0] - before.momentum[0]), 1e-6 * scale);
  EXPECT_LT(std::abs(after.momentum[2] - before.momentum[2]), 1e-6 * scale);
  EXPECT_LT(after.kinetic_energy, before.kinetic_energy);
}

}  // namespace thalweg::test
