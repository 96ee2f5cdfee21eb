#include <gtest/gtest.h>

#include "solver/simulation/input.hpp"
#include "tests/solver/lattice_scene.hpp"

namespace thalweg {
namespace {

/// A layer of dry grains on a rough plane inclined by atan(0.5), x along it, endless in x; depth 0.1 m.
struct Chute {
  double spacing = 0.005;
  double depth = 0.1;                        // H [m]
  double diameter = 0.02;                    // d [m]
  double cosine = std::cos(std::atan(0.5));  // of the inclination
  double density = 1500;                     // of the layer [kg/m^3]
  double grain_density = 2500;               // [kg/m^3]
  double mu_s = 0.38;
  double mu_2 = 0.64;
  double I0 = 0.279;
  double floor = 0.015;  // height of the plane in the domain [m]; three layers of wall below

  Scene<2> scene() const {
    test::LatticeSetup<2> setup;
    setup.spacing = spacing;
    setup.length = 0.15;
    Scene<2> s = test::make_scene_of(setup);
    s.gravity = {static_cast<float>(9.81 * 0.5 * cosine), static_cast<float>(-9.81 * cosine)};
    s.domain_to[0] = 0.05;
    const bool periodic[2] = {true, false};
    s.lattice = Lattice<2>(s.domain_from, s.domain_to, periodic, s.list_reach);
    s.has_sediment = true;
    s.sediment_density = static_cast<float>(density);
    s.viscous_tolerance = 1e-3;
    SedimentScene& law = s.sediment;
    law.rheology = Rheology::mu_of_i;
    law.yield_coefficient = static_cast<float>(mu_s);
    law.dynamic_coefficient = static_cast<float>(mu_2);
    law.regularisation = 1000;
    law.inertia = {static_cast<float>(I0), static_cast<float>(diameter), static_cast<float>(grain_density)};
    law.submerged_weight = static_cast<float>(density * 9.81 * cosine);
    return s;
  }

  /// Walls and layer at rest, nothing above.
  ParticleSet layer() const {
    const ParticleSet lattice = test::fill_lattice(
        scene(), [&](const Vec3& x) { return x.z() < floor ? ParticleType::wall : ParticleType::sediment; });
    ParticleSet kept;
    for (std::size_t i = 0; i < lattice.size(); ++i) {
      if (lattice.position[i].z() > floor + depth) continue;
      kept.id.push_back(lattice.id[i]);
      kept.type.push_back(lattice.type[i]);
      kept.position.push_back(lattice.position[i]);
      kept.density.push_back(lattice.density[i]);
      kept.mass.push_back(lattice.mass[i]);
      kept.velocity.push_back(lattice.velocity[i]);
      kept.pressure.push_back(0);
    }
    return kept;
  }
};

TEST(GranularFlow, DownAChuteMovesUntilItsFrictionIsTheSlope) {
  // From rest to Bagnold's steady flow, in which the inertial number is the same at every depth and mu(I) is the
  // tangent of the inclination. Left out: two supports above the floor and one below the surface, where sums lack
  // neighbours. The error is that of the particles' shear stress and falls with the spacing: 0.510 here, 0.504 with
  // half of it.
  const Chute chute;
  const ParticleSet start = chute.layer();
  const auto simulation = make_simulation({chute.scene(), &start, 1}, "openmp", "auto");
  for (double time = 0; time < 3;) {
    const StepReport report = simulation->advance(1);
    ASSERT_FALSE(report.diverged);
    time += report.dt;
  }
  const ParticleSet end = simulation->snapshot();
  const auto& strain = end.scalars.at("StrainRate");
  const auto& pressure = end.scalars.at("EffectivePressure");
  int inside = 0;
  double mean = 0;
  for (std::size_t i = 0; i < end.size(); ++i) {
    const double z = end.position[i].z() - chute.floor;
    if (end.type[i] != ParticleType::sediment || z < 0.03 || z > 0.085) continue;
    const double I = inertial_number(double(strain[i]), chute.diameter, chute.grain_density, double(pressure[i]));
    const double friction = friction_of_inertial_number(I, chute.mu_s, chute.mu_2, chute.I0);
    EXPECT_NEAR(friction, 0.5, 0.025) << z;
    mean += friction;
    ++inside;
  }
  ASSERT_GT(inside, 50);
  EXPECT_NEAR(mean / inside, 0.5, 0.015);
}

}  // namespace
}  // namespace thalweg
