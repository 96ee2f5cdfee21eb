#include "solver/models/states/bed_states.hpp"

#include <gtest/gtest.h>

#include "pvc_grains.hpp"
#include "scenes.hpp"

namespace thalweg {
namespace {

using test::LatticeSetup;

constexpr double bed_height = 0.1;  // [m]

/// Half bed, half water over it, the PVC grains of the Louvain flume.
Scene<2> eroding_scene() {
  LatticeSetup<2> setup;
  setup.gravity = {0, -9.81F};
  Scene<2> scene = test::make_scene_of(setup);
  scene.has_sediment = scene.has_states = true;
  scene.sediment.friction_tangent = 0.78F;
  scene.erosion = test::erosion_of_pvc<2>();
  return scene;
}

ParticleType half_bed(const Vec3& x) { return x.z() < bed_height ? ParticleType::sediment : ParticleType::water; }

test::Loaded<2> load_bed(const Scene<2>& scene, float water_speed) {
  ParticleSet p = test::fill_lattice(scene, half_bed);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.type[i] == ParticleType::water) p.velocity[i].x() = water_speed;
  }
  auto l = test::load(scene, p);
  apply_equation_of_state(l.on, l.p, scene);
  return l;
}

void update_states(test::Loaded<2>& l, const Scene<2>& scene, double dt) {
  StepState state = test::step_of(dt);
  update_bed_states(l.on, l.p, scene, &state);
}

bool in_the_middle(const test::Loaded<2>& l, Index i) {
  return l.p.position[i].x[0] > 0.05 && l.p.position[i].x[0] < 0.15;
}
/// Layers below the surface, 0 the top one; -1 in the water.
int layer_of(const test::Loaded<2>& l, Index i) {
  if (!is_sediment(l.p.record[i])) return -1;
  return static_cast<int>((bed_height - l.p.position[i].x[2]) / l.scene.spacing);
}

TEST(BedStates, SeeTheTopLayerAsSurfaceAndTheWaterOverIt) {
  auto l = load_bed(eroding_scene(), 0.6F);
  update_states(l, l.scene, 1e-4);
  int tops = 0;
  for (Index i = 0; i < l.p.count; ++i) {
    if (!in_the_middle(l, i) || layer_of(l, i) < 0) continue;
    const BedSurface& s = l.p.bed[i];
    if (layer_of(l, i) == 0) {
      ++tops;
      EXPECT_LT(s.fill, 0.8);
      EXPECT_NEAR(s.normal[2], 1, 1e-4);
      EXPECT_NEAR(s.water_velocity[0], 0.6, 1e-5);
      // The law of the wall at the mean height of the water in reach.
      EXPECT_GT(s.water_height, 0.5 * l.scene.spacing);
      EXPECT_LT(s.water_height, 1.5 * l.scene.spacing);
      const float u = friction_velocity(0.6F, s.water_height, 1e-6F, 3.5e-3F).friction_velocity;
      EXPECT_NEAR(s.shear_stress, 1000 * u * u, 1e-2 * s.shear_stress);
      EXPECT_EQ(l.p.record[i].kind, kind::bed_load);
    } else {
      EXPECT_GT(s.water_share > 0 ? s.fill : 1, 0.95);
      EXPECT_EQ(l.p.record[i].kind, kind::deposit);
    }
  }
  EXPECT_EQ(tops, 10);
}

TEST(BedStates, SeeNoSurfaceTowardsAWall) {
  // The same bed between two side walls, as thick as the kernel's support: it goes on behind them.
  const Scene<2> scene = eroding_scene();
  const double wall = 0.04;
  ParticleSet p = test::fill_lattice(
      scene, [&](const Vec3& x) { return x.x() < wall || x.x() > 0.2 - wall ? ParticleType::wall : half_bed(x); });
  auto l = test::load(scene, p);
  apply_equation_of_state(l.on, l.p, scene);
  extrapolate_to_walls(l.on, l.p, scene);
  update_states(l, scene, 1e-4);
  int seen = 0;
  for (Index i = 0; i < l.p.count; ++i) {
    if (l.p.position[i].x[0] > wall + scene.spacing || layer_of(l, i) < 0 || layer_of(l, i) > 2) continue;
    ++seen;
    // What the wall continues is a mean over the kernel: some degrees, and some hundredths of a full bed.
    if (layer_of(l, i) == 0) {
      EXPECT_GT(l.p.bed[i].normal[2], std::cos(0.1));
    }
    EXPECT_EQ(l.p.bed[i].fill < scene.erosion.surface_fill, layer_of(l, i) == 0) << l.p.bed[i].fill;
  }
  EXPECT_EQ(seen, 3);
}

