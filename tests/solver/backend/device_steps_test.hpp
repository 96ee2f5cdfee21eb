#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>

#include "device_scenes.hpp"
#include "solver/simulation/simulation_on.hpp"

// Whole steps as every backend has to make them, for a Device named where this is instantiated: those of the OpenMP
// backend.
namespace thalweg::test {

template <class Device>
struct Maker {
  /// Particles that may be in another state than on the host. None, where quotients are rounded as they are there.
  static constexpr int other_states = 0;

  template <int Dim>
  static std::unique_ptr<Simulation> make(const Scene<Dim>& scene, const ParticleSet& from, const DeviceScene& of,
                                          bool profile = false) {
    return std::make_unique<SimulationOn<Dim, Device>>(Device{}, "under test", scene, from, profile, of.motions,
                                                       of.openings(), of.surface_bed(from));
  }
};

/// A simulation of a scene made by hand, on Device.
template <class Device>
std::unique_ptr<Simulation> simulation_on(const DeviceScene& s, const ParticleSet& from) {
  return std::visit([&](const auto& scene) { return Maker<Device>::make(scene, from, s); }, s.scene);
}

template <class Device>
class StepsOnDevice : public testing::Test {};
TYPED_TEST_SUITE_P(StepsOnDevice);

TYPED_TEST_P(StepsOnDevice, StepsAsTheOpenMpBackendDoes) {
  // Sums are taken in another order and roots rounded differently: 6e-8 of accelerations of order 10 m/s^2 in every
  // step; the stiff viscous solve stops at a residual of 1e-5 and makes more of it. A term that is wrong or missing
  // shows as a good part of the way the particles go.
  for (const DeviceScene& s : device_scenes()) {
    SCOPED_TRACE(s.name);
    const auto reference =
        make_simulation({s.scene, &s.particles, 1, false, s.motions, false, s.openings(), s.surface_bed(s.particles)},
                        "openmp", "baseline");
    const auto tested = simulation_on<TypeParam>(s, s.particles);
    for (int n = 0; n < s.steps; ++n) {
      ASSERT_FALSE(reference->advance(1e-4).diverged);
      ASSERT_FALSE(tested->advance(1e-4).diverged);
    }
    const Difference d = difference(s.particles, reference->snapshot(), tested->snapshot());
    EXPECT_GT(d.moved, 1e-6);
    EXPECT_LT(d.apart, 1e-3 * d.moved);
    EXPECT_LE(d.other_states, Maker<TypeParam>::other_states);
    const Totals a = reference->totals();
    const Totals b = tested->totals();
    EXPECT_EQ(a.sediment, b.sediment);
    EXPECT_LE(std::abs(a.resting - b.resting), Maker<TypeParam>::other_states);
    EXPECT_NEAR(a.kinetic_energy, b.kinetic_energy, 1e-3 * a.kinetic_energy);
    EXPECT_NEAR(a.potential_energy, b.potential_energy, 1e-6 * std::abs(a.potential_energy));
    const SimulationFacts facts = tested->facts();
    EXPECT_NEAR(reference->facts().neighbours_mean, facts.neighbours_mean, 1e-2 * facts.neighbours_mean);
  }
}

TYPED_TEST_P(StepsOnDevice, ContinuesFromACheckpointBitForBit) {
  for (const DeviceScene& s : device_scenes()) {
    SCOPED_TRACE(s.name);
    const auto advance = [](Simulation& simulation, int steps) {
      double time = 0;
      for (int n = 0; n < steps; ++n) {
        const StepReport step = simulation.advance(1e-4);
        EXPECT_FALSE(step.diverged);
        time += step.dt;
      }
      return time;
    };
    const auto straight = simulation_on<TypeParam>(s, s.particles);
    const double time = advance(*straight, 4);
    ParticleSet checkpoint = straight->full_state();
    checkpoint.info.step = 4;  // as the program that writes it says
    advance(*straight, 4);
    const auto continued = simulation_on<TypeParam>(s, checkpoint);
    continued->set_time(time);
    advance(*continued, 4);
    const ParticleSet a = straight->full_state();
    const ParticleSet b = continued->full_state();
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.velocity, b.velocity);
  }
}

