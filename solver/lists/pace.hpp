#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>

#include "solver/backend/ranks.hpp"

namespace thalweg {

/// Time that a particle of this rank takes, against what its kind makes one expect and against the other ranks. The shares
/// are cut by it; results do not depend on where they are.
class Pace {
 public:
  /// [-]
  [[nodiscard]] double factor() const { return factor_; }
  /// Time that the slowest rank computed over the mean of all, less 1 [-]; since the last time that was worth a look.
  [[nodiscard]] double imbalance() const { return imbalance_; }

  /// Looks at what all ranks have done since the last time. expected: the sum of this rank's particles' costs.
  void look(Ranks& ranks, double expected) {
    struct Work {
      double busy;
      double expected;
    };
    const double now = seconds();
    const double waited = ranks.waited();
    const auto all = gather_from(ranks, Work{now - looked_ - (waited - waited_), expected});
    Work sum{};
    double most = 0;
    for (const Work& rank : all) {
      sum.busy += rank.busy;
      sum.expected += rank.expected;
      most = std::max(most, rank.busy);
    }
    const auto n = static_cast<double>(all.size());
    if (sum.busy < shortest * n) return;
    looked_ = now;
    waited_ = waited;
    if (first_) {  // from the start to the first lists there was more to do than steps
      first_ = false;
      return;
    }
    imbalance_ = most / (sum.busy / n) - 1;
    const Work mine = all[static_cast<std::size_t>(ranks.rank())];
    if (imbalance_ < worth_it || !(mine.expected > 0) || !(sum.expected > 0)) return;
    const double found = factor_ * (mine.busy / mine.expected) / (sum.busy / sum.expected);
    factor_ = std::clamp(factor_ * std::pow(found / factor_, follows), 1 / most_factor, most_factor);
  }

 private:
  static constexpr double shortest = 0.2;   // [s] a rank, below which a clock says little
  static constexpr double worth_it = 0.02;  // [-] of imbalance
  static constexpr double follows = 0.5;    // [-] of the way in logarithms: what a moment has slowed is not chased
  static constexpr double most_factor = 8;

  static double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }

  double factor_ = 1;
  double imbalance_ = 0;
  double looked_ = seconds();
  double waited_ = 0;
  bool first_ = true;
};

}  // namespace thalweg
