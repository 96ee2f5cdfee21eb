#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "solver/backend/ranks.hpp"
#include "solver/domain/device_messages.hpp"
#include "solver/domain/halo.hpp"
#include "solver/domain/stale_fields.hpp"
#include "solver/lists/block_exchange.hpp"
#include "solver/lists/cells_between.hpp"
#include "solver/lists/cut.hpp"
#include "solver/lists/pace.hpp"

namespace thalweg {

/// This rank's share of a scene: a range of the global order of the fluid and one of the walls, and copies of the
/// particles in reach of it that other ranks have. Ranges of the fluid begin at whole blocks of sums, those of the walls at
/// whole groups of clusters, so that clusters, lists and sums are the same whatever the number of ranks.
///
/// Which fields of the copies are exchanged when follows from what bodies declare (StaleFields).
template <int Dim, class Device>
class Share final : public SharedScene, public StaleFields {
 public:
  explicit Share(Ranks& of) : SharedScene(of), waited_before_(of.waited()) {
    const auto n = static_cast<std::size_t>(of.size());
    copies_of_.resize(n);
    outgoing_.resize(n);
    incoming_.resize(n);
  }

  /// Chooses the way of the messages between devices, before the first. Throws InputError on all ranks if the one that is
  /// wished for does not work.
  void choose_messages(Device& on, const MessageWish& wish) {
    if constexpr (!Device::is_host) {
      messages_.choose(on, ranks, wish);
      for (auto& message : outgoing_) message = typename Device::Message(messages_.lie_on_devices());
      for (auto& message : incoming_) message = typename Device::Message(messages_.lie_on_devices());
    }
  }
  [[nodiscard]] const char* way_of_messages() const { return messages_.way(); }

  void set_beside(FieldsBeside where) { beside_ = std::move(where); }

  /// Takes the copies away.
  void drop_copies(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
    on.listener = nullptr;
    p.copies = {};
    set_room(on, p, scene, p.count);
  }

  /// Hands particles over to the ranks in whose ranges they lie now. They are sorted, without copies.
  void redistribute(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
    const auto records = on.download(p.record, 0, p.count);
    const neighbours::HilbertKey<Dim> key(records.data(), scene.lattice);
    SortedKeys keys;
    double expected = 0;
    for (Index i = 0; i < p.fluid_count; ++i) expected += cost_of(records[i]) * pace_.factor();
    pace_.look(ranks, expected);
    for (Index i = 0; i < p.count; ++i) {
      (i < p.fluid_count ? keys.fluid : keys.walls).push_back(key(i));
      if (i < p.fluid_count) keys.weight.push_back(std::llround(100 * cost_of(records[i]) * pace_.factor()));
    }
    const Cut cut = cut_by_weight(ranks, keys, key.used_bits());
    first_block = cut.fluid[static_cast<std::size_t>(rank())] / sum_block;
    const Handover handover(ranks, keys, cut, key.used_bits());
    if (!handover.anything_moves()) return;
    handover.apply(on, p, scene);
  }

  /// Finds what this rank needs of others and brings it, for the places that the particles have now.
  void find_copies(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
    on_ = &on, p_ = &p, scene_ = &scene;
    const neighbours::OwnCells<Dim> own(on, p, scene);
    const auto near = neighbours::exchange_cells(ranks, own, scene);
    HaloParts parts;
    const std::size_t n_ranks = copies_of_.size();
    std::vector<neighbours::Candidates> needed(n_ranks);
    for (std::size_t r = 0; r < n_ranks; ++r) {
      if (static_cast<int>(r) != rank()) needed[r].index = own.beside(near[r], needed[r].fluid_count);
    }
    neighbours::keep_those_in_reach<Dim>(ranks, on.download(p.record, 0, p.count), scene, needed);
    std::vector<Counts> counts(n_ranks);
    copy_ = std::vector<typename Device::template Buffer<Index>>(n_ranks);
    std::vector<Bytes> announced(n_ranks);
    for (std::size_t r = 0; r < n_ranks; ++r) {
      counts[r].fluid = needed[r].fluid_count;
      counts[r].walls = static_cast<Index>(needed[r].index.size()) - counts[r].fluid;
      append_to(announced[r], &counts[r], 1);
      on.upload(std::move(needed[r].index), copies_of_[r]);
    }
    const auto heard = exchange_any(ranks, announced);
    std::vector<Counts> coming(n_ranks);
    for (std::size_t r = 0; r < coming.size(); ++r) {
      coming[r] = MessageReader(heard[r]).template number<Counts>();
      if (static_cast<int>(r) == rank()) coming[r] = {0, 0};
      (static_cast<int>(r) < rank() ? parts.fluid_before : parts.fluid_behind) += coming[r].fluid;
      (static_cast<int>(r) < rank() ? parts.walls_before : parts.walls_behind) += coming[r].walls;
    }
    Index fluid_at = p.count;
    Index walls_at = p.count + parts.fluid_before + parts.fluid_behind;
    for (std::size_t r = 0; r < coming.size(); ++r) {
      HostBuffer<Index> places;
      for (Index n = 0; n < coming[r].fluid; ++n) places.push_back(fluid_at++);
      for (Index n = 0; n < coming[r].walls; ++n) places.push_back(walls_at++);
      on.upload(std::move(places), copy_[r]);
    }
    p.copies = parts;
    set_room(on, p, scene, p.with_copies());
    bring_all(on, p, scene);
    blocks_.start(ranks, own, scene.lattice);
  }

