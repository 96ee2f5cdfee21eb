#include <gtest/gtest.h>

#include <cmath>

#include "solver/models/bed/effective_pressure.hpp"
#include "tests/solver/scenes.hpp"

// The effective pressure under bodies in and on a bed: gamma' times the depth below the surface of the bed around them.
namespace thalweg {
namespace {

using test::LatticeSetup;

constexpr double gamma_of_bed = 300 * 9.81;  // [N/m^3]

template <class On>
class WeightUnderBodies : public testing::Test {};
TYPED_TEST_SUITE(WeightUnderBodies, test::Backends, test::BackendNames);

template <int Dim>
Scene<Dim> scene_of_bed(double spacing) {
  LatticeSetup<Dim> setup;
  setup.spacing = spacing;
  setup.gravity.vertical() = -9.81F;
  Scene<Dim> scene = test::make_scene_of(setup);
  scene.has_sediment = true;
  scene.sediment.submerged_weight = static_cast<float>(gamma_of_bed);
  return scene;
}

/// Particles after their sediment was weighed. `empty(x)`: no particle here.
template <class On, int Dim, class TypeOf, class Empty>
test::Seen weighed(const Scene<Dim>& scene, const TypeOf& type_of, const Empty& empty) {
  auto l = test::load<On>(scene, test::fill_lattice(scene, type_of));
  apply_equation_of_state(l.on, l.p, scene);
  test::change(l, [&](test::Seen& seen) {
    for (Index i = 0; i < seen.fluid_count; ++i) {
      const double* x = seen.position[i].x;
      if (empty(Vec3(x[0], x[1], x[2]))) seen.record[i].volume = 0;
    }
  });
  ColumnWeight<On> weight;
  weigh_sediment(l.on, l.p, scene, weight);
  return test::look(l);
}

/// Checks the effective pressure of the sediment at(x) against gamma' times the depth below `surface`, to a tenth of it or
/// to half a spacing's weight where a tenth is less.
template <class At>
int check_depths(const test::Seen& seen, double surface, double spacing, const At& at) {
  int checked = 0;
  for (Index i = 0; i < seen.fluid_count; ++i) {
    const double* x = seen.position[i].x;
    if (!is_sediment(seen.record[i]) || !at(Vec3(x[0], x[1], x[2]))) continue;
    const double depth = surface - x[2];
    EXPECT_NEAR(seen.sediment[i].effective_pressure, gamma_of_bed * depth,
                gamma_of_bed * std::max(0.1 * depth, 0.5 * spacing))
        << x[0] << " " << x[2];
    ++checked;
  }
  return checked;
}

/// Distance from the axis of a pipe along y [m].
double from_axis(const Vec3& x, double z) { return std::hypot(x.x() - 0.1, x.z() - z); }

const auto nowhere = [](const Vec3&) { return false; };

TYPED_TEST(WeightUnderBodies, ABuriedPipeCarriesTheBedAboveIt) {
  for (const double spacing : {0.01, 0.005}) {
    const auto type = [](const Vec3& x) {
      if (from_axis(x, 0.1) < 0.03) return ParticleType::wall;
      return x.z() < 0.16 ? ParticleType::sediment : ParticleType::water;
    };
    const auto seen = weighed<TypeParam>(scene_of_bed<2>(spacing), type, nowhere);
    EXPECT_GT(check_depths(seen, 0.16, spacing, [](const Vec3& x) { return x.z() < 0.07; }), 100);
    // Above and beside it nothing changes.
    EXPECT_GT(check_depths(seen, 0.16, spacing, [](const Vec3& x) { return x.z() > 0.07; }), 100);
    // The bed is flat, over the pipe too.
    for (Index i = 0; i < seen.fluid_count; ++i) {
      if (!is_sediment(seen.record[i])) continue;
      EXPECT_NEAR(seen.sediment[i].bed_slope, 0, 1e-3);
    }
  }
}

TYPED_TEST(WeightUnderBodies, AHollowPipeCarriesTheSame) {
  const double spacing = 0.005;
  const auto type = [](const Vec3& x) {
    const double r = from_axis(x, 0.1);
    if (r < 0.04 && r > 0.025) return ParticleType::wall;
    return x.z() < 0.16 ? ParticleType::sediment : ParticleType::water;
  };
  const auto seen =
      weighed<TypeParam>(scene_of_bed<2>(spacing), type, [](const Vec3& x) { return from_axis(x, 0.1) < 0.025; });
  EXPECT_GT(check_depths(seen, 0.16, spacing, [](const Vec3& x) { return x.z() < 0.06; }), 100);
}

TYPED_TEST(WeightUnderBodies, UnderAPipeHalfInTheBedTheSurfaceIsThatOfTheBedBesideIt) {
  for (const double spacing : {0.01, 0.005}) {
    const auto type = [](const Vec3& x) {
      if (from_axis(x, 0.1) < 0.03) return ParticleType::wall;
      return x.z() < 0.1 ? ParticleType::sediment : ParticleType::water;
    };
    const auto seen = weighed<TypeParam>(scene_of_bed<2>(spacing), type, nowhere);
    EXPECT_GT(check_depths(seen, 0.1, spacing, [](const Vec3& x) { return x.z() < 0.07; }), 100);
  }
}

TYPED_TEST(WeightUnderBodies, WaterUnderAPipeTakesItsWeightAway) {
  // Scoured free: 0.02 m of water between the pipe and the bed under it.
  const double spacing = 0.005;
  const auto type = [](const Vec3& x) {
    if (from_axis(x, 0.13) < 0.03) return ParticleType::wall;
    return x.z() < 0.08 ? ParticleType::sediment : ParticleType::water;
  };
  const auto seen = weighed<TypeParam>(scene_of_bed<2>(spacing), type, nowhere);
  EXPECT_GT(check_depths(seen, 0.08, spacing, [](const Vec3&) { return true; }), 100);
}

TYPED_TEST(WeightUnderBodies, ALidOverTheWholeBedIsNoLoad) {
  const double spacing = 0.01;
  const auto type = [](const Vec3& x) { return x.z() < 0.1 ? ParticleType::sediment : ParticleType::wall; };
  const auto seen = weighed<TypeParam>(scene_of_bed<2>(spacing), type, nowhere);
  EXPECT_GT(check_depths(seen, 0.1, spacing, [](const Vec3&) { return true; }), 100);
}

TYPED_TEST(WeightUnderBodies, SuctionPressesGrainsTogetherWhereNoWaterStandsOverThem) {
  // A bank 0.16 m high beside water 0.12 m deep over a bed of 0.06 m.
  constexpr float suction = 400;
  const double spacing = 0.005;
  Scene<2> scene = scene_of_bed<2>(spacing);
  scene.sediment.suction = suction;
  const auto type = [](const Vec3& x) {
    return x.z() < (x.x() < 0.1 ? 0.16 : 0.06) ? ParticleType::sediment : ParticleType::water;
  };
  const auto air = [](const Vec3& x) { return x.z() > (x.x() < 0.1 ? 0.16 : 0.12); };
  const auto seen = weighed<TypeParam>(scene, type, air);
  int bank = 0;
  for (Index i = 0; i < seen.fluid_count; ++i) {
    const double* x = seen.position[i].x;
    if (!is_sediment(seen.record[i]) || seen.record[i].volume == 0 || x[0] > 0.07) continue;
    EXPECT_NEAR(seen.sediment[i].effective_pressure, gamma_of_bed * (0.16 - x[2]) + suction,
                gamma_of_bed * 0.5 * spacing)
        << x[0] << " " << x[2];
    ++bank;
  }
  EXPECT_GT(bank, 300);
  EXPECT_GT(check_depths(seen, 0.06, spacing, [](const Vec3& x) { return x.x() > 0.13; }), 100);
}

TYPED_TEST(WeightUnderBodies, InSpaceToo) {
  // A ball in the bed and a pile that ends in it.
  const double spacing = 0.01;
  const auto type = [](const Vec3& x) {
    const bool ball = std::hypot(from_axis(x, 0.09), x.y() - 0.06) < 0.03;
    const bool pile = std::hypot(x.x() - 0.1, x.y() - 0.15) < 0.025 && x.z() > 0.08;
    if (ball || pile) return ParticleType::wall;
    return x.z() < 0.14 ? ParticleType::sediment : ParticleType::water;
  };
  const auto seen = weighed<TypeParam>(scene_of_bed<3>(spacing), type, nowhere);
  EXPECT_GT(check_depths(seen, 0.14, spacing, [](const Vec3&) { return true; }), 1000);
}

}  // namespace
}  // namespace thalweg
