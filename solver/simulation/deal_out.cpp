#include "solver/simulation/deal_out.hpp"

#include <algorithm>
#include <exception>
#include <functional>
#include <type_traits>
#include <utility>

#include "case/models/driven_flow.hpp"
#include "case/models/surface_bed.hpp"
#include "case/models/wall_friction.hpp"
#include "common/error.hpp"
#include "common/particle_slices.hpp"
#include "solver/models/current/water_body.hpp"
#include "solver/models/surface_bed/make_surface_bed.hpp"
#include "solver/simulation/deal.hpp"
#include "solver/simulation/gpu_memory.hpp"
#include "solver/simulation/make_scene.hpp"
#include "solver/simulation/particle_messages.hpp"
#include "solver/simulation/ranged_walls.hpp"
#include "solver/simulation/scene_digest.hpp"
#include "solver/simulation/twin_search.hpp"

namespace thalweg {
namespace {

constexpr int first_rank = 0;

/// Facts of the whole scene, from the first rank.
struct WholeScene {
  double time;  // [s]
  std::int64_t step;
  bool has_lattice_node;
  double lattice_node[3];  // [m]
  bool may_use_gpus;
  GpuMemory gpu_memory;  // of each rank's
};

WholeScene facts_of(const ParticleFileInfo& info) {
  WholeScene whole{};
  whole.time = info.time;
  whole.step = info.step;
  whole.has_lattice_node = info.lattice_node.has_value();
  if (info.lattice_node) Vec3::Map(whole.lattice_node) = *info.lattice_node;
  return whole;
}

/// The facts of the first rank in what this rank knows.
ParticleFileInfo info_with(const WholeScene& whole, ParticleFileInfo info) {
  info.time = whole.time;
  info.step = whole.step;
  if (whole.has_lattice_node) info.lattice_node = Vec3(whole.lattice_node);
  return info;
}

/// Runs what() on the first rank. Its error ends the start of all.
template <class What>
void on_the_first(Ranks& ranks, const What& what) {
  std::exception_ptr error;
  if (ranks.rank() == first_rank) {
    try {
      what();
    } catch (...) {
      error = std::current_exception();
    }
  }
  const int failed = gather_from(ranks, error ? 1 : 0)[first_rank];
  if (error) std::rethrow_exception(error);
  if (failed != 0) throw InputError("the first rank cannot start this run");
}

using SharesOf = std::function<DealtShare(int rank)>;

SharesOf shares_of(const AnyScene& any, const ParticleSet& all, int ranks) {
  return std::visit(
      [&]<int Dim>(const Scene<Dim>& scene) -> SharesOf {
        return [deal = std::make_shared<Deal<Dim>>(scene, all, ranks)](int rank) { return deal->share(rank); };
      },
      any);
}

/// The first rank's scene to all.
template <int Dim>
AnyScene send_scene(Ranks& ranks, const AnyScene& any) {
  static_assert(std::is_trivially_copyable_v<Scene<Dim>>);
  Bytes bytes;
  if (ranks.rank() == first_rank) append_to(bytes, &std::get<Scene<Dim>>(any), 1);
  const Bytes received = broadcast(ranks, bytes);
  Scene<Dim> scene;
  MessageReader(received).read(&scene, 1);
  return scene;
}

/// The share of this rank; one at a time is on its way.
DealtShare send_shares(Ranks& ranks, const SharesOf& shares) {
  DealtShare mine;
  for (int rank = 1; rank < ranks.size(); ++rank) {
    Bytes message;
    if (ranks.rank() == first_rank) {
      const DealtShare theirs = shares(rank);
      append_to(message, &theirs.first_block, 1);
      append_to(message, theirs.particles);
    }
    const Bytes received = send(ranks, message, first_rank, rank);
    if (ranks.rank() != rank) continue;
    MessageReader reader(received);
    mine.first_block = reader.number<std::int64_t>();
    mine.particles = particles_in(reader);
  }
  if (ranks.rank() == first_rank) mine = shares(first_rank);
  return mine;
}

/// The part of a rank in particles from `first` on.
ParticleSet part_of(const std::vector<FileRange>& ranges, const ParticleSet& particles, std::size_t first) {
  ParticleSet part;
  for (const auto& [from, to] : ranges) {
    const std::size_t begin = std::max(from, first);
    const std::size_t end = std::min(to, first + particles.size());
    if (begin < end) append(part, slice(particles, begin - first, end - first));
  }
  return part;
}

/// The particles of a source, of which the first rank reads a range at a time.
class ReadInRanges {
 public:
  ReadInRanges(ParticleSource* source, Ranks& ranks)
      : source_(source), ranks_(ranks), size_(gather_from(ranks, source == nullptr ? 0 : source->size())[first_rank]) {}