  /// Exchanges all fields of the copies; from here on those that have become stale.
  void bring_all(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
    on.listener = nullptr;
    std::vector<const Field*> all{&field::place, &field::flow, &field::matter, &every_work};
    EachArray arrays(halo, [&](const Field& field, auto& buffer, const auto&) {
      if (buffer.size() == p.with_copies()) all.push_back(&field);
    });
    p.describe(scene, arrays);
    forget_all();
    start(all);
    arrive();
    on.listener = this;
  }

  void arrive() override {
    count_waiting([&] { messages_.finish(ranks); });
    unheard([&] {
      for (std::size_t r = 0; r < copy_.size(); ++r) {
        if (copy_[r].size() > 0) unpack(*on_, *p_, *scene_, on_their_way_, incoming_[r].data(), copy_[r], beside_);
      }
    });
  }
  void progress() override { messages_.progress(ranks); }

  void merge(const DriftBlocks& blocks, DriftBox* of_block) override { blocks_.merge(ranks, blocks, of_block); }

  /// Time that the slowest rank computes over the mean of all, less 1 [-].
  [[nodiscard]] double imbalance() const { return pace_.imbalance(); }
  /// Time that this rank has waited for others since the share was made [s], and the part of it for fields of copies.
  [[nodiscard]] double waited() const { return ranks.waited() - waited_before_; }
  [[nodiscard]] double waited_for_copies() const { return waited_for_copies_; }
  /// The copies that this rank keeps of others' particles.
  [[nodiscard]] Index copies() const { return p_ == nullptr ? 0 : p_->copies.count(); }

 protected:
  void start(const std::vector<const Field*>& fields) override {
    on_their_way_ = fields;
    const auto n = copies_of_.size();
    std::vector<std::span<const std::byte>> to(n);
    std::vector<std::span<std::byte>> from(n);
    unheard([&] {
      for (std::size_t r = 0; r < n; ++r) {
        outgoing_[r].resize(halo_bytes(*p_, *scene_, fields, beside_, copies_of_[r].size()));
        incoming_[r].resize(halo_bytes(*p_, *scene_, fields, beside_, copy_[r].size()));
        if (copies_of_[r].size() > 0) pack(*on_, *p_, *scene_, fields, copies_of_[r], beside_, outgoing_[r].data());
        to[r] = {outgoing_[r].data(), outgoing_[r].size()};
        from[r] = {incoming_[r].data(), incoming_[r].size()};
      }
    });
    count_waiting([&] { messages_.start(*on_, ranks, to, from); });
  }

 private:
  struct Counts {
    Index fluid = 0;
    Index walls = 0;
  };

  [[nodiscard]] int rank() const { return ranks.rank(); }
  [[nodiscard]] int size() const { return ranks.size(); }

  /// what() without the listener, and run even if what follows is skipped: what is stale was written.
  template <class What>
  void unheard(const What& what) {
    const int* const flag = on_->skip_unless(nullptr);
    AccessListener* const listener = std::exchange(on_->listener, nullptr);
    what();
    on_->listener = listener;
    on_->skip_unless(flag);
  }
  template <class What>
  void count_waiting(const What& what) {
    waited_for_copies_ -= ranks.waited();
    what();
    waited_for_copies_ += ranks.waited();
  }

  /// Gives the record and the arrays of copies room for n particles, with the record of zero volume behind them.
  void set_room(Device& on, Particles<Device>& p, const Scene<Dim>& scene, Index n) {
    p.record.resize(std::size_t{n} + 1);
    on.write(Record{}, p.record.data() + n);
    EachArray arrays(halo, [&](const Field&, auto& buffer, const auto&) {
      if (buffer.size() >= p.count) buffer.resize(n);
    });
    p.describe(scene, arrays);
  }

  /// Cost of a particle in a step, about, in terms of a particle of water (docs/ranks.md).
  static double cost_of(const Record& r) { return is_resting(r) ? 0.2 : is_sediment(r) ? 2.3 : 1; }

  /// The work quad, whatever it means.
  static constexpr Field every_work{"Work", quad_work};

  std::vector<typename Device::template Buffer<Index>> copies_of_;  // of this rank's particles, on each other rank
  std::vector<typename Device::template Buffer<Index>> copy_;       // this rank's copies of each other rank's
  std::vector<typename Device::Message> outgoing_;
  std::vector<typename Device::Message> incoming_;
  std::vector<const Field*> on_their_way_;  // the fields of the messages between start() and arrive()
  neighbours::BlockExchange<Dim> blocks_;
  CopyMessages<Device> messages_;  // ends before the bytes that it sends
  FieldsBeside beside_;
  Pace pace_;
  double waited_before_;
  double waited_for_copies_ = 0;
  Device* on_ = nullptr;
  Particles<Device>* p_ = nullptr;
  const Scene<Dim>* scene_ = nullptr;
};

}  // namespace thalweg
