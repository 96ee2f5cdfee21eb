#include "solver/models/seepage/porosity.hpp"

#include "mixture_scenes.hpp"

namespace thalweg {
namespace {

using namespace test::mixture;

template <class On>
class Mixture : public testing::Test {};
TYPED_TEST_SUITE(Mixture, test::Backends, test::BackendNames);

TYPED_TEST(Mixture, ExchangesMomentumWithoutLosingAny) {
  Column c;
  c.periodic_height = true;
  c.sound_speed = 20;
  Scene<2> scene = scene_of(c);
  scene.viscous_tolerance = 1e-6;
  ParticleSet start = fill(c, scene, false);
  std::mt19937 random(3);
  std::normal_distribution<float> speed(0, 0.1F);
  for (std::size_t i = 0; i < start.size(); ++i) {
    const float along = start.type[i] == ParticleType::water ? 0.2F : 0.0F;
    start.velocity[i] = {along + speed(random), 0, speed(random)};
  }
  auto l = test::load<TypeParam>(scene, start);
  const Totals before = sum_totals(l.on, l.p, scene);
  Workspace<TypeParam> work;
  run(l, work, 0.02);
  const Totals after = sum_totals(l.on, l.p, scene);
  const double scale = std::sqrt(2 * before.kinetic_energy * (before.water_mass + before.sediment_mass));
  for (int k : {0, 2}) EXPECT_LT(std::abs(after.momentum[k] - before.momentum[k]), 1e-5 * scale);
  EXPECT_LT(after.kinetic_energy, before.kinetic_energy);
  EXPECT_EQ(after.water_mass, before.water_mass);
  EXPECT_EQ(after.sediment_mass, before.sediment_mass);
}

TEST(MixtureOnThreads, IsTheSameForAnyNumber) {
  Column c;
  c.height = 0.5;  // 600 clusters: enough for several threads to be woken
  c.sound_speed = 22;
  c.gravity = {0.5F, static_cast<float>(-g)};
  const Scene<2> scene = scene_of(c);
  const ParticleSet start = fill(c, scene, true);
  std::vector<Vec3> position[2];
  for (int k = 0; k < 2; ++k) {
    auto l = test::load<test::Cpu>(scene, start);
    l.on.threads = 1 + 2 * k;
    Workspace<test::Cpu> work;
    run(l, work, 0.002);
    position[k].resize(start.size());
    for (Index i = 0; i < l.p.count; ++i) {
      const double* x = l.p.position[i].x;
      position[k][static_cast<std::size_t>(l.p.id[i])] = {x[0], x[1], x[2]};
    }
  }
  EXPECT_EQ(position[0], position[1]);
}

TYPED_TEST(Mixture, KnowsItsPorosityAlongWallsToo) {
  const Column c;
  const Scene<2> scene = scene_of(c);
  auto l = test::load<TypeParam>(scene, fill(c, scene, false));
  apply_mixture_state(l.on, l.p, scene);
  const test::Seen seen = test::look(l);
  for (Index i = 0; i < seen.fluid_count; ++i) EXPECT_NEAR(seen.pores[i].porosity, 0.45, 1e-5);
}

TYPED_TEST(Mixture, CostsNothingWhereItIsOff) {
  Scene<2> scene = scene_of({});
  scene.seepage = {};
  auto l = test::load<TypeParam>(scene, test::fill_lattice(scene, [](const Vec3& x) {
                                   return x.z() < 0.03 ? ParticleType::sediment : ParticleType::water;
                                 }));
  Workspace<TypeParam> work;
  run(l, work, 0.005);
  EXPECT_TRUE(l.p.pores.empty());
  EXPECT_TRUE(work.pore_diffusion.loss.empty());
  EXPECT_TRUE(l.p.excess_pore_pressure.empty());
}

}  // namespace
}  // namespace thalweg
