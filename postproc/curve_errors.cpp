#include "postproc/curve_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thalweg {

std::optional<double> value_at(const std::vector<double>& xs, const std::vector<double>& values, double x) {
  const auto right = std::lower_bound(xs.begin(), xs.end(), x);
  if (right == xs.end()) return std::nullopt;
  const auto r = static_cast<std::size_t>(right - xs.begin());
  if (xs[r] == x) return std::isnan(values[r]) ? std::nullopt : std::make_optional(values[r]);
  if (r == 0 || std::isnan(values[r]) || std::isnan(values[r - 1])) return std::nullopt;
  const double share = (x - xs[r - 1]) / (xs[r] - xs[r - 1]);
  return values[r - 1] + share * (values[r] - values[r - 1]);
}

std::optional<CurveError> compare_curve(const Profile& reference, const Profile& compared, const Curve& curve,
                                        const ComparedRange& range) {
  const std::vector<double>& wanted = reference.*curve.values;
  const std::vector<double>& found = compared.*curve.values;
  CurveError error;
  double squares = 0;
  double sum = 0;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t i = 0; i < reference.x.size(); ++i) {
    const double x = reference.x[i];
    if (x < range.from || x > range.to || std::isnan(wanted[i])) continue;
    const std::optional<double> value = value_at(compared.x, found, x);
    if (!value) continue;
    const double difference = *value - wanted[i];
    if (error.points == 0) error.from = x;
    error.to = x;
    ++error.points;
    squares += difference * difference;
    sum += difference;
    low = std::min(low, wanted[i]);
    high = std::max(high, wanted[i]);
    if (error.points > 1 && std::abs(difference) <= std::abs(error.largest_error)) continue;
    error.largest_error = difference;
    error.largest_error_at = x;
  }
  if (error.points == 0) return std::nullopt;
  const auto count = static_cast<double>(error.points);
  error.curve = curve.name;
  error.rmse = std::sqrt(squares / count);
  error.bias = sum / count;
  // A level curve has no range of heights to normalise by.
  error.normalised_rmse = high - low > 1e-9 ? error.rmse / (high - low) : std::numeric_limits<double>::quiet_NaN();
  return error;
}

double brier_skill(const Profile& initial, const Profile& reference, const Profile& compared,
                   const ComparedRange& range) {
  double error = 0;
  double change = 0;
  int points = 0;
  for (std::size_t i = 0; i < reference.x.size(); ++i) {
    const double x = reference.x[i];
    if (x < range.from || x > range.to || std::isnan(reference.bed[i])) continue;
    const std::optional<double> value = value_at(compared.x, compared.bed, x);
    const std::optional<double> before = value_at(initial.x, initial.bed, x);
    if (!value || !before) continue;
    error += std::pow(*value - reference.bed[i], 2);
    change += std::pow(*before - reference.bed[i], 2);
    ++points;
  }
  constexpr double least_change = 1e-6;  // [m] root mean square; no extraction resolves less
  if (points == 0 || std::sqrt(change / points) < least_change) return Profile::missing;
  return 1 - error / change;
}

std::pair<double, int> squares_between(const Profile& one, const Profile& other, const Curve& curve) {
  double sum = 0;
  int columns = 0;
  const std::vector<double>& values = one.*curve.values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::optional<double> value = value_at(other.x, other.*curve.values, one.x[i]);
    if (!value || std::isnan(values[i])) continue;
    sum += std::pow(*value - values[i], 2);
    ++columns;
  }
  return {sum, columns};
}

}  // namespace thalweg
