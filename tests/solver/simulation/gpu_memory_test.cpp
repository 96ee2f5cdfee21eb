#include "solver/simulation/gpu_memory.hpp"

#include <gmock/gmock.h>

#include "case/models/surface_bed.hpp"
#include "case/reader/case_file.hpp"
#include "common/error.hpp"
#include "gencase/generate.hpp"
#include "solver/backend/list_limit.hpp"
#include "solver/models/surface_bed/make_surface_bed.hpp"
#include "solver/simulation/deal.hpp"
#include "solver/simulation/deal_out.hpp"
#include "solver/simulation/make_scene.hpp"
#include "tests/solver/scenes.hpp"
#include "tests/solver/thread_ranks.hpp"

namespace thalweg {
namespace {

struct Filled {
  AnyScene scene;
  ParticleSet particles;
};

/// One of the project's cases, with its fluid in motion, so that lists soon have to be made anew.
Filled fill(const std::string& name, const std::vector<std::string>& settings) {
  gencase::Generated made = gencase::generate(read_case(THALWEG_SOURCE_DIR "/cases/" + name, settings));
  for (std::size_t i = 0; i < made.particles.size(); ++i) {
    if (made.particles.type[i] == ParticleType::water) made.particles.velocity[i] = Eigen::Vector3f(3, 0, 0);
  }
  return {make_scene(made.resolved, made.particles), std::move(made.particles)};
}

template <int Dim>
void make_lists_twice(const Scene<Dim>& scene, const ParticleSet& particles, Ranks* ranks,
                      std::int64_t first_block = 0) {
  SimulationOn<Dim, test::Guarded> simulation(test::Guarded{}, "guarded", scene, particles, false, {}, nullptr, nullptr,
                                              ranks, first_block);
  simulation.advance(1);
  const auto snapshot = simulation.begin_snapshot();
  for (int n = 0; n < 20 && simulation.facts().list_rebuilds < 2; ++n) simulation.advance(1);
  EXPECT_GE(simulation.facts().list_rebuilds, 2);
}

/// The most memory that a scene took on a stand-in for a GPU until its lists were made for the second time, with a
/// snapshot under way; on average over so many.
double peak_of(const Filled& of, int ranks = 1) {
  std::size_t& peak = test::GuardedRuntime::peak();
  peak = test::GuardedRuntime::in_use();
  const auto before = double(peak);
  std::visit(
      [&]<int Dim>(const Scene<Dim>& scene) {
        if (ranks == 1) return make_lists_twice(scene, of.particles, nullptr);
        const Deal<Dim> deal(scene, of.particles, ranks);
        test::ThreadRanks(ranks).run([&](Ranks& mine) {
          const DealtShare share = deal.share(mine.rank());
          make_lists_twice(scene, share.particles, &mine, share.first_block);
        });
      },
      of.scene);
  return (double(peak) - before) / ranks;
}

class GpuMemoryOf : public testing::TestWithParam<std::pair<std::string, std::vector<std::string>>> {};

TEST_P(GpuMemoryOf, IsKnownBeforeToFifteenPercent) {
  const Filled of = fill(GetParam().first, GetParam().second);
  const double estimate = estimate_gpu_memory(of.scene, of.particles).needed;
  const double peak = peak_of(of);
  const auto particles = double(of.particles.size());
  RecordProperty("particles", std::to_string(of.particles.size()));
  RecordProperty("peak_bytes_per_particle", std::to_string(peak / particles));
  RecordProperty("estimated_bytes_per_particle", std::to_string(estimate / particles));
  EXPECT_NEAR(estimate, peak, 0.15 * peak)
      << particles << " particles, " << peak / particles << " B each; estimated " << estimate / particles;
}

INSTANTIATE_TEST_SUITE_P(
    Cases, GpuMemoryOf,
    testing::Values(std::pair{"louvain3d", std::vector<std::string>{R"(numerics.spacing="10 mm")", "compare.times=[]"}},
                    std::pair{"louvain", std::vector<std::string>{R"(numerics.spacing="5 mm")", "compare.times=[]"}},
                    std::pair{"dam_break", std::vector<std::string>{"compare.times=[]"}}),
    [](const auto& of) { return of.param.first; });

// Each GPU loads its own particles alone. Copies of others' come on top of what is estimated; on two GPUs they are few.
TEST(GpuMemory, OfTwoGpusIsHalfAsMuchOnEach) {
  const Filled of = fill("louvain", {R"(numerics.spacing="5 mm")", "compare.times=[]"});
  const double alone = peak_of(of);
  const double each = peak_of(of, 2);
  RecordProperty("times_half", std::to_string(2 * each / alone));
  EXPECT_LT(each, 0.6 * alone);
  EXPECT_NEAR(estimate_gpu_memory(of.scene, of.particles, 2).needed, each, 0.15 * each);
}

TEST(GpuMemory, IsRefusedWithTheSpacingThatFits) {
  const Filled of = fill("still_water", {R"(numerics.spacing="10 mm")", "compare.times=[]"});
  const GpuMemory memory = estimate_gpu_memory(of.scene, of.particles);
  EXPECT_NO_THROW(require_gpu_memory(of.scene, memory, memory.needed));
  try {
    require_gpu_memory(of.scene, memory, memory.needed / 4);
    FAIL() << "a quarter of the memory is not enough";
  } catch (const InputError& e) {
    const std::string message = e.what();
    EXPECT_NE(message.find("2 cm or more"), std::string::npos) << message;  // in the plane a quarter of the particles
    EXPECT_LE(message.size(), 300U);
  }
  const double of_each = estimate_gpu_memory(of.scene, of.particles, 2).needed;
  EXPECT_LT(of_each, 0.65 * memory.needed) << "lattices of columns, which are whole on every rank";
  EXPECT_GT(of_each, 0.5 * memory.needed);
  EXPECT_GT(memory.coefficients, 0);
  EXPECT_FALSE(coefficients_fit(memory, memory.needed + memory.coefficients)) << "no room to spare";
  EXPECT_TRUE(coefficients_fit(memory, 2 * (memory.needed + memory.coefficients)));
}

// Ranks are sent their shares; with a bed that is a surface each makes its columns, which are more particles.
TEST(GpuMemory, OfRanksIsEstimatedFromAllParticles) {
  for (const char* name : {"dam_break", "pipeline_hours"}) {
    SCOPED_TRACE(name);
    const gencase::Generated made = gencase::generate(read_case(std::string(THALWEG_SOURCE_DIR "/cases/") + name, {}));
    ParticleSet all = made.particles;
    if (models::SurfaceBedOfCase::is_on(made.resolved)) make_surface_bed(made.resolved, all);
    std::vector<double> dealt(2);
    test::ThreadRanks(2).run([&](Ranks& mine) {
      const ParticleSet nothing;
      const RankStart start = deal_out(made.resolved, mine.rank() == 0 ? made.particles : nothing, mine, true);
      dealt[static_cast<std::size_t>(mine.rank())] = start.gpu_memory.value().particles;
    });
    EXPECT_THAT(dealt, testing::Each(double(all.size())));
  }
}

TEST(ListEntries, AreRefusedBeyondWhatTheirNumbersHold) {
  EXPECT_EQ(countable_entries(most_list_entries), Index(most_list_entries));
  EXPECT_THROW(countable_entries(most_list_entries + 1), InputError);
  const test::Guarded on;
  test::Guarded::Buffer<Index> counts;
  test::Guarded::Buffer<Index> begin;
  on.fill(counts, 3, Index{1} << 31);
  EXPECT_THROW(on.exclusive_scan(counts, begin), InputError) << "three times 2^31 is 2^31 in 32 bits";
  on.fill(counts, 3, Index{1} << 30);
  EXPECT_EQ(on.exclusive_scan(counts, begin), Index{3} << 30);
}

TEST(ListEntries, OfCpuCoresAreRefusedToo) {
  // 20 clusters with one neighbour each, padded to four.
  struct Search {
    static Index groups() { return 20; }
    static Index first_cluster(Index group) { return group; }
    void operator()(Index group, ListScratch<4, 2>& lists) const {
      lists.add(Hits<4>{group, 1});
      lists.end_list(0);
    }
  };
  HostBuffer<Index> begin;
  HostBuffer<Index> entries;
  EXPECT_EQ((OpenMpLists<4, 2>{1, 80}.make(20, Search{}, begin, entries, 0)), 80U);
  EXPECT_THROW((OpenMpLists<4, 2>{1, 79}.make(20, Search{}, begin, entries, 0)), InputError);
}

}  // namespace
}  // namespace thalweg
