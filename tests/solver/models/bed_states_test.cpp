#include "solver/models/states/bed_states.hpp"

#include <gtest/gtest.h>

#include "solver/models/states/flat_bed.hpp"
#include "tests/solver/pvc_grains.hpp"
#include "tests/solver/scenes.hpp"

namespace thalweg {
namespace {

using test::LatticeSetup;

template <class On>
class BedStates : public testing::Test {};
TYPED_TEST_SUITE(BedStates, test::Backends, test::BackendNames);

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

template <class On>
test::Loaded<2, On> load_bed(const Scene<2>& scene, float water_speed) {
  ParticleSet p = test::fill_lattice(scene, half_bed);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.type[i] == ParticleType::water) p.velocity[i].x() = water_speed;
  }
  auto l = test::load<On>(scene, p);
  apply_equation_of_state(l.on, l.p, scene);
  return l;
}

/// Updates the states in a step of dt seconds, and shows what came of it.
template <class On>
test::Seen update_states(test::Loaded<2, On>& l, const Scene<2>& scene, double dt) {
  test::TestStep step(l, dt);
  update_bed_states(l.on, l.p, scene, step.state());
  return test::look(l);
}

bool in_the_middle(const test::Seen& seen, Index i) {
  return seen.position[i].x[0] > 0.05 && seen.position[i].x[0] < 0.15;
}
/// Layers below the surface, 0 the top one; -1 in the water.
int layer_of(const test::Seen& seen, Index i) {
  if (!is_sediment(seen.record[i])) return -1;
  return static_cast<int>((bed_height - seen.position[i].x[2]) / eroding_scene().spacing);
}
/// A grain of the top layer.
Index top_of(const test::Seen& seen) {
  Index top = 0;
  while (!in_the_middle(seen, top) || layer_of(seen, top) != 0) ++top;
  return top;
}
/// Gives a grain a state.
template <class On>
void set_kind(test::Loaded<2, On>& l, Index grain, float kind) {
  test::change(l, [&](test::Seen& seen) { seen.record[grain].kind = kind; });
}

TYPED_TEST(BedStates, SeeTheTopLayerAsSurfaceAndTheWaterOverIt) {
  auto l = load_bed<TypeParam>(eroding_scene(), 0.6F);
  const test::Seen seen = update_states(l, l.scene, 1e-4);
  int tops = 0;
  for (Index i = 0; i < seen.count; ++i) {
    if (!in_the_middle(seen, i) || layer_of(seen, i) < 0) continue;
    const BedSurface& s = seen.bed[i];
    if (layer_of(seen, i) == 0) {
      ++tops;
      EXPECT_LT(s.fill, 0.8);
      EXPECT_NEAR(s.normal[2], 1, 1e-4);
      EXPECT_NEAR(s.water_velocity[0], 0.6, 1e-5);
      // The law of the wall at the mean height of the water in reach.
      EXPECT_GT(s.water_height, 0.5 * l.scene.spacing);
      EXPECT_LT(s.water_height, 1.5 * l.scene.spacing);
      const float u = friction_velocity(0.6F, s.water_height, 1e-6F, 3.5e-3F).friction_velocity;
      EXPECT_NEAR(s.shear_stress, 1000 * u * u, 1e-2 * s.shear_stress);
      EXPECT_EQ(seen.record[i].kind, kind::bed_load);
    } else {
      EXPECT_GT(s.water_share > 0 ? s.fill : 1, 0.95);
      EXPECT_EQ(seen.record[i].kind, kind::deposit);
    }
  }
  EXPECT_EQ(tops, 10);
}

