#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "postproc/comparison.hpp"

namespace thalweg {

/// The value of a curve at x, linear between its points; nothing beyond its ends or beside a gap.
std::optional<double> value_at(const std::vector<double>& xs, const std::vector<double>& values, double x);

/// The errors of one curve at the reference's points within the range; nothing without common points. The names of the
/// sources, the line and the time are left to the caller.
std::optional<CurveError> compare_curve(const Profile& reference, const Profile& compared, const Curve& curve,
                                        const ComparedRange& range);

/// CurveError::brier_skill of two beds; NaN without common points or without change.
double brier_skill(const Profile& initial, const Profile& reference, const Profile& compared,
                   const ComparedRange& range);

/// Sum of the squared differences of two curves [m^2] over the columns of `one` where both have values, and the number
/// of these columns.
std::pair<double, int> squares_between(const Profile& one, const Profile& other, const Curve& curve);

}  // namespace thalweg
