#pragma once

#include <stdexcept>
#include <vector>

#include "solver/backend/device.hpp"

namespace thalweg {

/// Makes several lists of indices one after the other and asks the device once, at the end, how many each holds.
template <class Device>
class Selection {
 public:
  template <class T>
  using Buffer = typename Device::template Buffer<T>;

  explicit Selection(Device& on) : on_(on) { counts_.resize(most); }

  /// Keeps those of candidate(0) … candidate(n - 1) for which keep() is true. Throws std::logic_error for more lists
  /// than a selection holds: their counts lie in one array, which may not move.
  template <class Candidate, class Keep>
  void choose(Index n, const Candidate& candidate, const Keep& keep, Buffer<Index>& kept) {
    if (chosen_.size() == most) throw std::logic_error("a Selection holds 8 lists; make another one for the rest");
    on_.select(n, candidate, keep, kept, counts_.data() + chosen_.size());
    chosen_.push_back(&kept);
  }
  template <class Keep>
  void choose(Index n, const Keep& keep, Buffer<Index>& kept) {
    choose(
        n, [] HOST_DEVICE(Index i) { return i; }, keep, kept);
  }
  template <class Keep>
  void choose(ClusterRange from, const Keep& keep, Buffer<Index>& kept) {
    choose(
        from.count, [=] HOST_DEVICE(Index n) { return from[n]; }, keep, kept);
  }

  /// Gives the lists their lengths.
  void finish() {
    const auto counts = on_.download(counts_, 0, chosen_.size());
    for (std::size_t k = 0; k < chosen_.size(); ++k) chosen_[k]->resize(counts[k]);
  }

 private:
  static constexpr std::size_t most = 8;
  Device& on_;
  Buffer<Index> counts_;
  std::vector<Buffer<Index>*> chosen_;
};

}  // namespace thalweg
