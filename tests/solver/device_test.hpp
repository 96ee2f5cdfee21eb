#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>

#include "device_scenes.hpp"
#include "solver/simulation/simulation_on.hpp"

// What every backend has to do, for a Device named where this is instantiated: the verbs, and whole steps as the OpenMP
// backend makes them. Bodies of kernels are structs here, because a test's function is private to its class.
namespace thalweg::test {

template <class T, class Device>
typename Device::template Buffer<T> buffer_of(Device& on, std::vector<T> numbers) {
  typename Device::template Buffer<T> buffer;
  on.upload(HostBuffer<T>(numbers.begin(), numbers.end()), buffer);
  return buffer;
}
template <class T, class Device>
std::vector<T> numbers_in(Device& on, const typename Device::template Buffer<T>& buffer) {
  const auto numbers = on.download(buffer);
  return {numbers.begin(), numbers.end()};
}

struct Square {
  std::int64_t* to;
  HOST_DEVICE void operator()(Index i) const { to[i] = std::int64_t{i} * i; }
};
struct Entry {
  const std::int64_t* from;
  HOST_DEVICE std::int64_t operator()(Index i) const { return from[i]; }
};
struct Plus {
  HOST_DEVICE std::int64_t operator()(std::int64_t a, std::int64_t b) const { return a + b; }
};
struct Store {
  std::int64_t* to;
  HOST_DEVICE void operator()(std::int64_t result) const { *to = result; }
};
struct AddTo {
  std::int64_t* to;
  std::int64_t amount;
  HOST_DEVICE void operator()(Index) const { *to += amount; }
};
struct TwiceMore {
  Index than;
  HOST_DEVICE Index operator()(Index i) const { return than + 2 * i; }
};
struct Multiple {
  Index of;
  HOST_DEVICE bool operator()(Index i) const { return i % of == 0; }
};
template <class Device>
struct CountRemainder {
  std::int64_t* counts;
  Index modulus;
  HOST_DEVICE void operator()(Index i) const { Device::atomic_add(counts + i % modulus, 1); }
};

template <class Device>
class OnDevice : public testing::Test {};
TYPED_TEST_SUITE_P(OnDevice);

TYPED_TEST_P(OnDevice, RunsABodyForEveryIndex) {
  TypeParam on;
  typename TypeParam::template Buffer<std::int64_t> squares;
  squares.resize(1000);
  on.for_each(1000, Square{squares.data()});
  const auto numbers = numbers_in<std::int64_t>(on, squares);
  for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(numbers[i], std::int64_t(i * i));
  EXPECT_EQ(on.reduce(1000, std::int64_t{0}, Entry{squares.data()}, Plus{}), 332833500);
  EXPECT_EQ(on.reduce(0, std::int64_t{0}, Entry{squares.data()}, Plus{}), 0);
}

TYPED_TEST_P(OnDevice, KeepsWhatABufferHoldsWhenItGrows) {
  TypeParam on;
  auto buffer = buffer_of<std::int64_t>(on, {1, 2, 3});
  buffer.resize(1000);
  EXPECT_EQ(on.download(buffer, 1, 3)[1], 3);
  buffer.resize(2);
  EXPECT_EQ(numbers_in<std::int64_t>(on, buffer), (std::vector<std::int64_t>{1, 2}));
  on.fill(buffer, 5, std::int64_t{9});
  EXPECT_EQ(numbers_in<std::int64_t>(on, buffer), std::vector<std::int64_t>(5, 9));
}

TYPED_TEST_P(OnDevice, ScansAndSelects) {
  TypeParam on;
  std::vector<Index> counts(777);
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = static_cast<Index>(i % 5);
  typename TypeParam::template Buffer<Index> offsets;
  const auto on_device = buffer_of<Index>(on, counts);
  const Index total = on.exclusive_scan(on_device, offsets);
  std::vector<Index> expected(counts.size() + 1, 0);
  std::partial_sum(counts.begin(), counts.end(), expected.begin() + 1);
  EXPECT_EQ(total, expected.back());
  EXPECT_EQ(numbers_in<Index>(on, offsets), expected);

  typename TypeParam::template Buffer<Index> sevens;
  typename TypeParam::template Buffer<Index> none;
  typename TypeParam::template Buffer<Index> many;
  Selection<TypeParam> selection(on);
  selection.choose({nullptr, 20}, Multiple{7}, sevens);
  selection.choose({nullptr, 0}, Multiple{7}, none);
  selection.choose(50000, TwiceMore{10}, Multiple{3}, many);
  selection.finish();
  EXPECT_EQ(numbers_in<Index>(on, sevens), (std::vector<Index>{0, 7, 14}));
  EXPECT_TRUE(none.empty());
  std::vector<Index> all;
  for (Index i = 0; i < 50000; ++i) {
    if ((10 + 2 * i) % 3 == 0) all.push_back(10 + 2 * i);
  }
  EXPECT_EQ(numbers_in<Index>(on, many), all);
}

TYPED_TEST_P(OnDevice, AddsUpAndGoesOnWithoutTheHost) {
  TypeParam on;
  typename TypeParam::template Buffer<std::int64_t> numbers;
  typename TypeParam::template Buffer<std::int64_t> sum;
  numbers.resize(100000);
  sum.resize(1);
  on.for_each(100000, Square{numbers.data()});
  on.reduce_then(100000, std::int64_t{0}, Entry{numbers.data()}, Plus{}, Store{sum.data()});
  EXPECT_EQ(on.read(sum.data()), std::int64_t{333328333350000});
  on.reduce_then(0, std::int64_t{7}, Entry{numbers.data()}, Plus{}, Store{sum.data()});
  EXPECT_EQ(on.read(sum.data()), 7);
}

TYPED_TEST_P(OnDevice, DoesNothingWhileAFlagIsDown) {
  TypeParam on;
  auto flag = buffer_of<int>(on, {0});
  auto numbers = buffer_of<std::int64_t>(on, {1, 1, 1});
  on.skip_unless(flag.data());
  on.for_each(3, Square{numbers.data()});
  on.reduce_then(3, std::int64_t{0}, Entry{numbers.data()}, Plus{}, Store{numbers.data()});
  EXPECT_EQ(numbers_in<std::int64_t>(on, numbers), (std::vector<std::int64_t>{1, 1, 1}));
  on.write(1, flag.data());
  on.for_each(3, Square{numbers.data()});
  EXPECT_EQ(on.skip_unless(nullptr), flag.data());
  EXPECT_EQ(numbers_in<std::int64_t>(on, numbers), (std::vector<std::int64_t>{0, 1, 4}));
}

TYPED_TEST_P(OnDevice, RepeatsWhatItWasAskedForBefore) {
  TypeParam on;
  auto numbers = buffer_of<std::int64_t>(on, {0});
  auto flag = buffer_of<int>(on, {1});
  const auto add = [&] {
    on.skip_unless(flag.data());
    on.for_each(1, AddTo{numbers.data(), 3});
    on.skip_unless(nullptr);
  };
  for (const std::uint64_t key : {0, 1, 1, 1, 2, 2, 0, 1}) on.repeat(key, add);
  EXPECT_EQ(on.read(numbers.data()), 24);
  on.write(0, flag.data());  // what the launches read is read when they are made
  on.repeat(1, add);
  EXPECT_EQ(on.read(numbers.data()), 24);
}

TYPED_TEST_P(OnDevice, SortsStablyAndReorders) {
  TypeParam on;
  const Index n = 5000;
  std::vector<std::uint64_t> keys(n);
  std::vector<Index> order(n);
  for (Index i = 0; i < n; ++i) keys[i] = (std::uint64_t{i} * 2654435761U % 97) << 40, order[i] = i;
  auto key = buffer_of<std::uint64_t>(on, keys);
  auto sorted = buffer_of<Index>(on, order);
  on.sort_by_key(key, sorted);
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return keys[a] < keys[b]; });
  EXPECT_EQ(numbers_in<Index>(on, sorted), order);

  std::vector<std::int64_t> numbers(n + 1);  // one more than is sorted: it stays where it is
  std::iota(numbers.begin(), numbers.end(), 0);
  auto values = buffer_of<std::int64_t>(on, numbers);
  typename TypeParam::template Buffer<std::int64_t> scratch;
  on.reorder(values, sorted, scratch);
  const auto moved = numbers_in<std::int64_t>(on, values);
  for (Index i = 0; i < n; ++i) ASSERT_EQ(moved[i], order[i]);
  EXPECT_EQ(moved[n], n);
}

