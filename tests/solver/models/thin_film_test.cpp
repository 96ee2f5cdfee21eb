#include <gtest/gtest.h>

#include <cmath>

#include "tests/solver/models/wall_stress_scenes.hpp"

// A film of water one particle deep lies on a floor and is drawn out from its middle. By continuity over its depth its
// particles stay at half of what is left of it.
namespace thalweg {
namespace {

/// Of the films' middle third at the end [spacings].
struct Film {
  double half_depth = 0;  // from the particles' number
  double height = 0;      // mean, over the floor
  double lowest = 0;
};

constexpr double length = 0.6;    // [m] of the box
constexpr double extent = 0.12;   // [m] half of the film's length at the start
constexpr double strain = 5;      // [1/s] of the velocity at the start: as fast as two waves on the film at its ends
constexpr double duration = 0.3;  // [s] the film becomes 2.5 times as long

template <int Dim, class On = test::Cpu>
Film stretched(double spacing, bool corrected) {
  test::LatticeSetup<Dim> setup;
  setup.spacing = spacing;
  setup.length = length;
  setup.gravity[Dim - 1] = -9.81F;
  setup.sound_speed = 15;
  Scene<Dim> scene = test::make_scene_of(setup);
  if (corrected) use_thin_films(scene);
  const double floor = 4 * spacing;
  const double middle = length / 2;
  if (Dim == 3) {  // a strip, the same along y
    scene.domain_to[1] = 12 * spacing;
    bool periodic[Dim] = {};
    periodic[1] = true;
    scene.lattice = Lattice<Dim>(scene.domain_from, scene.domain_to, periodic, scene.list_reach);
  }
  const auto is_film = [&](const Vec3& x) {
    return std::abs(x.x() - middle) < extent && x.z() > floor && x.z() < floor + spacing;
  };
  ParticleSet particles = test::fill_lattice(
      scene, [&](const Vec3& x) { return x.z() < floor ? ParticleType::wall : ParticleType::water; });
  const ParticleSet all = particles;
  test::keep(particles, [&](std::size_t i) { return all.type[i] == ParticleType::wall || is_film(all.position[i]); });
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.type[i] != ParticleType::water) continue;
    particles.velocity[i].x() = static_cast<float>(strain * (particles.position[i].x() - middle));
  }
  auto l = test::load<On>(scene, particles);
  Workspace<On> work;
  Timing timing;
  double t = 0;
  while (t < duration * (1 - 1e-9)) t += advance(l.on, l.p, l.scene, work, duration - t, timing).step.dt;

  const test::Seen seen = test::look(l);
  const double wide = extent * (1 + strain * duration) / 3;
  Film film{0, 0, 1};
  int found = 0;
  double first = wide;
  double last = -wide;
  for (Index i = 0; i < seen.fluid_count; ++i) {
    const double x = seen.position[i].x[0] - middle;
    if (std::abs(x) > wide) continue;
    const double height = (seen.position[i].x[2] - floor) / spacing;
    film.height += height;
    film.lowest = std::min(film.lowest, height);
    first = std::min(first, x);
    last = std::max(last, x);
    ++found;
  }
  const double rows = Dim == 3 ? 12 : 1;
  film.height /= found;
  film.half_depth = 0.5 * (found / rows - 1) * spacing / (last - first);
  return film;
}

template <int Dim>
void expect_thin(double spacing) {
  const Film film = stretched<Dim>(spacing, true);
  EXPECT_LT(film.half_depth, 0.3);
  // In space alpha is the mean over both directions along the floor, of which one alone is stretched.
  EXPECT_NEAR(film.height, film.half_depth, Dim == 3 ? 0.05 : 0.025) << spacing;
  EXPECT_GT(film.lowest, 0) << spacing;
}

TEST(ThinFilm, KeepsItsMiddleAtHalfOfItsDepthInThePlane) {
  expect_thin<2>(0.01);
  expect_thin<2>(0.005);
}

TEST(ThinFilm, KeepsItsMiddleAtHalfOfItsDepthInSpace) { expect_thin<3>(0.01); }

TEST(ThinFilm, IsTheSameOnAGpu) {
  const Film cores = stretched<2>(0.01, true);
  const Film gpu = stretched<2, test::Guarded>(0.01, true);
  EXPECT_NEAR(gpu.height, cores.height, 1e-3);
  EXPECT_NEAR(gpu.lowest, cores.lowest, 1e-3);
}

TEST(ThinFilm, SinksTooFarWithoutTheCorrection) {
  const Film film = stretched<3>(0.01, false);
  EXPECT_LT(film.height, 0.2 * film.half_depth);
  EXPECT_LT(film.lowest, 0);
}

TEST(ThinFilm, LeavesTheInsideAlone) {
  const ThinFilm<3> law(0.015, 0.01);
  EXPECT_EQ(law.excess(0.25F, 0.9F, 1), 0);
  // On the lattice a film takes the share zS/alpha of the fluid's part; on the floor it takes none.
  EXPECT_NEAR(law.excess(0.25F, 0.43F, 0), 0.5, 0.03);
  EXPECT_EQ(law.excess(0.5F, 0.43F, 0), 1);
}

}  // namespace
}  // namespace thalweg
