#include "case/tables/suspended_load.hpp"

#include <fmt/format.h>

#include "case/case.hpp"
#include "case/tables/common_checks.hpp"

namespace thalweg {

void SuspendedLoad::check(const Case& whole, const CheckContext& at) const {
  check_unused_keys(
      at, *this, [](const std::string&) { return "with carried_by = \"parcels\""; },
      "remove it, or write carried_by = \"water\"");
  if (carried_by != CarriedBy::water || whole.sediments.size() != 1 || diameter <= whole.sediment().grain_diameter)
    return;
  at.reject(at.key("diameter"),
            fmt::format("{} of {:g} mm is larger than the bed's grains, of {:g} mm", at.key("diameter"),
                        1000 * diameter, 1000 * whole.sediment().grain_diameter),
            "give that of the finer grains which the water carries");
}

}  // namespace thalweg
