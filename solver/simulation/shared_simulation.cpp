// A simulation whose particles lie on several ranks (start.hpp: lead, follow).
#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <exception>
#include <utility>

#include "solver/simulation/packed_share.hpp"
#include "solver/simulation/particle_messages.hpp"
#include "solver/simulation/start.hpp"

namespace thalweg {
namespace {

/// A request of the first rank to the others.
enum class Request : int {
  set_time,
  advance,
  take_excluded,
  totals,
  facts,
  cpu_seconds,
  snapshot,
  snapshot_within,
  full_state,
  pack_snapshot,
  pack_full_state,
  hand_over_packed,
  end
};

constexpr int root = 0;

/// what(), in which all ranks take part. One that cannot go on leaves the others waiting for it: it says why and ends all.
template <class What>
auto together(Ranks& ranks, const What& what) {
  try {
    return what();
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: rank {}: {}; the run ends on all ranks, and its last checkpoint is whole\n",
               ranks.rank(), error.what());
    ranks.abandon();
    std::abort();  // not reached: GCC 12 does not see it in a template
  }
}

/// Brings the particle sets of all ranks to the first, one after the other.
ParticleSet gather_set(Ranks& ranks, ParticleSet mine) {
  JointSet joint(gather_from(ranks, sizes_of(mine)));
  const Bytes own = to_message(mine);
  mine = {};  // before the whole set is made
  if (ranks.rank() == root) joint.add(root, own);
  for (int rank = root + 1; rank < ranks.size(); ++rank) {
    const Bytes theirs = send(ranks, own, rank, root);
    if (ranks.rank() == root) joint.add(static_cast<std::size_t>(rank), theirs);
  }
  return joint.take();
}

/// The numbers of the facts that are sums over the ranks, and those that are means over the fluid.
struct CountedFacts {
  std::int64_t particles;
  std::int64_t fluid;
  double entries;
  double bytes;
  double copies;
  double neighbours;
  double waited;
  double waited_for_copies;
  Traffic sent;
};

SimulationFacts gather_facts(Ranks& ranks, SimulationFacts facts) {
  const auto n = static_cast<double>(facts.particles);
  const CountedFacts mine{facts.particles,
                          facts.fluid_particles,
                          facts.list_entries_per_particle * n,
                          facts.bytes_per_particle * n,
                          facts.copies_per_particle * n,
                          facts.neighbours_mean * static_cast<double>(facts.fluid_particles),
                          facts.waited,
                          facts.waited_for_copies,
                          ranks.sent()};
  CountedFacts all{};
  for (const CountedFacts& f : gather_from(ranks, mine)) {
    all.particles += f.particles;
    all.fluid += f.fluid;
    all.entries += f.entries;
    all.bytes += f.bytes;
    all.copies += f.copies;
    all.neighbours += f.neighbours;
    all.waited += f.waited;
    all.waited_for_copies += f.waited_for_copies;
    if (f.sent.bytes >= all.sent.bytes) all.sent = f.sent;
  }
  facts.particles = all.particles;
  facts.fluid_particles = all.fluid;
  if (all.particles > 0) {
    facts.list_entries_per_particle = all.entries / static_cast<double>(all.particles);
    facts.bytes_per_particle = all.bytes / static_cast<double>(all.particles);
    facts.copies_per_particle = all.copies / static_cast<double>(all.particles);
  }
  if (all.fluid > 0) facts.neighbours_mean = all.neighbours / static_cast<double>(all.fluid);
  facts.ranks = ranks.size();
  facts.waited = all.waited / ranks.size();
  facts.waited_for_copies = all.waited_for_copies / ranks.size();
  facts.sent = all.sent;
  facts.device = fmt::format("{} ranks of {}", ranks.size(), facts.device);
  return facts;
}

/// Processor time of all ranks but the first [s].
double gather_cpu_seconds(Ranks& ranks) {
  double sum = 0;
  const double mine = ranks.rank() == 0 ? 0 : static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  for (const double seconds : gather_from(ranks, mine)) sum += seconds;
  return sum;
}

StepReport gather_report(Ranks& ranks, StepReport report) {
  std::int64_t fluid = report.fluid;
  ranks.sum(&fluid, 1);
  report.fluid = fluid;
  return report;
}

Bytes message_of(const std::vector<Eigen::AlignedBox3d>& regions) {
  Bytes message;
  for (const auto& region : regions) {
    append_to(message, region.min().data(), 3);
    append_to(message, region.max().data(), 3);
  }
  return message;
}
std::vector<Eigen::AlignedBox3d> regions_in(const Bytes& message) {
  MessageReader reader(message);
  std::vector<Eigen::AlignedBox3d> regions(message.size() / (6 * sizeof(double)));
  for (auto& region : regions) {
    reader.read(region.min().data(), 3);
    reader.read(region.max().data(), 3);
  }
  return regions;
}

/// The next range of every rank to the first, one after the other. An error of take(range) there waits until all have handed
/// theirs over.
template <class Take>
void gather_packed(Ranks& ranks, PackedShare& packed, const Take& take) {
  std::exception_ptr failure;
  const auto try_to_take = [&](const PackedRange& range) {
    try {
      take(range);
    } catch (...) {
      failure = std::current_exception();
    }
  };
  together(ranks, [&] {
    const PackedRange mine = packed.next();
    const Bytes own = ranks.rank() == root ? Bytes() : to_message(mine);
    if (ranks.rank() == root) try_to_take(mine);
    for (int rank = root + 1; rank < ranks.size(); ++rank) {
      const Bytes theirs = send(ranks, own, rank, root);
      if (ranks.rank() == root && !failure) try_to_take(packed_range_in(theirs));
    }
  });
  if (failure) std::rethrow_exception(failure);
}

struct Asked {
  Request request = Request::end;
  double number = 0;
};

/// The simulation of the first rank.
class Leader final : public Simulation {
 public:
  Leader(std::unique_ptr<Simulation> share, Ranks& ranks) : share_(std::move(share)), ranks_(ranks) {}
  ~Leader() override { ask(Request::end); }
  Leader(const Leader&) = delete;
  Leader& operator=(const Leader&) = delete;

