#include "case/tables/surface_bed.hpp"

#include "case/case.hpp"
#include "case/check_context.hpp"

namespace thalweg {

void SurfaceBedSettings::check(const Case& whole, const CheckContext& at) const {
  if (models::SurfaceBedOfCase::is_on(whole) || at.resolved()) return;
  for (const std::string& key : at.keys()) {
    if (!at.given(key)) continue;
    at.reject(at.key(key), at.key(key) + " means nothing without a bed that is a surface",
              "remove it, or write sediment = \"surface\" in [model]");
  }
}

}  // namespace thalweg
