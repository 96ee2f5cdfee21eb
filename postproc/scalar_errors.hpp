#pragma once

#include "postproc/comparison.hpp"

namespace thalweg {

/// The profile from whose bed changes count: the first set's own initial one, else that of the second, else null.
const TimedProfile* initial_of(const ProfileSet& first, const ProfileSet& second);

/// Adds front, scour and deposition at the times both sets have to the scalars of `result`.
void compare_numbers(const ProfileSet& reference, const ProfileSet& compared, const ComparedRange& range,
                     Comparison& result);

}  // namespace thalweg
