#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/particles.hpp"
#include "common/ranks.hpp"

namespace thalweg {

/// The search for particles with one id, or in one place, among particles of which the first rank knows a range at a time: ids
/// and places are shared out, so that equal ones come to the same rank.
class TwinSearch {
 public:
  /// `mixed`: grains and water may share a place.
  TwinSearch(Ranks& ranks, bool mixed) : ranks_(ranks), mixed_(mixed) {}

  /// The next particles, which only the first rank has. Called by all ranks.
  void add(const ParticleSet& range);

  /// The first rank is told what is wrong with the particles of `file` and what to do, or nothing. Called by all ranks, once.
  [[nodiscard]] std::string fault(const std::string& file);

 private:
  struct Placed {
    double at[3];  // [m]
    std::int64_t id;
    std::int64_t type;
  };
  struct Found {
    bool has_id;         // that is negative, or that two have
    bool has_place;      // in which two are
    std::int64_t least;  // of all ids
    std::int64_t id;     // the least that two have
    Placed placed;       // at the least place
    std::int64_t other;  // who lies there, too
  };
  [[nodiscard]] Found find();

  Ranks& ranks_;
  bool mixed_;
  std::vector<std::int64_t> ids_;
  std::vector<Placed> places_;
};

}  // namespace thalweg
