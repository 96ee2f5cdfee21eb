#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <type_traits>
#include <vector>

#include "tests/solver/scenes.hpp"

namespace thalweg {
namespace {

constexpr int dim = 3;
using Momentum = MomentumSweep<dim>;
using Water = ContinuitySweep<dim>;
using Strain = ContinuityAndStrainSweep<dim, false>;

/// Water over sediment, everything about it uneven.
ParticleSet uneven_bed(const Scene<dim>& scene) {
  ParticleSet p = test::fill_lattice(
      scene, [](const Vec3& x) { return x.z() < 0.04 ? ParticleType::sediment : ParticleType::water; }, 0.2);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> any(-1, 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.velocity[i] = Eigen::Vector3f(any(random), any(random), any(random));
    p.pressure[i] = 1000 + 300 * any(random);
    p.density[i] *= 1 + 0.01F * any(random);
  }
  return p;
}

/// The sums a sweep hands to its end, as the backend made them.
template <class Body, class Real>
struct Kept {
  using neighbours = typename Body::neighbours;
  using reads = typename Body::reads;
  using writes = Writes<>;
  static constexpr unsigned kernel = Body::kernel;
  template <class L>
  using Sum = typename Body::template Sum<L>;
  Body body;
  Sum<Real>* sums;

  template <class LaneT, class L>
  void pair(const LaneT& a, const LaneT& b, const PairGeometry<dim, L>& g, std::size_t entry, Sum<L>& sum) const {
    body.pair(a, b, g, entry, sum);
  }
  template <class S>
  void end(Index i, const S& sum) const {
    if constexpr (std::is_same_v<S, Sum<Real>>) sums[i] = sum;
  }
};

template <class Real>
struct Sums {
  std::vector<typename Momentum::template Sum<Real>> momentum;
  std::vector<typename Water::template Sum<Real>> water;
  std::vector<typename Strain::template Sum<Real>> strain;
};

template <int W, class Real>
struct Setting {
  OpenMp<W, Real> on;
  Particles<OpenMp<W, Real>> p;
  Scene<dim> scene;

  Setting() {
    test::LatticeSetup<dim> setup;
    setup.length = 0.08;
    setup.gravity = {0.1F, 0, -9.81F};
    scene = test::make_scene_of(setup);
    scene.has_sediment = true;
    load_particles(on, p, scene, uneven_bed(scene));
    rebuild_lists(on, p, scene);
    for (Index i = 0; i < p.count; ++i) p.record.data()[i].dissipation = 0.25F * static_cast<float>(1 + i % 4);
  }

  Sums<Real> sums() {
    Sums<Real> s;
    s.momentum.resize(p.count);
    s.water.resize(p.count);
    s.strain.resize(p.count);
    const auto sweep = [&](const auto& body) {
      on.template sweep<dim>(p.list(), p.all_fluid(), p.record.data(), scene.metric(), body);
    };
    sweep(Kept<Momentum, Real>{{p.record.data(), p.rates.data(), scene}, s.momentum.data()});
    sweep(Kept<Water, Real>{{p.record.data(), p.rates.data(), scene}, s.water.data()});
    sweep(Kept<Strain, Real>{{{p.record.data(), p.rates.data(), scene}, p.sediment.data(), nullptr}, s.strain.data()});
    return s;
  }
};

/// One component of each sum with what its terms add up to without their signs.
struct Total {
  double sum = 0;
  double magnitude = 0;
  void add(double term) {
    sum += term;
    magnitude += std::abs(term);
  }
};
struct Reference {
  Total force, compression, diffusion, gradient, moment;
};

/// The sums of docs/theory.md over all other particles, written down without packs, lists or clusters.
Reference plain_sums(const Record* records, Index count, const Scene<dim>& scene, Index i) {
  Reference total;
  const Record& a = records[i];
  for (Index j = 0; j < count; ++j) {
    const Record& b = records[j];
    double r[dim], u[dim];
    double r2 = 0, u_dot_r = 0, g_dot_r = 0;
    for (int k = 0; k < dim; ++k) {
      r[k] = double(Lattice<dim>::difference(a.place[k], b.place[k])) * double(scene.lattice.quantum[k]);
      u[k] = double(a.velocity[k]) - double(b.velocity[k]);
      r2 += r[k] * r[k];
      u_dot_r += u[k] * r[k];
      g_dot_r += r[k] * double(scene.gravity[k]);
    }
    const float per_c2 = 1 / (scene.sound_speed * scene.sound_speed);
    const double t = std::max(1 - std::sqrt(r2) * double(scene.kernel.half_inverse_h), 0.0);
    const double F = double(scene.kernel.gradient_factor) * t * t * t;
    const double V = b.volume;
    const bool same = same_phase(a, b);
    const double rho0 = is_sediment(a) ? scene.sediment_density : scene.water_density;
    const double approach = std::min(u_dot_r, 0.0) / (r2 + double(scene.singularity));
    const double acting = (double(a.dissipation) + double(b.dissipation)) / 2;
    const double pi = same ? -rho0 * acting * double(scene.artificial_viscosity) * approach : 0;
    const double eta = same && is_water(a) ? double(scene.water_viscosity) : 0;
    total.force.add(-V * F * (double(a.pressure) + double(b.pressure) + pi) * r[2] + V * F * 2 * eta * u[2]);
    total.compression.add(V * F * u_dot_r);
    if (same) total.diffusion.add(-V * (double(b.excess) - double(a.excess) + g_dot_r * double(per_c2)) * F);
    if (is_sediment(a) && is_water(b)) continue;  // water does not shear a bed
    total.gradient.add(-V * F * r[1] * u[0]);
    total.moment.add(-V * F * r[1] * r[2]);
  }
  return total;
}

/// The largest difference from the plain sums, over what their terms add up to.
template <int W, class Real>
double largest_difference(Setting<W, Real>& s) {
  const Sums<Real> sums = s.sums();
  double largest = 0;
  const auto compare = [&](double sum, const Total& expected) {
    largest = std::max(largest, std::abs(sum - expected.sum) / expected.magnitude);
  };
  for (Index i = 0; i < s.p.count; i += 7) {
    const Reference r = plain_sums(s.p.record.data(), s.p.count, s.scene, i);
    compare(sums.momentum[i].force[2], r.force);
    compare(sums.water[i].compression, r.compression);
    compare(sums.strain[i].diffusion, r.diffusion);
    compare(sums.strain[i].velocity.gradient[0][1], r.gradient);
    compare(sums.strain[i].velocity.moment[4], r.moment);
  }
  return largest;
}

template <class T>
class PrecisionOfWidth : public testing::Test {};
using Widths =
    testing::Types<std::integral_constant<int, 4>, std::integral_constant<int, 8>, std::integral_constant<int, 16>>;
TYPED_TEST_SUITE(PrecisionOfWidth, Widths);

TYPED_TEST(PrecisionOfWidth, DoubleSumsAreThoseOfAPlainLoop) {
  Setting<TypeParam::value, double> s;
  EXPECT_LT(largest_difference(s), 1e-12);  // some hundred terms of 1.1e-16 each
}

TYPED_TEST(PrecisionOfWidth, SingleSumsDifferByTheirRounding) {
  Setting<TypeParam::value, float> s;
  const double difference = largest_difference(s);
  EXPECT_LT(difference, 1e-6);  // some hundred terms of 6e-8 each, with either sign
  EXPECT_GT(difference, 1e-9);  // or it would not be single
}

}  // namespace
}  // namespace thalweg
