#include "solver/models/pore_pressure/pore_pressure.hpp"

#include <gtest/gtest.h>

#include "tests/solver/scenes.hpp"

namespace thalweg {
namespace {

template <class On>
class PorePressure : public testing::Test {};
TYPED_TEST_SUITE(PorePressure, test::Backends, test::BackendNames);

constexpr double height = 0.1;
constexpr double consolidation = 1e-3;  // c_v [m^2/s]

/// Terzaghi's series for a layer drained at the top and sealed below, p_e = 1 at the start: y depth over height,
/// T = c_v t/H^2.
double terzaghi(double y, double T) {
  double sum = 0;
  for (int m = 0; m < 40; ++m) {
    const double M = 3.14159265358979323846 * (m + 0.5);
    sum += 2 / M * std::sin(M * y) * std::exp(-M * M * T);
  }
  return sum;
}

/// The neighbour of the bed above it.
enum class Above { water, nothing };

/// A bed of `rows` layers between x-periodic sides on a floor of walls.
template <class On>
struct Layer {
  test::Loaded<2, On> l;
  PoreDiffusion<On> diffusion;
};

template <class On>
Layer<On> make_layer(int rows, Above above, double jitter) {
  test::LatticeSetup<2> setup;
  const double dp = height / rows;
  setup.spacing = dp;
  Scene<2> scene = test::make_scene_of(setup);
  scene.domain_from = {0, -3 * dp};
  scene.domain_to = {12 * dp, height + 4 * dp};
  const bool periodic[2] = {true, false};
  scene.lattice = Lattice<2>(scene.domain_from, scene.domain_to, periodic, scene.list_reach);
  scene.has_sediment = true;
  scene.pores.on = true;
  scene.pores.consolidation = static_cast<float>(consolidation);
  ParticleSet p = test::fill_lattice(
      scene,
      [](const Vec3& x) {
        if (x.z() < 0) return ParticleType::wall;
        return x.z() < height ? ParticleType::sediment : ParticleType::water;
      },
      jitter);
  ParticleSet kept;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (above == Above::nothing && p.type[i] == ParticleType::water) continue;
    kept.id.push_back(p.id[i]);
    kept.type.push_back(p.type[i]);
    kept.position.push_back(p.position[i]);
    kept.density.push_back(p.density[i]);
    kept.mass.push_back(p.mass[i]);
  }
  Layer<On> layer{test::load<On>(scene, kept), {}};
  test::change(layer.l, [](test::Seen& seen) {
    for (Index i = 0; i < seen.fluid_count; ++i) {
      if (is_sediment(seen.record[i])) seen.excess_pore_pressure[i] = 1;
    }
  });
  return layer;
}

template <class On>
void advance_by(test::Loaded<2, On>& l, const Scene<2>& scene, PoreDiffusion<On>& diffusion, double dt, int steps = 1) {
  test::TestStep step(l, dt);
  for (int n = 0; n < steps; ++n) advance_pore_pressure(l.on, l.p, scene, diffusion, step.state(), dt);
}

/// Root of the mean squared difference to the series at T = 0.2, reached in steps of `per_step` explicit limits.
template <class On>
double error_of(Layer<On> layer, double per_step) {
  test::Loaded<2, On>& l = layer.l;
  const double end = 0.2 * height * height / consolidation;
  const int steps = static_cast<int>(std::ceil(end / (per_step * explicit_diffusion_step(l.scene))));
  advance_by(l, l.scene, layer.diffusion, end / steps, steps);
  const test::Seen seen = test::look(l);
  double error2 = 0;
  int count = 0;
  for (Index i = 0; i < seen.fluid_count; ++i) {
    if (!is_sediment(seen.record[i])) continue;
    const double y = 1 - seen.position[i].x[2] / height;
    error2 += std::pow(double(seen.excess_pore_pressure[i]) - terzaghi(y, 0.2), 2);
    ++count;
  }
  return std::sqrt(error2 / count);
}

TYPED_TEST(PorePressure, FollowsTerzaghiWithFirstOrder) {
  // The surface is known to a share of h only: 3.2, 1.7, 0.9 % of the initial pressure with 10, 20, 40 rows.
  const double coarse = error_of(make_layer<TypeParam>(10, Above::water, 0), 1);
  const double fine = error_of(make_layer<TypeParam>(40, Above::water, 0), 1);
  EXPECT_LT(fine, 0.01);
  EXPECT_GT(std::log2(coarse / fine) / 2, 0.85);
}

TYPED_TEST(PorePressure, DrainsIntoAirAsIntoWater) {
  EXPECT_NEAR(error_of(make_layer<TypeParam>(20, Above::nothing, 0), 1),
              error_of(make_layer<TypeParam>(20, Above::water, 0), 1), 1e-6);
}

TYPED_TEST(PorePressure, StaysNearTerzaghiInDisorder) {
  EXPECT_LT(error_of(make_layer<TypeParam>(20, Above::water, 0.2), 1), 0.02);
}

TYPED_TEST(PorePressure, TakesStepsFarBeyondTheExplicitLimit) {
  // First order in time: a hundred explicit limits are 0.023 of H^2/c_v.
  EXPECT_LT(error_of(make_layer<TypeParam>(20, Above::water, 0), 100), 0.02);
}

// A dense bed that is sheared evenly sucks water in from above: c_v p_e" = M gdot tan psi, p_e = 0 on top, no flow below,
// p_e = -(M gdot tan psi/c_v) (H x - x^2/2) at the depth x. A loose one has the same with the other sign.
TYPED_TEST(PorePressure, OfADenseBedThatIsShearedIsSuction) {
  for (const float more : {0.02F, -0.02F}) {
    auto layer = make_layer<TypeParam>(20, Above::water, 0);
    test::Loaded<2, TypeParam>& l = layer.l;
    PoreScene& law = l.scene.pores;
    law.critical_solids = 0.58F;
    law.dilatancy = 4.09F;
    law.modulus = 1e5F;
    constexpr float rate = 1e-4F;  // [1/s] so slow that the packing stays
    l.on.fill(l.p.solids, l.p.count, 0.58F + more);
    test::change(l, [&](test::Seen& seen) {
      for (Index i = 0; i < seen.count; ++i) {
        seen.sediment[i].strain_rate = rate;
        seen.sediment[i].effective_pressure = 1e9F;  // I_v = 0
        seen.excess_pore_pressure[i] = 0;
      }
    });
    const double end = 3 * height * height / consolidation;
    advance_by(l, l.scene, layer.diffusion, end / 300, 300);
    const test::Seen seen = test::look(l);
    const double scale = 1e5 * double(rate) * 4.09 * double(more) / consolidation;
    for (Index i = 0; i < seen.fluid_count; ++i) {
      if (!is_sediment(seen.record[i])) continue;
      const double x = height - seen.position[i].x[2];
      EXPECT_NEAR(seen.excess_pore_pressure[i], -scale * (height * x - x * x / 2),
                  0.05 * std::abs(scale) * height * height / 2);
    }
    const float opens = 1e-4F * static_cast<float>(end) * 4.09F * more;
    EXPECT_NEAR(test::copy_of(l.on, l.p.solids)[seen.fluid_count / 2], (0.58F + more) * (1 - opens), 2e-5F);
  }
}

TYPED_TEST(PorePressure, IsKeptByASealedBed) {
  // Filled to the top of the support by walls there is no loss, and the sum over the volumes stays.
  test::LatticeSetup<2> setup;
  setup.periodic = true;
  Scene<2> scene = test::make_scene_of(setup);
  scene.has_sediment = true;
  scene.pores.on = true;
  scene.pores.consolidation = 1e-3F;
  auto l = test::load<TypeParam>(scene, test::fill_lattice(
                                            scene, [](const Vec3&) { return ParticleType::sediment; }, 0.2));
  double before = 0;
  test::change(l, [&](test::Seen& seen) {
    for (Index i = 0; i < seen.count; ++i) {
      seen.excess_pore_pressure[i] = static_cast<float>(seen.position[i].x[0] > 0.1 ? 100 : 0);
      before += double(seen.excess_pore_pressure[i]);
    }
  });
  PoreDiffusion<TypeParam> diffusion;
  advance_by(l, scene, diffusion, 0.05, 20);
  double after = 0;
  for (const float pressure : test::look(l).excess_pore_pressure) after += double(pressure);
  EXPECT_NEAR(after / before, 1, 1e-5);
  EXPECT_GT(diffusion.stages, 1);
}

TYPED_TEST(PorePressure, RisesUndrainedWithTheCompressionOfTheBed) {
  auto layer = make_layer<TypeParam>(10, Above::water, 0);
  layer.l.scene.pores.consolidation = 0;
  layer.l.scene.pores.stiffness = 5e5F;
  test::change(layer.l, [](test::Seen& seen) {
    for (Index i = 0; i < seen.fluid_count; ++i) seen.rates[i].excess_rate = 0.1F;
  });
  advance_by(layer.l, layer.l.scene, layer.diffusion, 1e-3);
  const test::Seen seen = test::look(layer.l);
  for (Index i = 0; i < seen.fluid_count; ++i) {
    const bool bed = is_sediment(seen.record[i]);
    EXPECT_NEAR(seen.excess_pore_pressure[i], bed ? 1 + 5e5 * 0.1 * 1e-3 : 0, 1e-4);
  }
}

}  // namespace
}  // namespace thalweg
