#include "case/tables/compare.hpp"

#include <algorithm>
#include <filesystem>

#include "case/case.hpp"
#include "case/models/surface_bed.hpp"
#include "case/tables/common_checks.hpp"

namespace thalweg {

void Compare::check(const Case& whole, const CheckContext& at) const {
  check_within_run(at, "times", times, whole.output.end);
  if (!bed_times.empty() && !models::SurfaceBedOfCase::is_on(whole)) {
    at.reject("compare.bed_times", "compare.bed_times means nothing without a bed that is a surface",
              "give times, or write sediment = \"surface\" in [model]");
  }
  if (!bed_times.empty() && !times.empty()) {
    at.reject("compare.bed_times", "compare.bed_times and compare.times are both given",
              "give those of the bed or those of the water: profiles carry one time");
  }
  const double end = whole.surface_bed.end;
  if (end > 0 && std::any_of(bed_times.begin(), bed_times.end(), [&](double time) { return time > end; })) {
    at.reject("compare.bed_times", fmt::format("compare.bed_times goes beyond surface_bed.end = {} s", end),
              "give times up to it, or let the run end later");
  }
  if (factor_runs > 1 && !models::SurfaceBedOfCase::is_on(whole)) {
    at.reject("compare.factor_runs", "compare.factor_runs means nothing without a bed that is a surface",
              "remove it, or write sediment = \"surface\" in [model]");
  }
  if (factor_runs > 1 && whole.surface_bed.factor < 2 * (factor_runs - 1)) {
    at.reject("compare.factor_runs", "compare.factor_runs asks for a factor below 1",
              "give a larger surface_bed.factor, or fewer runs");
  }
  if (from > to) at.reject("compare.to", "compare.to lies before compare.from", "exchange them");
  // A run's folder may be computed on another machine than the one that holds the references.
  if (at.resolved()) return;
  for (const std::string& folder : references) {
    if (std::filesystem::is_directory(whole.folder / folder)) continue;
    at.reject("compare.references", fmt::format("compare.references names \"{}\", which is no folder", folder),
              "give it relative to the folder of the case file");
  }
}

}  // namespace thalweg