  [[nodiscard]] std::uint64_t size() const { return size_; }

  /// Calls prepare(range) on the first rank and then see(range, number of its first particle) on all ranks, for all ranges; on
  /// others than the first they are empty.
  template <class Prepare, class See>
  void each(const Prepare& prepare, const See& see) const {
    for (std::uint64_t from = 0; from < size_; from += particles_at_once) {
      ParticleSet range;
      on_the_first(ranks_, [&] {
        range = source_->range(from, std::min(size_, from + particles_at_once));
        prepare(range);
      });
      see(range, from);
    }
  }

 private:
  ParticleSource* source_;
  Ranks& ranks_;
  std::uint64_t size_;
};

/// The order in which the particles of a file stand.
struct FileOrder {
  bool is_of_lists = false;  // fluid before walls, as in a checkpoint
  std::uint64_t fluid = 0;   // particles
  void add(const ParticleSet& range) {
    is_of_lists = range.doubles.contains(checkpoint_array::listed_at);
    for (const ParticleType type : range.type) {
      fluid += type == ParticleType::water || type == ParticleType::sediment ? 1 : 0;
    }
  }
};

/// The first rank's knowledge of a scene whose particles it reads range by range.
class RangedScene {
 public:
  explicit RangedScene(const Case& of) : of_(of), digest_(of.motions.size()) {
    if (models::DrivenFlow::is_on(of)) water_.emplace(of);
  }
  void add(const ParticleSet& range) {
    digest_.add(range);
    if (water_) water_->add(range);
    if (models::WallStress::is_on(of_)) walls_.add(range);
  }
  /// The scene, and in `known` the facts that hold for all particles.
  AnyScene make(const ParticleSet& frame, ParticleSet& known) {
    ParticleSet few = digest_.particles();
    few.info = frame.info;
    few.facts = frame.facts;
    AnyScene scene = make_scene(of_, few, water_ ? &*water_ : nullptr);
    walls_.find(scene);
    known.facts = few.facts;
    Population::of(few).add_to(known);
    return scene;
  }
  /// When the ranges are read again.
  void give_elements(ParticleSet& range) { walls_.give(range); }

