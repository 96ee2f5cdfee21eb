#include "case/tables/domain.hpp"

#include <algorithm>
#include <set>
#include <string>

#include "case/tables/common_checks.hpp"

namespace thalweg {

bool Domain::is_periodic(int axis) const {
  return std::find(periodic.begin(), periodic.end(), std::string(1, "xyz"[axis])) != periodic.end();
}

void Domain::check(const Case&, const CheckContext& at) const {
  check_corners(at, from, to);
  std::set<std::string> seen;
  for (const std::string& direction : periodic) {
    const bool known = direction == "x" || direction == "z" || (direction == "y" && at.uses(1));
    if (!known) {
      at.reject("domain.periodic", fmt::format("domain.periodic names \"{}\"", direction),
                at.uses(1) ? "the directions are x, y, z" : "the directions are x, z with dimension = 2");
    }
    if (!seen.insert(direction).second) {
      at.reject("domain.periodic", fmt::format("domain.periodic names \"{}\" twice", direction), "remove one");
    }
  }
}

}  // namespace thalweg
