#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/models/suspended_load/grain_sums.hpp"
#include "solver/models/suspended_load/model.hpp"
#include "solver/models/wall_stress/contact.hpp"
#include "tests/solver/scenes.hpp"

// Grains that water carries, against exact solutions: Rouse's profile, the development of a profile over an eroding bed
// (Hjelmfelt & Lenau 1970, J. Hydraul. Div. ASCE 96, 1567-1586), the fall of a cloud. Places are disordered by a quarter
// of a spacing, as flow leaves them.
namespace thalweg {
namespace {

using test::LatticeSetup;

template <class On>
class SuspendedLoad : public testing::Test {};
TYPED_TEST_SUITE(SuspendedLoad, test::Backends, test::BackendNames);

constexpr double depth = 0.1;               // [m]
constexpr double settling = 0.02;           // [m/s]
constexpr double friction_velocity = 0.05;  // [m/s]
constexpr double rouse = settling / (0.41 * friction_velocity);
constexpr double jitter = 0.25;  // [spacings]

template <int Dim>
Scene<Dim> scene_of(double spacing, double length, bool periodic = false) {
  LatticeSetup<Dim> setup;
  setup.spacing = spacing;
  setup.length = length;
  setup.periodic = periodic;
  setup.gravity.vertical() = -9.81F;
  Scene<Dim> scene = test::make_scene_of(setup);
  scene.has_sediment = scene.has_states = true;
  scene.sediment_density = 1990;
  scene.erosion.down.vertical() = -1;
  scene.erosion.surface_fill = 0.85F;
  scene.erosion.fill_hysteresis = 0.07F;
  scene.erosion.diameter = scene.erosion.roughness = 2e-4F;
  scene.erosion.grain_density = 2650;
  scene.erosion.grain_weight = 1650 * 9.81F * 2e-4F;
  scene.erosion.gravity = 9.81F;
  scene.erosion.dimensionless_diameter = 5.06F;
  scene.erosion.settling_velocity = static_cast<float>(settling);
  scene.water_has_grains = true;
  SuspendedLoadConstants& law = scene.suspended_load;
  law.on = true;
  law.pick_up = PickUp::van_rijn;
  law.settling_velocity = static_cast<float>(settling);
  law.excess_density = 1.65F;
  law.packing = 0.6F;
  law.reference_level = 1e-3F;
  law.area = static_cast<float>(std::pow(spacing, Dim - 1));
  law.contact = weight_of_half_a_layer(scene);
  return scene;
}

/// Diffusivity of an open channel's eddies, kappa u* z (1 - z/h) [m^2/s], z over the bed.
double parabola(double z) { return z > 0 && z < depth ? 0.41 * friction_velocity * z * (1 - z / depth) : 0; }

/// Rouse's profile over its value at a.
double rouse_profile(double z, double a) { return std::pow((depth - z) / z * a / (depth - a), rouse); }

template <int Dim, class On>
void give_eddies(test::Loaded<Dim, On>& l, double bed) {
  test::change(l, [&](test::Seen& seen) {
    for (Index i = 0; i < seen.count; ++i) {
      seen.suspended[i].diffusivity = static_cast<float>(parabola(seen.position[i].x[2] - bed));
    }
  });
}

template <int Dim, class On>
void give_concentration(test::Loaded<Dim, On>& l, const std::vector<double>& of_particle) {
  test::change(l, [&](test::Seen& seen) {
    for (Index i = 0; i < seen.count; ++i) {
      seen.grains[i] = is_water(seen.record[i]) ? of_particle[i] * double(seen.mass[i]) / 1000 : 0;
    }
  });
}

template <int Dim, class On>
double all_grains(test::Loaded<Dim, On>& l) {
  Totals totals;
  add_grain_sums(l.on, l.p, l.scene, totals);
  return totals.grain_mass;
}

/// Means of the concentration over layers of a spacing, from `bed` up.
std::vector<double> layers(const test::Seen& seen, double spacing, double bed) {
  std::vector<double> sum(static_cast<std::size_t>(std::lround(depth / spacing)), 0.0);
  std::vector<double> count(sum.size(), 0.0);
  for (Index i = 0; i < seen.count; ++i) {
    if (!is_water(seen.record[i])) continue;
    const auto layer = static_cast<std::size_t>((seen.position[i].x[2] - bed) / spacing);
    if (layer >= sum.size()) continue;
    sum[layer] += seen.grains[i] / (double(seen.mass[i]) / 1000);
    ++count[layer];
  }
  for (std::size_t n = 0; n < sum.size(); ++n) sum[n] /= count[n];
  return sum;
}

/// Mean of Rouse's profile over a layer, over its value at a.
double rouse_of_layer(double from, double to, double a) {
  double sum = 0;
  constexpr int parts = 200;
  for (int n = 0; n < parts; ++n) sum += rouse_profile(from + (n + 0.5) / parts * (to - from), a);
  return sum / parts;
}

ParticleType all_water(const Vec3&) { return ParticleType::water; }

TYPED_TEST(SuspendedLoad, ComesToRousesProfileInAClosedColumn) {
  for (const double spacing : {0.01, 0.005}) {
    const Scene<2> scene = scene_of<2>(spacing, depth);
    auto l = test::load<TypeParam>(scene, test::fill_lattice(scene, all_water, jitter));
    apply_equation_of_state(l.on, l.p, scene);
    give_concentration(l, std::vector<double>(l.p.count, 1e-4));
    give_eddies(l, 0);
    const double before = all_grains(l);
    const double dt = spacing == 0.01 ? 0.01 : 0.004;
    test::TestStep step(l, dt);
    for (double t = 0; t < 12; t += dt) {
      find_concentrations(l.on, l.p, scene);
      settle(l.on, l.p, scene, step.state());
    }
    EXPECT_NEAR(all_grains(l) / before, 1, 1e-7);
    // The layer at the bed excepted: the profile has no bound there.
    const std::vector<double> found = layers(test::look(l), spacing, 0);
    const std::size_t middle = found.size() / 2;
    const auto due_of = [&](std::size_t layer) {
      const double from = static_cast<double>(layer) * spacing;
      return rouse_of_layer(from, from + spacing, depth / 2);
    };
    for (std::size_t n = 1; n < found.size(); ++n) {
      const double due = due_of(n) / due_of(middle);
      EXPECT_NEAR(found[n] / found[middle] / due, 1, 0.15) << "spacing " << spacing << ", layer " << n;
    }
  }
}

/// A profile over heights.
struct Profile {
  std::vector<double> edge;           // of cells [m]
  std::vector<double> concentration;  // [-]

