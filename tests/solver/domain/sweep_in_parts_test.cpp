#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "common/one_rank.hpp"
#include "solver/simulation/deal.hpp"
#include "tests/solver/scenes.hpp"
#include "tests/solver/thread_ranks.hpp"

// While copies of other ranks' particles are on their way, a sweep visits the clusters that need none of them.
namespace thalweg::test {
namespace {

/// Pair sweep: the sum of the neighbours' velocities.
struct VelocitySum {
  using neighbours = Neighbours<field::place, field::flow>;
  using reads = Reads<>;
  using writes = Writes<>;
  static constexpr unsigned kernel = no_kernel;
  template <class L>
  struct Sum {
    L velocity;
  };
  float* found;

  template <class LaneT, class L>
  HOST_DEVICE void pair(const LaneT&, const LaneT& b, const PairGeometry<2, L>&, std::size_t, Sum<L>& sum) const {
    sum.velocity += b.velocity[0];
  }
  HOST_DEVICE double end(Index i, const Sum<float>& sum) const {
    found[i] = sum.velocity;
    return double{sum.velocity};
  }
};

struct Add {
  HOST_DEVICE double operator()(double a, double b) const { return a + b; }
};
struct Store {
  double* to;
  HOST_DEVICE void operator()(double sum) const { *to = sum; }
};

/// Particle pass: gives the particles behind a place their speed.
struct Arrival {
  using reads = Reads<field::any>;
  using writes = Writes<field::any>;
  Record* records;
  const Position* positions;
  HOST_DEVICE void operator()(Index i) const { records[i].velocity[0] = positions[i].x[0] > 0.14 ? 1.0F : 0.0F; }
};

/// Particles behind a place get their speed when they arrive.
template <class On>
class Late final : public AccessListener {
 public:
  Late(Loaded<2, On>& scene, typename On::template Buffer<float>& found) : scene_(scene), found_(found) {}

  void before(const Access&, const int*) override { ++whole; }
  void after(const Access&, const int*) override {}
  bool begin(const Access&, const int*) override { return true; }
  void arrive() override {
    ++arrivals;
    seen = copy_of(scene_.on, found_);
    AccessListener* const listener = std::exchange(scene_.on.listener, nullptr);
    const int* const flag = scene_.on.skip_unless(nullptr);
    scene_.on.for_each(scene_.p.count, Arrival{scene_.p.record.data(), scene_.p.position.data()});
    scene_.on.skip_unless(flag);
    scene_.on.listener = listener;
  }

  int whole = 0;
  int arrivals = 0;
  HostBuffer<float> seen;  // at the arrival

 private:
  Loaded<2, On>& scene_;
  typename On::template Buffer<float>& found_;
};

class Alone final : public SharedScene {
 public:
  using SharedScene::SharedScene;
  void merge(const DriftBlocks&, DriftBox*) override {}
};

template <class On>
class SweepInParts : public testing::Test {
 protected:
  SweepInParts() {
    const auto setup = make_scene_of<2>({});
    scene_ = load<On>(setup, fill_lattice(setup, all_water));
    scene_.on.listener = &late_;
    scene_.on.fill(found_, scene_.p.count, -1.0F);
    const auto positions = copy_of(scene_.on, scene_.p.position);
    const auto begins = copy_of(scene_.on, scene_.p.list_begin);
    const auto entries = copy_of(scene_.on, scene_.p.list_entries);
    HostBuffer<std::uint8_t> marks(scene_.p.clusters, 0);
    for (Index c = 0; c < scene_.p.clusters; ++c) {
      float expected = 0;
      for (Index e = begins[c]; e < begins[c + 1]; ++e) {
        if (entries[e] < scene_.p.count && positions[entries[e]].x[0] > 0.14) ++expected;
      }
      if (expected > 0) marks[c] = copies_in_reach;
      for (Index i = scene_.p.list().first(c); i < scene_.p.list().last(c); ++i) expected_.push_back(expected);
    }
    EXPECT_GT(std::count(marks.begin(), marks.end(), 0), 10);
    EXPECT_LT(std::count(marks.begin(), marks.end(), 0), scene_.p.clusters - 10);
    scene_.on.upload(std::move(marks), marks_);
  }

