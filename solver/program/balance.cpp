#include "solver/program/balance.hpp"

#include <fmt/format.h>

#include <cmath>

#include "common/error.hpp"
#include "common/units.hpp"

namespace thalweg {

void MassBalance::check(const Totals& totals, const MassLedger& ledger, const std::vector<OpeningFlux>& openings,
                        const RunClock& clock, bool with_grains) {
  if (openings.empty()) return;
  for (const OpeningFlux& opening : openings) {
    if (!opening.overflows) continue;
    throw RunError(fmt::format(
        "the water at {} stands at z = {} at t = {:.4g} s, above the opening: its level runs away; let more "
        "water out or less in, or make the opening higher",
        opening.name, format_quantity(opening.level, "m"), clock.time));
  }
  if (with_grains) return;
  constexpr double most = 1e-6;
  const double mass = totals.water_mass + totals.sediment_mass;
  const double before = mass - ledger.in + ledger.out + ledger.lost;
  if (!constant_) constant_ = before;
  const double gap = before - *constant_;
  if (std::abs(gap) <= most * (mass + ledger.in)) return;
  throw RunError(fmt::format(
      "the balance of the scene does not close at t = {:.4g} s: {:.6g} kg of {:.6g} kg are {}, which is a fault of the "
      "solver; please report it with the case",
      clock.time, std::abs(gap), mass, gap > 0 ? "too many" : "missing"));
}

}  // namespace thalweg