  [[nodiscard]] double mean(double from, double to) const {
    double sum = 0;
    for (std::size_t k = 0; k < concentration.size(); ++k) {
      sum += concentration[k] * std::max(0.0, std::min(to, edge[k + 1]) - std::max(from, edge[k]));
    }
    return sum / (to - from);
  }
};

/// The profile of clear water over a bed after t, by finite volumes: C(a) = C_r at the level a. The cells are even in
/// ln z, as Rouse's profile wants them.
Profile developed(double C_r, double a, double t) {
  constexpr std::size_t n = 80;
  std::vector<double> edge(n + 1);
  for (std::size_t k = 0; k <= n; ++k) edge[k] = a * std::pow(depth / a, static_cast<double>(k) / n);
  std::vector<double> C(n, 0.0);
  std::vector<double> up(n + 1, 0.0);
  const auto middle = [&](std::size_t k) { return 0.5 * (edge[k] + edge[k + 1]); };
  const double smallest = edge[1] - edge[0];
  const double dt = 0.2 * smallest * smallest / parabola(edge[1]);
  const auto flux = [&](double below, double above, double distance, double z) {
    return parabola(z) * (below - above) / distance - settling * 0.5 * (below + above);
  };
  for (double at = 0; at < t; at += dt) {
    up[0] = flux(C_r, C[0], middle(0) - a, a);
    for (std::size_t k = 1; k < n; ++k) up[k] = flux(C[k - 1], C[k], middle(k) - middle(k - 1), edge[k]);
    for (std::size_t k = 0; k < n; ++k) C[k] += dt / (edge[k + 1] - edge[k]) * (up[k] - up[k + 1]);
  }
  return {edge, C};
}

constexpr double bed_top = 0.05;  // [m]

ParticleType water_over_bed(const Vec3& x) {
  return x.z() < bed_top ? ParticleType::sediment : x.z() < bed_top + depth ? ParticleType::water : ParticleType::wall;
}

/// A bed of which every surface particle has the shear stress of u*, and water over it.
template <class On>
test::Loaded<2, On> load_eroding_bed(const Scene<2>& scene) {
  auto l = test::load<On>(scene, test::fill_lattice(scene, water_over_bed, 0.1));
  apply_equation_of_state(l.on, l.p, scene);
  return l;
}

template <class On>
void shear_the_bed(test::Loaded<2, On>& l, test::TestStep<2, On>& step) {
  update_bed_states(l.on, l.p, l.scene, step.state());
  test::change(l, [&](test::Seen& seen) {
    for (Index i = 0; i < seen.count; ++i) {
      if (!is_sediment(seen.record[i])) continue;
      seen.record[i].kind = kind::bed_load;
      seen.bed[i].shear_stress = static_cast<float>(1000 * friction_velocity * friction_velocity);
      seen.bed[i].critical_stress = 2.3F;
    }
  });
}

/// C_r of that stress: van Rijn's pick-up over the settling velocity.
double reference_concentration(const Scene<2>& scene) {
  const ErosionScene<2>& e = scene.erosion;
  const double theta = 1000 * friction_velocity * friction_velocity / double(e.grain_weight);
  return van_rijn_pick_up(theta, 2.3 / double(e.grain_weight), double(e.dimensionless_diameter), 2e-4, 2650.0, 1000.0,
                          9.81) /
         settling;
}

struct Fineness {
  double spacing;    // [m]
  double tolerance;  // [-]
};

// Time in a column is the way of water that flows by, over its speed: the load of clear water that comes over a bed. Layers
// with less than a hundredth of the bed's concentration are left out: grains reach them across a kernel's support at once.
TYPED_TEST(SuspendedLoad, DevelopsOverABedAsHjelmfeltAndLenauSay) {
  for (const Fineness& of : {Fineness{0.01, 0.14}, Fineness{0.005, 0.05}}) {
    const Scene<2> scene = scene_of<2>(of.spacing, 0.2, true);
    auto l = load_eroding_bed<TypeParam>(scene);
    const double dt = of.spacing == 0.01 ? 0.01 : 0.004;
    test::TestStep step(l, dt);
    shear_the_bed(l, step);
    give_eddies(l, bed_top);
    const double before = all_grains(l);
    const double C_r = reference_concentration(scene);
    double t = 0;
    for (const double until : {2.0, 8.0}) {
      for (; t < until - 1e-9; t += dt) {
        find_concentrations(l.on, l.p, scene);
        settle(l.on, l.p, scene, step.state());
        exchange_with_bed(l.on, l.p, scene, step.state());
      }
      const Profile exact = developed(C_r, 1e-3, until);
      const std::vector<double> found = layers(test::look(l), of.spacing, bed_top);
      for (std::size_t n = 1; n < found.size(); ++n) {
        const double from = static_cast<double>(n) * of.spacing;
        const double due = exact.mean(from, from + of.spacing);
        if (due < 0.01 * C_r) continue;
        EXPECT_NEAR(found[n] / due, 1, of.tolerance) << "spacing " << of.spacing << ", " << until << " s, layer " << n;
      }
    }
    EXPECT_NEAR(all_grains(l) / before, 1, 1e-7);
  }
}

// A dilute cloud in still water without eddies falls at the settling velocity.
TYPED_TEST(SuspendedLoad, FallsAtItsSettlingVelocity) {
  for (const double spacing : {0.01, 0.005, 0.0025}) {
    const Scene<2> scene = scene_of<2>(spacing, 0.16);
    auto l = test::load<TypeParam>(scene, test::fill_lattice(scene, all_water, jitter));
    apply_equation_of_state(l.on, l.p, scene);
    test::change(l, [&](test::Seen& seen) {
      for (Index i = 0; i < seen.count; ++i) {
        const auto& x = seen.position[i].x;
        const bool cloud = std::abs(x[0] - 0.08) < 0.02 && std::abs(x[2] - 0.11) < 0.02;
        seen.grains[i] = cloud ? 1e-4 * double(seen.mass[i]) / 1000 : 0;
      }
    });
    const auto height = [&] {
      const test::Seen seen = test::look(l);
      double sum = 0;
      double weighted = 0;
      for (Index i = 0; i < seen.count; ++i) sum += seen.grains[i], weighted += seen.grains[i] * seen.position[i].x[2];
      return weighted / sum;
    };
    const double from = height();
    const double dt = 0.2 * spacing / settling;
    test::TestStep step(l, dt);
    double t = 0;
    for (; t < 1; t += dt) {
      find_concentrations(l.on, l.p, scene);
      settle(l.on, l.p, scene, step.state());
    }
    EXPECT_NEAR((from - height()) / t, settling, 0.05 * settling) << spacing;
  }
}

// In space too, pair by pair what one gains the other loses.
TYPED_TEST(SuspendedLoad, KeepsTheGrainsInSpace) {
  const Scene<3> scene = scene_of<3>(0.01, 0.1);
  auto l = test::load<TypeParam>(scene, test::fill_lattice(scene, all_water, jitter));
  apply_equation_of_state(l.on, l.p, scene);
  std::vector<double> C(l.p.count);
  for (std::size_t i = 0; i < C.size(); ++i) C[i] = 0.3 * static_cast<double>(i % 7) / 7;
  give_concentration(l, C);
  give_eddies(l, 0);
  const double before = all_grains(l);
  test::TestStep step(l, 0.005);
  for (int n = 0; n < 50; ++n) {
    find_concentrations(l.on, l.p, scene);
    settle(l.on, l.p, scene, step.state());
  }
  EXPECT_NEAR(all_grains(l) / before, 1, 1e-7);
}

// The mass of the grains goes with the water: a force that gives clear water 1 m/s^2 gives less to a suspension.
TYPED_TEST(SuspendedLoad, IsMovedByTheForcesOnTheWater) {
  const Scene<2> scene = scene_of<2>(0.01, 0.1);
  auto l = test::load<TypeParam>(scene, test::fill_lattice(scene, all_water));
  apply_equation_of_state(l.on, l.p, scene);
  give_concentration(l, std::vector<double>(l.p.count, 0.1));
  find_concentrations(l.on, l.p, scene);
  test::change(l, [&](test::Seen& seen) {
    for (Index i = 0; i < seen.count; ++i) {
      seen.rates[i].acceleration[0] = 1;
      seen.rates[i].acceleration[2] = -9.81F + 3;
    }
  });
  add_mixture_forces(l.on, l.p, scene);
  const test::Seen seen = test::look(l);
  for (Index i = 0; i < seen.count; ++i) {
    EXPECT_NEAR(seen.rates[i].acceleration[0], 1 / 1.165, 1e-4);
    EXPECT_NEAR(seen.rates[i].acceleration[2], -9.81 + 3 / 1.165, 1e-4);
  }
}

/// The particles of the bed.
int bed_particles(const test::Seen& seen) {
  int n = 0;
  for (Index i = 0; i < seen.count; ++i) n += is_sediment(seen.record[i]) ? 1 : 0;
  return n;
}

TYPED_TEST(SuspendedLoad, MakesANewParticleOfTheBedOfHalfASurplus) {
  const Scene<2> scene = scene_of<2>(0.01, 0.2);
  auto l = load_eroding_bed<TypeParam>(scene);
  const double packed = 0.6 * 1e-4;
  test::change(l, [&](test::Seen& seen) {
    for (Index i = 0; i < seen.count; ++i) {
      const auto& x = seen.position[i].x;
      const bool top = is_sediment(seen.record[i]) && x[2] > bed_top - 0.01;
      if (top && std::abs(x[0] - 0.105) < 0.003) seen.grains[i] = 0.6 * packed;
      seen.record[i].excess = is_water(seen.record[i]) ? 1e-3F : 0.0F;
    }
  });
  const int before = bed_particles(test::look(l));
  const double grains = all_grains(l);
  change_bed(l.on, l.p, scene);
  rebuild_lists(l.on, l.p, scene);
  const test::Seen seen = test::look(l);
  EXPECT_EQ(bed_particles(seen), before + 1);
  EXPECT_NEAR(all_grains(l) / grains, 1, 1e-6);
  int found = 0;
  for (Index i = 0; i < seen.count; ++i) {
    if (!is_sediment(seen.record[i]) || seen.grains[i] == 0) continue;
    ++found;
    EXPECT_NEAR(seen.grains[i], -0.4 * packed, 1e-9);
    EXPECT_NEAR(seen.mass[i], 1990e-4, 1e-6);
    EXPECT_GT(seen.position[i].x[2], bed_top);
    EXPECT_NEAR(seen.record[i].excess, 1e-3 / 1.99, 1e-7);  // the pressure is the same
  }
  EXPECT_EQ(found, 1);
}

TYPED_TEST(SuspendedLoad, AParticleOfTheBedWithoutGrainsIsWater) {
  const Scene<2> scene = scene_of<2>(0.01, 0.2);
  auto l = load_eroding_bed<TypeParam>(scene);
  test::change(l, [&](test::Seen& seen) {
    for (Index i = 0; i < seen.count; ++i) {
      if (!is_sediment(seen.record[i])) continue;
      if (seen.position[i].x[2] > bed_top - 0.01) seen.grains[i] = -0.6 * double(seen.mass[i]) / 1990;
    }
  });
  const int before = bed_particles(test::look(l));
  const double grains = all_grains(l);
  change_bed(l.on, l.p, scene);
  rebuild_lists(l.on, l.p, scene);
  EXPECT_EQ(bed_particles(test::look(l)), before - 20);
  EXPECT_NEAR(all_grains(l) / grains, 1, 1e-6);
}

}  // namespace
}  // namespace thalweg