  ClusterList list() {
    ClusterList list = scene_.p.list();
    list.marks = marks_.data();
    return list;
  }
  void sweep_clusters(const ClusterList& list) {
    scene_.on.template sweep<2>(list, scene_.p.all_fluid(), scene_.p.record.data(), scene_.scene.metric(),
                                VelocitySum{found_.data()});
  }
  double sum_clusters() {
    typename On::template Buffer<double> sum;
    scene_.on.fill(sum, 1, -1.0);
    scene_.on.template sweep_then<2>(list(), scene_.p.all_fluid(), scene_.p.record.data(), scene_.scene.metric(),
                                     VelocitySum{found_.data()}, 0.0, Add{}, Store{sum.data()});
    return scene_.on.read(sum.data());
  }
  /// True if, when the late particles arrived, those that need none of them had their sums, and others had not.
  void expect_parts(bool whole_blocks) {
    ASSERT_EQ(late_.arrivals, 1);
    int early = 0;
    for (std::size_t i = 0; i < expected_.size(); ++i) {
      const bool is_computed = late_.seen[i] != -1;
      early += is_computed ? 1 : 0;
      EXPECT_EQ(is_computed, !whole_blocks && expected_[i] == 0) << "particle " << i;
    }
    EXPECT_EQ(early > 0, !whole_blocks);
    const auto found = copy_of(scene_.on, found_);
    for (std::size_t i = 0; i < expected_.size(); ++i) ASSERT_EQ(found[i], expected_[i]) << "particle " << i;
  }

  Loaded<2, On> scene_{On{}, {}, make_scene_of<2>({})};
  typename On::template Buffer<float> found_;
  typename On::template Buffer<std::uint8_t> marks_;
  Late<On> late_{scene_, found_};
  std::vector<float> expected_;  // sums after the arrival, by particle
};
TYPED_TEST_SUITE(SweepInParts, Backends, BackendNames);

TYPED_TEST(SweepInParts, ComputesWhatNeedsNoCopiesBeforeTheyArrive) {
  this->sweep_clusters(this->list());
  this->expect_parts(false);
  EXPECT_EQ(this->late_.whole, 0);
}

// On a host clusters are summed in blocks, of which this scene has one.
TYPED_TEST(SweepInParts, AddsUpEachParticleOnce) {
  OneRank one;
  Alone alone(one);
  this->scene_.on.shared = &alone;
  double expected = 0;
  for (const float term : this->expected_) expected += double{term};
  EXPECT_EQ(this->sum_clusters(), expected);
  this->expect_parts(TypeParam::is_host);
}

TYPED_TEST(SweepInParts, WaitsForCopiesEvenIfItIsSkipped) {
  typename TypeParam::template Buffer<int> flag;
  this->scene_.on.fill(flag, 1, 0);
  this->scene_.on.skip_unless(flag.data());
  this->sweep_clusters(this->list());
  this->scene_.on.skip_unless(nullptr);
  EXPECT_EQ(this->late_.arrivals, 1);
  for (const float sum : copy_of(this->scene_.on, this->found_)) ASSERT_EQ(sum, -1);
}

TYPED_TEST(SweepInParts, IsWholeWhereThereAreNoCopies) {
  this->sweep_clusters(this->scene_.p.list());
  EXPECT_EQ(this->late_.whole, 1);
  EXPECT_EQ(this->late_.arrivals, 0);
  for (const float sum : copy_of(this->scene_.on, this->found_)) ASSERT_EQ(sum, 0);
}

template <class On>
class ClustersOfRanks : public testing::Test {};
TYPED_TEST_SUITE(ClustersOfRanks, Backends, BackendNames);

// The fluid of 2 ranks, walls of a floor among it.
TYPED_TEST(ClustersOfRanks, AreMarkedWhereTheirListsHoldCopies) {
  LatticeSetup<2> setup;
  setup.length = 0.6;
  const auto scene = make_scene_of(setup);
  const ParticleSet all =
      fill_lattice(scene, [](const Vec3& x) { return x[2] < 0.05 ? ParticleType::wall : ParticleType::water; });
  const Deal<2> deal(scene, all, 2);
  ThreadRanks(2).run([&](Ranks& ranks) {
    TypeParam on;
    Share<2, TypeParam> share(ranks);
    on.shared = &share;
    const DealtShare dealt = deal.share(ranks.rank());
    share.first_block = dealt.first_block;
    Particles<TypeParam> p;
    load_particles(on, p, scene, dealt.particles);
    rebuild_lists(on, p, scene);
    const auto begins = copy_of(on, p.list_begin);
    const auto entries = copy_of(on, p.list_entries);
    const auto marks = copy_of(on, p.cluster_marks);
    ASSERT_EQ(p.list().marks, p.cluster_marks.data());
    ASSERT_EQ(marks.size(), p.clusters);
    Index marked = 0;
    for (Index c = 0; c < p.clusters; ++c) {
      const bool has_copies = std::any_of(entries.begin() + begins[c], entries.begin() + begins[c + 1],
                                          [&](Index j) { return j >= p.count && j < p.with_copies(); });
      EXPECT_EQ((marks[c] & copies_in_reach) != 0, has_copies) << "cluster " << c << " of rank " << ranks.rank();
      marked += has_copies ? 1 : 0;
    }
    EXPECT_GT(marked, 0U);
    EXPECT_LT(marked, p.clusters / 2);
  });
}

}  // namespace
}  // namespace thalweg::test