TYPED_TEST_P(StepsOnDevice, TakesOutWhatLeavesTheDomain) {
  DeviceScene s = device_scenes().front();
  const auto water = std::find(s.particles.type.begin(), s.particles.type.end(), ParticleType::water);
  const auto lost = static_cast<std::size_t>(water - s.particles.type.begin());
  s.particles.position[lost] = Vec3(0.1, 0, 0.1999);
  s.particles.velocity[lost] = Eigen::Vector3f(0, 0, 400);
  const auto simulation = simulation_on<TypeParam>(s, s.particles);
  std::vector<ExcludedParticle> excluded;
  for (int n = 0; n < 20; ++n) {
    const auto now = simulation->advance(1e-4).excluded;
    excluded.insert(excluded.end(), now.begin(), now.end());
  }
  ASSERT_EQ(excluded.size(), 1U);
  EXPECT_EQ(excluded[0].id, s.particles.id[lost]);
  EXPECT_EQ(simulation->snapshot().size(), s.particles.size() - 1);
}

TYPED_TEST_P(StepsOnDevice, ShowsTheParticlesOfRegionsAsASnapshotShowsThem) {
  for (const DeviceScene& s : device_scenes()) {
    SCOPED_TRACE(s.name);
    const auto simulation = simulation_on<TypeParam>(s, s.particles);
    simulation->advance(1e-4);
    const ParticleSet all = simulation->snapshot();
    Vec3 middle = Vec3::Zero();
    for (const Vec3& at : all.position) middle += at / static_cast<double>(all.size());
    const Vec3 infinite = Vec3::Constant(HUGE_VAL);
    Eigen::AlignedBox3d left(-infinite, infinite);
    left.max().x() = middle.x();
    Eigen::AlignedBox3d low(-infinite, infinite);
    low.max().z() = middle.z();
    const ParticleSet some = simulation->snapshot_within({left, low});
    std::size_t n = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all.position[i].x() > middle.x() && all.position[i].z() > middle.z()) continue;
      ASSERT_LT(n, some.size());
      EXPECT_EQ(some.id[n], all.id[i]);
      EXPECT_EQ(some.position[n], all.position[i]);
      EXPECT_EQ(some.pressure[n], all.pressure[i]);
      for (const auto& [name, values] : all.scalars) EXPECT_EQ(some.scalars.at(name)[n], values[i]) << name;
      ++n;
    }
    EXPECT_EQ(n, some.size());
    EXPECT_LT(n, all.size());
    EXPECT_EQ(simulation->snapshot_within({}).size(), 0U);
  }
}

TYPED_TEST_P(StepsOnDevice, LetsABedCreepAtAMicrometreASecond) {
  // 3e-12 m a step is a thousandth of what single precision resolves at 0.1 m.
  LatticeSetup<2> setup;
  setup.periodic = true;
  const Scene<2> scene = make_scene_of(setup);
  ParticleSet start = fill_lattice(scene, all_water);
  for (auto& u : start.velocity) u = Eigen::Vector3f(1e-6F, 0, 0);
  const auto simulation = simulation_on<TypeParam>({"creep", scene, start, 0}, start);
  double time = 0;
  for (int n = 0; n < 300; ++n) time += simulation->advance(3e-6).dt;
  const ParticleSet end = simulation->snapshot();
  std::map<std::int64_t, double> x;
  for (std::size_t i = 0; i < end.size(); ++i) x[end.id[i]] = end.position[i].x();
  for (std::size_t i = 0; i < start.size(); ++i) {
    EXPECT_NEAR(x.at(start.id[i]) - start.position[i].x(), 1e-6 * time, 1e-3 * 1e-6 * time);
  }
}

REGISTER_TYPED_TEST_SUITE_P(StepsOnDevice, StepsAsTheOpenMpBackendDoes, ContinuesFromACheckpointBitForBit,
                            TakesOutWhatLeavesTheDomain, ShowsTheParticlesOfRegionsAsASnapshotShowsThem,
                            LetsABedCreepAtAMicrometreASecond);

}  // namespace thalweg::test
