#include "case/tables/compare.hpp"

#include <filesystem>

#include "case/case.hpp"
#include "case/tables/common_checks.hpp"

namespace thalweg {

void Compare::check(const Case& whole, const CheckContext& at) const {
  check_within_run(at, "times", times, whole.output.end);
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