TEST(BedStates, StartToMoveAtTheCriticalStress) {
  // theta_cr of these grains is near 0.05: 0.93 Pa. The stress grows with the square of the speed, whose critical value
  // is looked for from both sides.
  const Scene<2> scene = eroding_scene();
  const auto moved = [&](float speed) {
    auto l = load_bed(scene, speed);
    update_states(l, l.scene, 1e-4);
    Index top = 0;
    while (!in_the_middle(l, top) || layer_of(l, top) != 0) ++top;
    const BedSurface& s = l.p.bed[top];
    EXPECT_EQ(l.p.record[top].kind == kind::bed_load, s.shear_stress > s.critical_stress);
    return s.shear_stress > s.critical_stress;
  };
  EXPECT_FALSE(moved(0.1F));
  EXPECT_FALSE(moved(0.25F));
  EXPECT_TRUE(moved(0.6F));
}

TEST(BedStates, BecomeDepositAgainAfterTheReturnTime) {
  auto l = load_bed(eroding_scene(), 0);
  Index top = 0;
  while (!in_the_middle(l, top) || layer_of(l, top) != 0) ++top;
  l.p.record[top].kind = kind::bed_load;
  const double dt = 1e-3;
  int steps = 0;
  while (l.p.record[top].kind == kind::bed_load && steps < 100) {
    update_states(l, l.scene, dt);
    ++steps;
  }
  EXPECT_EQ(l.p.record[top].kind, kind::deposit);
  EXPECT_NEAR(steps, 19, 1.5);

  // As printed there is no way back.
  auto printed = load_bed(eroding_scene(), 0);
  printed.scene.erosion.as_printed = true;
  printed.p.record[top].kind = kind::bed_load;
  for (int k = 0; k < 100; ++k) update_states(printed, printed.scene, dt);
  EXPECT_EQ(printed.p.record[top].kind, kind::bed_load);
}

TEST(BedStates, LiftADiluteGrainAndLetItSettle) {
  // One grain a layer over the bed, in water that runs at 1 m/s.
  const Scene<2> scene = eroding_scene();
  const Vec3 at(0.105, 0, bed_height + 0.015);
  ParticleSet p = test::fill_lattice(
      scene, [&](const Vec3& x) { return (x - at).norm() < 1e-6 ? ParticleType::sediment : half_bed(x); });
  std::size_t grain = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.type[i] == ParticleType::water) p.velocity[i].x() = 1;
    if ((p.position[i] - at).norm() < 1e-6) grain = i;
  }
  auto l = test::load(scene, p);
  apply_equation_of_state(l.on, l.p, scene);
  Index i = 0;
  while (l.p.id[i] != static_cast<std::int64_t>(grain)) ++i;
  Record& r = l.p.record[i];

  r.kind = kind::bed_load;
  r.velocity[0] = 0.9F;
  update_states(l, scene, 1e-4);
  ASSERT_LE(l.p.bed[i].concentration, 0.312);
  EXPECT_EQ(r.kind, kind::bed_load) << "it moves along the bed, not away from it";
  r.velocity[2] = 0.2F;
  update_states(l, scene, 1e-4);
  EXPECT_EQ(r.kind, kind::suspended);
  update_states(l, scene, 1e-4);
  EXPECT_EQ(r.kind, kind::suspended) << "nothing has changed";
  r.velocity[0] = 0.05F;
  r.velocity[2] = 0.05F;
  update_states(l, scene, 1e-4);
  EXPECT_EQ(r.kind, kind::suspended) << "slow, but rising";
  r.velocity[2] = -0.05F;
  update_states(l, scene, 1e-4);
  EXPECT_EQ(r.kind, kind::bed_load);

  // As printed, rising slowly is settling: one state in this step, another in the next.
  Scene<2> printed = scene;
  printed.erosion.as_printed = true;
  r.velocity[2] = 0.05F;
  update_states(l, printed, 1e-4);
  EXPECT_EQ(r.kind, kind::suspended);
  update_states(l, printed, 1e-4);
  EXPECT_EQ(r.kind, kind::bed_load);
}

TEST(BedStates, TakeTheNearestWaterWhenAskedTo) {
  Scene<2> scene = eroding_scene();
  scene.erosion.bed_shear = BedShear::nearest;
  ParticleSet p = test::fill_lattice(scene, half_bed);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.type[i] == ParticleType::water) p.velocity[i].x() = p.position[i].z() < bed_height + 0.01 ? 0.3F : 0.9F;
  }
  auto l = test::load(scene, p);
  apply_equation_of_state(l.on, l.p, scene);
  update_states(l, scene, 1e-4);
  for (Index i = 0; i < l.p.count; ++i) {
    if (!in_the_middle(l, i) || layer_of(l, i) != 0) continue;
    EXPECT_EQ(l.p.bed[i].water_velocity[0], 0.3F);
    EXPECT_NEAR(l.p.bed[i].water_height, scene.spacing, 1e-6);
  }
}

}  // namespace
}  // namespace thalweg
