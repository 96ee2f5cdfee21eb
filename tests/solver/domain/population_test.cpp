#include "solver/domain/population.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "solver/domain/halo.hpp"
#include "solver/domain/stale_fields.hpp"
#include "tests/solver/scenes.hpp"

// Births, deaths and the ledger, on every backend; and the halo that follows from what bodies declare.
namespace thalweg::test {
namespace {

/// A tank of still water with air above it, walls half way up.
ParticleSet tank(const Scene<2>& scene) {
  ParticleSet all = fill_lattice(scene, [](const Vec3& x) {
    return x.z() < 0.03 || x.x() < 0.03 || x.x() > 0.17 ? ParticleType::wall : ParticleType::water;
  });
  ParticleSet kept;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all.type[i] == ParticleType::water && all.position[i].z() > 0.1) continue;
    kept.id.push_back(all.id[i]);
    kept.type.push_back(all.type[i]);
    kept.position.push_back(all.position[i]);
    kept.velocity.push_back(all.velocity[i]);
    kept.density.push_back(all.density[i]);
    kept.pressure.push_back(all.pressure[i]);
    kept.mass.push_back(all.mass[i]);
  }
  return kept;
}

Scene<2> tank_scene() {
  LatticeSetup<2> setup;
  setup.gravity.vertical() = -9.81F;
  return make_scene_of(setup);
}

Newborn water_at(double x, double z, float mass) {
  Newborn b;
  b.position = {{x, 0, z}};
  b.mass = mass;
  return b;
}

/// True for fluid left of x [m].
struct LeftOf {
  using reads = Reads<field::position>;
  using writes = Writes<>;
  const Position* positions;
  double x;
  HOST_DEVICE bool operator()(Index i) const { return positions[i].x[0] < x; }
};

/// Particles, lists and the step, as SimulationOn holds them.
template <class OnDevice>
struct Running {
  OnDevice on;
  Scene<2> scene = tank_scene();
  Particles<OnDevice> p;
  Workspace<OnDevice> work;
  Timing timing;

  explicit Running(const ParticleSet& from) {
    load_particles(on, p, scene, from);
    work.population = Population::of(from);
  }
  StepResult step() { return advance(on, p, scene, work, 1e-4, timing); }
  [[nodiscard]] double mass_in_sums() {
    double mass = 0;
    const auto records = on.download(p.record);
    const auto masses = on.download(p.mass);
    for (Index i = 0; i < p.fluid_count; ++i) mass += records[i].volume != 0 ? double(masses[i]) : 0;
    return mass;
  }
};

template <class OnDevice>
class PopulationOn : public testing::Test {};
TYPED_TEST_SUITE(PopulationOn, Backends);

TYPED_TEST(PopulationOn, BirthsWaitForARebuildAndGetTheNextIds) {
  const ParticleSet start = tank(tank_scene());
  Running<TypeParam> run(start);
  run.step();
  const Index before = run.p.count;
  const std::int64_t rebuilds = run.work.list_rebuilds;
  const double mass = run.mass_in_sums();
  run.work.population.bear(water_at(0.08, 0.17, 0.1F));
  run.work.population.bear(water_at(0.12, 0.17, 0.1F));
  run.step();
  EXPECT_EQ(run.work.list_rebuilds, rebuilds) << "a birth does not wear the lists out";
  EXPECT_EQ(run.p.count, before);
  run.work.squared_drift = INFINITY;  // as when some particle has moved half the skin
  run.step();
  EXPECT_EQ(run.p.count, before + 2);
  EXPECT_NEAR(run.mass_in_sums(), mass + 0.2, 1e-6);
  EXPECT_NEAR(run.work.population.ledger().in, 0.2, 1e-7);
  const std::int64_t first = *std::max_element(start.id.begin(), start.id.end()) + 1;
  const auto ids = run.on.download(run.p.id);
  const auto positions = run.on.download(run.p.position);
  std::map<std::int64_t, double> x;
  for (Index i = 0; i < run.p.count; ++i) x[ids[i]] = positions[i].x[0];
  EXPECT_NEAR(x.at(first), 0.08, 1e-4);
  EXPECT_NEAR(x.at(first + 1), 0.12, 1e-4);
}

TYPED_TEST(PopulationOn, DeathsParkParticlesAndDoNotWearTheListsOut) {
  Running<TypeParam> run(tank(tank_scene()));
  run.step();
  Population::open(run.on, run.p);
  const Index before = run.p.count;
  const std::int64_t rebuilds = run.work.list_rebuilds;
  const double mass = run.mass_in_sums();
  run.work.population.bury(run.on, run.p, LeftOf{run.p.position.data(), 0.08});
  const double left = run.mass_in_sums();
  EXPECT_LT(left, 0.8 * mass);
  EXPECT_NEAR(run.work.population.ledger().out, mass - left, 1e-6);
  run.work.population.bury(run.on, run.p, LeftOf{run.p.position.data(), 0.08});  // nobody dies twice
  EXPECT_NEAR(run.work.population.ledger().out, mass - left, 1e-6);
  for (int n = 0; n < 3; ++n) EXPECT_TRUE(run.step().excluded.empty());
  EXPECT_EQ(run.work.list_rebuilds, rebuilds);
  EXPECT_EQ(run.p.count, before);
  run.work.squared_drift = INFINITY;
  EXPECT_TRUE(run.step().excluded.empty()) << "who dies on purpose is not excluded";
  EXPECT_LT(run.p.count, before);
  EXPECT_NEAR(run.mass_in_sums(), left, 1e-6);
  EXPECT_EQ(run.work.population.ledger().lost, 0);
}