// A grain that lies on a flat bed has most of the water in reach beside it and not above. The stress on the bed is known:
// the water has the logarithmic profile over it. With heights over its own back the grain felt seven times as much.
TYPED_TEST(BedStates, FeelTheBedsStressWhereOneStandsOut) {
  Scene<2> scene = eroding_scene();
  scene.erosion.by_law = true;
  know_flat_beds(scene);
  constexpr float friction = 0.05F;  // [m/s]
  const float ks = scene.erosion.roughness;
  const double dp = scene.spacing;
  Index lone = 0;
  ParticleSet p = test::fill_lattice(scene, [&](const Vec3& x) {
    const bool on_top = x.z() > bed_height && x.z() < bed_height + dp && x.x() > 0.1 && x.x() < 0.1 + dp;
    return on_top ? ParticleType::sediment : half_bed(x);
  });
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.type[i] != ParticleType::water) continue;
    const auto z = static_cast<float>(p.position[i].z() - bed_height);
    p.velocity[i].x() = friction / 0.41F * std::log(z / (0.11F * 1e-6F / friction + 0.033F * ks));
  }
  auto l = test::load<TypeParam>(scene, p);
  apply_equation_of_state(l.on, l.p, scene);
  const test::Seen seen = update_states(l, scene, 1e-4);
  while (!is_sediment(seen.record[lone]) || seen.position[lone].x[2] < bed_height) ++lone;
  const float exact = 1000 * friction * friction;
  EXPECT_NEAR(seen.bed[top_of(seen)].shear_stress, exact, 0.05 * exact);
  EXPECT_NEAR(seen.bed[lone].shear_stress, exact, 0.1 * exact);
}

TYPED_TEST(BedStates, SeeNoSurfaceTowardsAWall) {
  // The same bed between two side walls, as thick as the kernel's support: it goes on behind them.
  const Scene<2> scene = eroding_scene();
  const double wall = 0.04;
  ParticleSet p = test::fill_lattice(
      scene, [&](const Vec3& x) { return x.x() < wall || x.x() > 0.2 - wall ? ParticleType::wall : half_bed(x); });
  auto l = test::load<TypeParam>(scene, p);
  apply_equation_of_state(l.on, l.p, scene);
  extrapolate_to_walls(l.on, l.p, scene);
  const test::Seen seen = update_states(l, scene, 1e-4);
  int checked = 0;
  for (Index i = 0; i < seen.count; ++i) {
    if (seen.position[i].x[0] > wall + scene.spacing || layer_of(seen, i) < 0 || layer_of(seen, i) > 2) continue;
    ++checked;
    // The wall continues a mean over the kernel: it errs by some degrees, and some hundredths of a full bed.
    if (layer_of(seen, i) == 0) {
      EXPECT_GT(seen.bed[i].normal[2], std::cos(0.1));
    }
    EXPECT_EQ(seen.bed[i].fill < scene.erosion.surface_fill, layer_of(seen, i) == 0) << seen.bed[i].fill;
  }
  EXPECT_EQ(checked, 3);
}

TYPED_TEST(BedStates, StartToMoveAtTheCriticalStress) {
  // theta_cr of these grains is near 0.05: 0.93 Pa. The stress grows with the square of the speed, whose critical value
  // is looked for from both sides.
  const Scene<2> scene = eroding_scene();
  const auto moved = [&](float speed) {
    auto l = load_bed<TypeParam>(scene, speed);
    const test::Seen seen = update_states(l, l.scene, 1e-4);
    const Index top = top_of(seen);
    const BedSurface& s = seen.bed[top];
    EXPECT_EQ(seen.record[top].kind == kind::bed_load, s.shear_stress > s.critical_stress);
    return s.shear_stress > s.critical_stress;
  };
  EXPECT_FALSE(moved(0.1F));
  EXPECT_FALSE(moved(0.25F));
  EXPECT_TRUE(moved(0.6F));
}

TYPED_TEST(BedStates, BecomeDepositAgainAfterTheReturnTime) {
  auto l = load_bed<TypeParam>(eroding_scene(), 0);
  const Index top = top_of(test::look(l));
  set_kind(l, top, kind::bed_load);
  const double dt = 1e-3;
  int steps = 1;
  while (update_states(l, l.scene, dt).record[top].kind == kind::bed_load && steps < 100) ++steps;
  EXPECT_EQ(test::look(l).record[top].kind, kind::deposit);
  EXPECT_NEAR(steps, 19, 1.5);

  // As printed there is no way back.
  auto printed = load_bed<TypeParam>(eroding_scene(), 0);
  printed.scene.erosion.as_printed = true;
  set_kind(printed, top, kind::bed_load);
  for (int k = 0; k < 100; ++k) update_states(printed, printed.scene, dt);
  EXPECT_EQ(test::look(printed).record[top].kind, kind::bed_load);
}

