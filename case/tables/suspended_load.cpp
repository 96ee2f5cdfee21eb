#include "case/tables/suspended_load.hpp"

#include "case/tables/common_checks.hpp"

namespace thalweg {

void SuspendedLoad::check(const Case&, const CheckContext& at) const {
  check_unused_keys(
      at, *this, [](const std::string&) { return "with carried_by = \"parcels\""; },
      "remove it, or write carried_by = \"water\"");
}

}  // namespace thalweg
