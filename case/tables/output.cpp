#include "case/tables/output.hpp"

#include "case/tables/common_checks.hpp"

namespace thalweg {

void Output::check(const Case&, const CheckContext& at) const { check_within_run(at, "times", times, end); }

}  // namespace thalweg