  void set_time(double time) override {
    ask(Request::set_time, time);
    share_->set_time(time);
  }
  StepReport advance(double longest) override {
    ask(Request::advance, longest);
    return together(ranks_, [&] { return gather_report(ranks_, share_->advance(longest)); });
  }
  std::vector<ExcludedParticle> take_excluded() override {
    ask(Request::take_excluded);
    return together(ranks_, [&] { return share_->take_excluded(); });
  }
  Totals totals() override {
    ask(Request::totals);
    return together(ranks_, [&] { return share_->totals(); });
  }
  MassLedger ledger() const override { return share_->ledger(); }
  std::vector<OpeningFlux> openings() const override { return share_->openings(); }
  std::optional<BedReport> bed() const override { return share_->bed(); }
  double bed_time() const override { return share_->bed_time(); }
  SimulationFacts facts() override {
    ask(Request::facts);
    return together(ranks_, [&] { return gather_facts(ranks_, share_->facts()); });
  }
  double cpu_seconds_elsewhere() override {
    ask(Request::cpu_seconds);
    return together(ranks_, [&] { return gather_cpu_seconds(ranks_); });
  }
  const Timing& timing() const override { return share_->timing(); }
  Timing& timing() override { return share_->timing(); }

  ParticleSet snapshot() override {
    ask(Request::snapshot);
    return together(ranks_, [&] { return gather_set(ranks_, share_->snapshot()); });
  }
  std::function<ParticleSet()> begin_snapshot() override {
    return [set = std::make_shared<ParticleSet>(snapshot())] { return std::move(*set); };
  }
  ParticleSet snapshot_within(const std::vector<Eigen::AlignedBox3d>& regions) override {
    ask(Request::snapshot_within);
    broadcast(ranks_, message_of(regions));
    return together(ranks_, [&] { return gather_set(ranks_, share_->snapshot_within(regions)); });
  }
  ParticleSet full_state() override {
    ask(Request::full_state);
    return together(ranks_, [&] { return gather_set(ranks_, share_->full_state()); });
  }
  OwnRanges& own_ranges() override { return share_->own_ranges(); }
  std::optional<PackedFrame> pack(FileContents of, double spacing,
                                  const std::function<void(const PackedRange&)>& sink) override {
    ask(of == FileContents::snapshot ? Request::pack_snapshot : Request::pack_full_state, spacing);
    PackedShare packed = together(ranks_, [&] { return PackedShare(own_ranges(), ranks_, of, spacing); });
    for (std::uint64_t round = 0; round < packed.rounds(); ++round) {
      ask(Request::hand_over_packed);
      gather_packed(ranks_, packed, sink);
    }
    return packed.frame();
  }

 private:
  void ask(Request request, double number = 0) { gather_from(ranks_, Asked{request, number}); }

  std::unique_ptr<Simulation> share_;
  Ranks& ranks_;
};

/// A rank that does with its share what the first one asks for.
class Follower {
 public:
  Follower(Simulation& share, Ranks& ranks) : share_(share), ranks_(ranks) {}

  /// False if nothing more will come.
  bool answer(const Asked& asked) {
    switch (asked.request) {
      case Request::set_time:
        share_.set_time(asked.number);
        break;
      case Request::advance:
        gather_report(ranks_, share_.advance(asked.number));
        break;
      case Request::take_excluded:
        share_.take_excluded();
        break;
      case Request::totals:
        share_.totals();
        break;
      case Request::facts:
        gather_facts(ranks_, share_.facts());
        break;
      case Request::cpu_seconds:
        gather_cpu_seconds(ranks_);
        break;
      case Request::snapshot:
        gather_set(ranks_, share_.snapshot());
        break;
      case Request::snapshot_within:
        gather_set(ranks_, share_.snapshot_within(regions_in(broadcast(ranks_, {}))));
        break;
      case Request::full_state:
        gather_set(ranks_, share_.full_state());
        break;
      case Request::pack_snapshot:
        packed_.emplace(share_.own_ranges(), ranks_, FileContents::snapshot, asked.number);
        break;
      case Request::pack_full_state:
        packed_.emplace(share_.own_ranges(), ranks_, FileContents::full_state, asked.number);
        break;
      case Request::hand_over_packed:
        gather_packed(ranks_, *packed_, [](const PackedRange&) {});
        break;
      case Request::end:
        return false;
    }
    return true;
  }

 private:
  Simulation& share_;
  Ranks& ranks_;
  std::optional<PackedShare> packed_;  // of the file that is being written, or was last
};

}  // namespace

std::unique_ptr<Simulation> lead(std::unique_ptr<Simulation> share, Ranks& ranks) {
  return std::make_unique<Leader>(std::move(share), ranks);
}

void follow(Simulation& share, Ranks& ranks) {
  Follower follower(share, ranks);
  while (together(ranks, [&] { return follower.answer(gather_from(ranks, Asked{}).front()); })) {
  }
}

}  // namespace thalweg