TYPED_TEST_P(OnDevice, AddsWithoutLosingAny) {
  TypeParam on;
  typename TypeParam::template Buffer<std::int64_t> counts;
  on.fill(counts, 3, std::int64_t{0});
  on.for_each(30000, CountRemainder<TypeParam>{counts.data(), 3});
  EXPECT_EQ(numbers_in<std::int64_t>(on, counts), std::vector<std::int64_t>(3, 10000));
}

template <class Device>
struct Maker {
  template <int Dim>
  static std::unique_ptr<Simulation> make(const Scene<Dim>& scene, const ParticleSet& from,
                                          const std::vector<WallMotion>& motions, bool profile = false) {
    return std::make_unique<SimulationOn<Dim, Device>>(Device{}, "under test", scene, from, profile, motions);
  }
};

/// A simulation of a scene made by hand, on Device.
template <class Device>
std::unique_ptr<Simulation> simulation_on(const DeviceScene& s, const ParticleSet& from) {
  return std::visit([&](const auto& scene) { return Maker<Device>::make(scene, from, s.motions); }, s.scene);
}

TYPED_TEST_P(OnDevice, StepsAsTheOpenMpBackendDoes) {
  // Sums are taken in another order and roots rounded differently: 6e-8 of accelerations of order 10 m/s^2 in every
  // step; the stiff viscous solve stops at a residual of 1e-5 and makes more of it. A term that is wrong or missing
  // shows as a good part of the way the particles go.
  for (const DeviceScene& s : device_scenes()) {
    SCOPED_TRACE(s.name);
    const auto reference = make_simulation({s.scene, &s.particles, 1, false, s.motions}, "openmp", "baseline");
    const auto tested = simulation_on<TypeParam>(s, s.particles);
    for (int n = 0; n < s.steps; ++n) {
      ASSERT_FALSE(reference->advance(1e-4).diverged);
      ASSERT_FALSE(tested->advance(1e-4).diverged);
    }
    const Difference d = difference(s.particles, reference->snapshot(), tested->snapshot());
    EXPECT_GT(d.moved, 1e-6);
    EXPECT_LT(d.apart, 1e-3 * d.moved);
    EXPECT_EQ(d.other_states, 0);
    const Totals a = reference->totals();
    const Totals b = tested->totals();
    EXPECT_EQ(a.sediment, b.sediment);
    EXPECT_EQ(a.resting, b.resting);
    EXPECT_NEAR(a.kinetic_energy, b.kinetic_energy, 1e-3 * a.kinetic_energy);
    EXPECT_NEAR(a.potential_energy, b.potential_energy, 1e-6 * std::abs(a.potential_energy));
    const SimulationFacts facts = tested->facts();
    EXPECT_NEAR(reference->facts().neighbours_mean, facts.neighbours_mean, 1e-2 * facts.neighbours_mean);
  }
}

TYPED_TEST_P(OnDevice, ContinuesFromACheckpointBitForBit) {
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
    const ParticleSet checkpoint = straight->full_state();
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

TYPED_TEST_P(OnDevice, TakesOutWhatLeavesTheDomain) {
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

TYPED_TEST_P(OnDevice, ShowsTheParticlesOfRegionsAsASnapshotShowsThem) {
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

TYPED_TEST_P(OnDevice, LetsABedCreepAtAMicrometreASecond) {
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

REGISTER_TYPED_TEST_SUITE_P(OnDevice, RunsABodyForEveryIndex, KeepsWhatABufferHoldsWhenItGrows, ScansAndSelects,
                            AddsUpAndGoesOnWithoutTheHost, DoesNothingWhileAFlagIsDown, RepeatsWhatItWasAskedForBefore,
                            SortsStablyAndReorders, AddsWithoutLosingAny, StepsAsTheOpenMpBackendDoes,
                            ContinuesFromACheckpointBitForBit, TakesOutWhatLeavesTheDomain,
                            ShowsTheParticlesOfRegionsAsASnapshotShowsThem, LetsABedCreepAtAMicrometreASecond);

}  // namespace thalweg::test