TYPED_TEST(PopulationOn, PrescribedParticlesKeepTheirVelocity) {
  Running<TypeParam> run(tank(tank_scene()));
  Newborn b = water_at(0.1, 0.15, 0.1F);
  b.role = Role::prescribed;
  b.velocity[0] = 0.25F;
  const std::int64_t id = run.work.population.next_id();
  run.work.population.bear(b);
  double time = 0;
  for (int n = 0; n < 10; ++n) time += run.step().step.dt;
  const auto ids = run.on.download(run.p.id);
  const auto at = static_cast<Index>(std::find(ids.begin(), ids.end(), id) - ids.begin());
  ASSERT_LT(at, run.p.count);
  EXPECT_EQ(run.on.download(run.p.record)[at].velocity[0], 0.25F);
  EXPECT_EQ(run.on.download(run.p.record)[at].velocity[2], 0) << "gravity does not move it";
  EXPECT_NEAR(run.on.download(run.p.position)[at].x[0], 0.1 + 0.25 * time, 1e-9);
}

TYPED_TEST(PopulationOn, TheLedgerCountsWhatIsExcluded) {
  ParticleSet start = tank(tank_scene());
  const auto water = std::find(start.type.begin(), start.type.end(), ParticleType::water);
  const auto lost = static_cast<std::size_t>(water - start.type.begin());
  start.position[lost] = Vec3(0.1, 0, 0.1999);
  start.velocity[lost] = Eigen::Vector3f(0, 0, 400);
  SimulationOn<2, TypeParam> simulation(TypeParam{}, "under test", tank_scene(), start);
  for (int n = 0; n < 20; ++n) simulation.advance(1e-4);
  EXPECT_NEAR(simulation.ledger().lost, double(start.mass[lost]), 1e-9);
  EXPECT_EQ(simulation.ledger().in, 0);
  EXPECT_EQ(simulation.ledger().out, 0);
  SimulationOn<2, TypeParam> continued(TypeParam{}, "under test", tank_scene(), simulation.full_state());
  EXPECT_EQ(continued.ledger().lost, simulation.ledger().lost) << "a restart goes on with the ledger";
}

TYPED_TEST(PopulationOn, ACheckpointKeepsIdsAndThoseWhoWait) {
  Population population(77, {1, 2, 3});
  Newborn b = water_at(0.1, 0.15, 0.1F);
  b.velocity[2] = -1;
  b.role = Role::prescribed;
  population.bear(b);
  ParticleSet file;
  population.add_to(file);
  const Population read = Population::of(file);
  EXPECT_EQ(read.next_id(), 77);
  EXPECT_EQ(read.ledger().in, 1);
  EXPECT_EQ(read.ledger().out, 2);
  EXPECT_EQ(read.ledger().lost, 3);
  ASSERT_EQ(read.waiting().size(), 1U);
  EXPECT_EQ(read.waiting()[0].position.x[2], 0.15);
  EXPECT_EQ(read.waiting()[0].velocity[2], -1);
  EXPECT_EQ(read.waiting()[0].role, Role::prescribed);
}

TYPED_TEST(PopulationOn, AHaloCarriesTheDeclaredFields) {
  const ParticleSet start = tank(tank_scene());
  Running<TypeParam> here(start);
  Running<TypeParam> there(start);
  here.step();
  there.step();
  for (int n = 0; n < 3; ++n) here.step();  // the same order, other numbers
  typename TypeParam::template Buffer<Index> chosen;
  HostBuffer<Index> indices;
  for (Index i = 0; i < here.p.fluid_count; i += 3) indices.push_back(i);
  const HostBuffer<Index> known = indices;
  here.on.upload(std::move(indices), chosen);
  const std::vector<const Field*> fields{&field::place, &field::flow, &field::mass};
  typename TypeParam::Message message;
  message.resize(halo_bytes(here.p, here.scene, fields, {}, known.size()));
  pack(here.on, here.p, here.scene, fields, chosen, {}, message.data());
  unpack(there.on, there.p, there.scene, fields, message.data(), chosen, {});
  const auto a = here.on.download(here.p.record);
  const auto b = there.on.download(there.p.record);
  for (const Index i : known) {
    EXPECT_EQ(a[i].place[2], b[i].place[2]);
    EXPECT_EQ(a[i].velocity[2], b[i].velocity[2]);
    EXPECT_EQ(a[i].pressure, b[i].pressure);
  }
  EXPECT_NE(a[1].velocity[2], b[1].velocity[2]) << "not chosen";
  EXPECT_NE(a[0].excess, b[0].excess) << "not among the fields";
}

/// Notes what a domain of several machines would exchange.
struct Exchanges : StaleFields {
  std::vector<std::set<std::string>> done;
  void start(const std::vector<const Field*>& fields) override {
    std::set<std::string>& names = done.emplace_back();
    for (const Field* field : fields) names.insert(field->name);
  }
};

TYPED_TEST(PopulationOn, AStepOfWaterExchangesThreeTimes) {
  Running<TypeParam> run(tank(tank_scene()));
  run.timing.wait_with([] {});  // no step is repeated as a recording
  run.step();
  run.step();
  Exchanges exchanges;
  run.on.listener = &exchanges;
  run.step();
  exchanges.done.clear();
  run.step();
  // Pressures by the equation of state for the walls, wall pressures for the forces, and places and velocities half-way
  // for the density rates, as leapfrog needs them.
  using Names = std::set<std::string>;
  EXPECT_EQ(exchanges.done,
            (std::vector<Names>{{"flow", "matter", "place"}, {"flow", "matter"}, {"flow", "matter", "place"}}));
}

}  // namespace
}  // namespace thalweg::test