TYPED_TEST(BedStates, LiftADiluteGrainAndLetItSettle) {
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
  auto l = test::load<TypeParam>(scene, p);
  apply_equation_of_state(l.on, l.p, scene);
  Index i = 0;
  while (test::look(l).id[i] != static_cast<std::int64_t>(grain)) ++i;
  // The grain's state after a step at this velocity along the bed and away from it [m/s].
  const auto kind_at = [&](const Scene<2>& with, float along, float up) {
    test::change(l, [&](test::Seen& seen) {
      seen.record[i].velocity[0] = along;
      seen.record[i].velocity[2] = up;
    });
    return update_states(l, with, 1e-4).record[i].kind;
  };

  set_kind(l, i, kind::bed_load);
  EXPECT_EQ(kind_at(scene, 0.9F, 0), kind::bed_load) << "it moves along the bed, not away from it";
  ASSERT_LE(test::look(l).bed[i].concentration, 0.312);
  EXPECT_EQ(kind_at(scene, 0.9F, 0.2F), kind::suspended);
  EXPECT_EQ(kind_at(scene, 0.9F, 0.2F), kind::suspended) << "nothing has changed";
  EXPECT_EQ(kind_at(scene, 0.05F, 0.05F), kind::suspended) << "slow, but rising";
  EXPECT_EQ(kind_at(scene, 0.05F, -0.05F), kind::bed_load);

  // As printed, rising slowly is settling: one state in this step, another in the next.
  Scene<2> printed = scene;
  printed.erosion.as_printed = true;
  EXPECT_EQ(kind_at(printed, 0.05F, 0.05F), kind::suspended);
  EXPECT_EQ(kind_at(printed, 0.05F, 0.05F), kind::bed_load);
}

// As printed, bed load that is buried goes on to yield at the last stress that could move it; ours is a deposit.
TYPED_TEST(BedStates, KeepTheLastCriticalStressOfPrintedBedLoadThatIsBuried) {
  Scene<2> printed = eroding_scene();
  printed.erosion.as_printed = true;
  auto l = load_bed<TypeParam>(printed, 0.6F);
  const Index top = top_of(test::look(l));
  const float at_surface = update_states(l, printed, 1e-4).bed[top].critical_stress;
  EXPECT_EQ(test::look(l).record[top].kind, kind::bed_load);
  EXPECT_GT(at_surface, 0);
  l.scene.erosion.surface_fill = 0.1F;  // no particle is surface any more
  const test::Seen buried = update_states(l, l.scene, 1e-4);
  EXPECT_EQ(buried.record[top].kind, kind::bed_load);
  EXPECT_EQ(buried.bed[top].critical_stress, at_surface);
}

// The print takes its shear stress from (20) and the grain Reynolds number from (17) to (19), the logarithmic law.
TYPED_TEST(BedStates, TakeThePrintedGrainReynoldsNumberFromTheLogarithmicLaw) {
  Scene<2> printed = eroding_scene();
  printed.erosion.as_printed = true;
  printed.erosion.bed_shear = BedShear::paper;
  auto l = load_bed<TypeParam>(printed, 0.05F);
  const Index top = top_of(test::look(l));
  const BedSurface s = update_states(l, printed, 1e-4).bed[top];
  const ErosionScene<2>& law = printed.erosion;
  const float z = std::max(s.water_height, 0.5F * static_cast<float>(printed.spacing));
  const float u = friction_velocity(0.05F, z, 1e-6F, law.roughness).friction_velocity;
  const float due = critical_shields_number(u * law.diameter / 1e-6F) * law.grain_weight;
  EXPECT_NEAR(s.critical_stress / due, 1, 0.02);  // the slope factor of a nearly flat bed
}

TYPED_TEST(BedStates, TakeTheNearestWaterWhenAskedTo) {
  Scene<2> scene = eroding_scene();
  scene.erosion.bed_shear = BedShear::nearest;
  ParticleSet p = test::fill_lattice(scene, half_bed);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.type[i] == ParticleType::water) p.velocity[i].x() = p.position[i].z() < bed_height + 0.01 ? 0.3F : 0.9F;
  }
  auto l = test::load<TypeParam>(scene, p);
  apply_equation_of_state(l.on, l.p, scene);
  const test::Seen seen = update_states(l, scene, 1e-4);
  for (Index i = 0; i < seen.count; ++i) {
    if (!in_the_middle(seen, i) || layer_of(seen, i) != 0) continue;
    EXPECT_EQ(seen.bed[i].water_velocity[0], 0.3F);
    EXPECT_NEAR(seen.bed[i].water_height, scene.spacing, 1e-6);
  }
}

}  // namespace
}  // namespace thalweg
