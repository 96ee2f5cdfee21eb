#pragma once

#include <optional>
#include <vector>

#include "solver/program/run_counts.hpp"
#include "solver/state/report.hpp"

namespace thalweg {

/// Watches the mass of a scene with inlets or outlets: what is there, less what came in, plus what went out and was
/// lost, stays the same; and no water stands above an opening that has a surface.
class MassBalance {
 public:
  /// Takes the numbers of a moment. Throws RunError where the balance does not close to a millionth of the mass, or
  /// where the water's level has left an opening. with_grains: water carries grains, whose mass the ledger does not know;
  /// then the level alone is watched.
  void check(const Totals& totals, const MassLedger& ledger, const std::vector<OpeningFlux>& openings,
             const RunClock& clock, bool with_grains);

 private:
  std::optional<double> constant_;  // [kg]
};

}  // namespace thalweg