 private:
  const Case& of_;
  SceneDigest digest_;
  std::optional<WaterBody> water_;
  RangedWalls walls_;
};

/// All particles to all ranks, whose columns are made of them.
void begin_with_all(const Case& of, const ParticleSet& particles, Ranks& ranks, const ParticleFileInfo& info,
                    bool may_use_gpus, RankStart& mine) {
  ParticleSet all = from_message(broadcast(ranks, ranks.rank() == first_rank ? to_message(particles) : Bytes()));
  all.info = info;
  mine.surface_bed = make_surface_bed(of, all);
  mine.scene = make_scene(of, all);
  if (may_use_gpus) mine.gpu_memory = estimate_gpu_memory(mine.scene, all, ranks.size());
  DealtShare share = shares_of(mine.scene, all, ranks.size())(ranks.rank());
  mine.particles = std::move(share.particles);
  mine.first_block = share.first_block;
}

}  // namespace

RankStart deal_out_in_ranges(const Case& of, ParticleSource* source, const std::string& file, Ranks& ranks) {
  const ReadInRanges all(source, ranks);
  RankStart mine;
  RangedScene scene(of);
  FileOrder order;
  TwinSearch twins(ranks, of.model.seepage == SeepageModel::mixture);
  all.each(
      [&](const ParticleSet& range) {
        scene.add(range);
        order.add(range);
      },
      [&](const ParticleSet& range, std::uint64_t) { twins.add(range); });
  const std::string fault = twins.fault(file);
  WholeScene whole{};
  ParticleSet known;
  on_the_first(ranks, [&] {
    if (!fault.empty()) throw InputError(fault);
    whole = facts_of(source->frame().info);
    mine.scene = scene.make(source->frame(), known);
  });
  const ParticleFileInfo info =
      info_with(gather_from(ranks, whole)[first_rank], source == nullptr ? ParticleFileInfo() : source->frame().info);
  order = gather_from(ranks, order)[first_rank];
  mine.scene = of.info.dimension == 3 ? send_scene<3>(ranks, mine.scene) : send_scene<2>(ranks, mine.scene);
  const auto fluid = order.is_of_lists ? std::make_optional(std::size_t{order.fluid}) : std::nullopt;
  std::vector<std::vector<FileRange>> ranges;  // of each rank
  for (int rank = 0; rank < ranks.size(); ++rank) {
    ranges.push_back(ranges_of_rank(all.size(), fluid, rank, ranks.size()));
  }
  mine.particles.facts = from_message(broadcast(ranks, ranks.rank() == first_rank ? to_message(known) : Bytes())).facts;
  mine.particles.info = info;
  const std::vector<FileRange>& own = ranges[static_cast<std::size_t>(ranks.rank())];
  mine.first_block = static_cast<std::int64_t>(own.front().first / sum_block);
  std::size_t own_size = 0;
  for (const auto& [from, to] : own) own_size += to - from;
  const auto give = [&](ParticleSet& range) { scene.give_elements(range); };
  all.each(give, [&](const ParticleSet& range, std::uint64_t from) {
    std::vector<Bytes> messages(ranges.size());
    for (std::size_t rank = 0; rank < ranges.size() && ranks.rank() == first_rank; ++rank) {
      const ParticleSet part = part_of(ranges[rank], range, from);
      if (part.size() > 0) messages[rank] = to_message(part);
    }
    const Bytes message = scatter(ranks, messages);
    if (message.empty()) return;
    const ParticleSet part = from_message(message);
    if (mine.particles.size() == 0) reserve(mine.particles, part, own_size);
    append(mine.particles, part);
  });
  return mine;
}

RankStart deal_out(const Case& of, const ParticleSet& particles, Ranks& ranks, bool may_use_gpus) {
  const bool needs_all = models::SurfaceBedOfCase::is_on(of);
  RankStart mine;
  SharesOf shares;
  WholeScene whole{};
  on_the_first(ranks, [&] {
    whole = facts_of(particles.info);
    whole.may_use_gpus = may_use_gpus;
    if (needs_all) return;
    mine.scene = make_scene(of, particles);
    if (may_use_gpus) whole.gpu_memory = estimate_gpu_memory(mine.scene, particles, ranks.size());
    shares = shares_of(mine.scene, particles, ranks.size());
  });
  whole = gather_from(ranks, whole)[first_rank];
  const ParticleFileInfo info = info_with(whole, particles.info);
  if (needs_all) {
    begin_with_all(of, particles, ranks, info, whole.may_use_gpus, mine);
    return mine;
  }
  if (whole.may_use_gpus) mine.gpu_memory = whole.gpu_memory;
  mine.scene = of.info.dimension == 3 ? send_scene<3>(ranks, mine.scene) : send_scene<2>(ranks, mine.scene);
  DealtShare share = send_shares(ranks, shares);
  mine.particles = std::move(share.particles);
  mine.particles.info = info;
  mine.first_block = share.first_block;
  return mine;
}

}  // namespace thalweg
