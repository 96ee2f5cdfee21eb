#include "solver/simulation/deal_out.hpp"

#include <exception>
#include <functional>
#include <type_traits>
#include <utility>

#include "case/models/surface_bed.hpp"
#include "common/error.hpp"
#include "solver/models/surface_bed/make_surface_bed.hpp"
#include "solver/simulation/deal.hpp"
#include "solver/simulation/gpu_memory.hpp"
#include "solver/simulation/make_scene.hpp"
#include "solver/simulation/particle_messages.hpp"

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

RankStart deal_out(const Case& of, const ParticleSet& particles, Ranks& ranks, bool may_use_gpus) {
  const bool needs_all = models::SurfaceBedOfCase::is_on(of);
  RankStart mine;
  SharesOf shares;
  WholeScene whole{};
  on_the_first(ranks, [&] {
    const ParticleFileInfo& info = particles.info;
    whole.time = info.time;
    whole.step = info.step;
    whole.has_lattice_node = info.lattice_node.has_value();
    if (info.lattice_node) Vec3::Map(whole.lattice_node) = *info.lattice_node;
    whole.may_use_gpus = may_use_gpus;
    if (needs_all) return;
    mine.scene = make_scene(of, particles);
    if (may_use_gpus) whole.gpu_memory = estimate_gpu_memory(mine.scene, particles, ranks.size());
    shares = shares_of(mine.scene, particles, ranks.size());
  });
  whole = gather_from(ranks, whole)[first_rank];
  ParticleFileInfo info = particles.info;
  info.time = whole.time;
  info.step = whole.step;
  if (whole.has_lattice_node) info.lattice_node = Vec3(whole.lattice_node);
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
