#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "case/case.hpp"
#include "case/reader/declare.hpp"
#include "case/reader/read_tables.hpp"
#include "common/error.hpp"
#include "solver/backend/openmp.hpp"
#include "solver/simulation/simulation_on.hpp"
#include "tests/solver/guarded_runtime.hpp"
#include "tests/solver/lattice_scene.hpp"

// A model that the solver does not know: its table, its array and its stage work on every backend, and no file of the
// solver is touched for it but the list of models.
namespace thalweg {
namespace {

using test::GuardedRuntime;

/// A case with the table; a table of the project is a member of Case.
struct CaseWithTracer : Case {
  TracerTable tracer;
  static constexpr auto tables() { return std::tuple{&CaseWithTracer::tracer}; }
};

TracerTable read_table(const std::string& text) {
  const Declarations declared = declare_tables<CaseWithTracer>();
  CaseOrigins origins;
  origins.file = "case.toml";
  CaseWithTracer read;
  read_tables(toml::parse(text, std::string("case.toml")), declared, ".", origins, read);
  return read.tracer;
}

TEST(TemplateModel, HasATableOfItsOwn) {
  const TracerTable table = read_table("[tracer]\non = true\nstart = \"2 s\"\n");
  EXPECT_TRUE(table.on);
  EXPECT_EQ(table.start, 2);
  try {
    read_table("[tracer]\nstart = \"2 s\"\n");
    ADD_FAILURE() << "a start without a tracer was accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("case.toml:2"));
  }
}

/// Water in a closed tank, about to slump.
ParticleSet start_of(const Scene<2>& scene) {
  return test::fill_lattice(scene, [](const Vec3& x) {
    if (x.z() < 0.03 || x.x() < 0.03 || x.x() > 0.17) return ParticleType::wall;
    return ParticleType::water;
  });
}

Scene<2> scene_with(const TracerTable& table) {
  test::LatticeSetup<2> setup;
  setup.gravity.vertical() = -9.81F;
  Scene<2> scene = test::make_scene_of(setup);
  TracerModel::make(table, scene);
  return scene;
}

template <class OnDevice>
class TemplateModelOn : public testing::Test {};
using Devices = testing::Types<OpenMp<4>, Gpu<GuardedRuntime>>;
TYPED_TEST_SUITE(TemplateModelOn, Devices);

template <class OnDevice>
double run(Simulation& simulation, int steps) {
  double time = 0;
  for (int n = 0; n < steps; ++n) time += simulation.advance(1e-4).dt;
  return time;
}

TYPED_TEST(TemplateModelOn, CarriesItsArrayThroughStepsSnapshotsAndRestarts) {
  TracerTable table;
  table.on = true;
  table.start = 1;
  const Scene<2> scene = scene_with(table);
  const ParticleSet start = start_of(scene);
  SimulationOn<2, TypeParam> simulation(TypeParam{}, "under test", scene, start);
  const double first = run<TypeParam>(simulation, 5);
  const ParticleSet shown = simulation.snapshot();
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const double expected = shown.type[i] == ParticleType::water ? 1 + first : 1;
    EXPECT_NEAR(shown.scalars.at("Tracer")[i], expected, 1e-6);
  }
  SimulationOn<2, TypeParam> continued(TypeParam{}, "under test", scene, simulation.full_state());
  const double second = run<TypeParam>(continued, 5);
  const ParticleSet after = continued.snapshot();
  for (std::size_t i = 0; i < after.size(); ++i) {
    const double expected = after.type[i] == ParticleType::water ? 1 + first + second : 1;
    EXPECT_NEAR(after.scalars.at("Tracer")[i], expected, 1e-6);
  }
}

TYPED_TEST(TemplateModelOn, CostsNothingWhereItIsOff) {
  const Scene<2> scene = scene_with({});
  SimulationOn<2, TypeParam> simulation(TypeParam{}, "under test", scene, start_of(scene));
  run<TypeParam>(simulation, 2);
  EXPECT_FALSE(simulation.snapshot().scalars.contains("Tracer"));
  for (const auto& entry : simulation.timing().entries()) EXPECT_NE(entry.heading, "carry_tracer");
}

TYPED_TEST(TemplateModelOn, GivesNewbornParticlesTheDeclaredValue) {
  TracerTable table;
  table.on = true;
  table.start = 3;
  const Scene<2> scene = scene_with(table);
  TypeParam on;
  Particles<TypeParam> p;
  load_particles(on, p, scene, start_of(scene));
  Population population(1000000, {});
  Newborn newborn;
  newborn.position = {{0.1, 0, 0.19}};
  newborn.mass = 0.1F;
  population.bear(newborn);
  rebuild_lists(on, p, scene, population);
  const auto ids = on.download(p.id);
  const auto tracers = on.download(p.tracer);
  const auto born = std::find(ids.begin(), ids.end(), 1000000);
  ASSERT_NE(born, ids.end());
  EXPECT_EQ(tracers[static_cast<std::size_t>(born - ids.begin())], 3);
}

}  // namespace
}  // namespace thalweg
