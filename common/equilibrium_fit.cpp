#include "common/equilibrium_fit.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace thalweg {
namespace {

constexpr std::size_t fewest_readings = 5;  // two unknowns, and something left to judge them by

/// A series with its best S_eq for a given T, which is linear least squares with one unknown.
class Series {
 public:
  Series(const std::vector<double>& times, const std::vector<double>& depths)
      : t_(Eigen::Map<const Eigen::ArrayXd>(times.data(), static_cast<Eigen::Index>(times.size()))),
        S_(Eigen::Map<const Eigen::ArrayXd>(depths.data(), static_cast<Eigen::Index>(depths.size()))) {}

  [[nodiscard]] Eigen::ArrayXd shape(double T) const {
    return -(-t_ / T).unaryExpr([](double x) { return std::expm1(x); });
  }
  [[nodiscard]] double equilibrium(double T) const {
    const Eigen::ArrayXd f = shape(T);
    return (S_ * f).sum() / f.square().sum();
  }
  [[nodiscard]] Eigen::ArrayXd residuals(double T) const { return S_ - equilibrium(T) * shape(T); }
  [[nodiscard]] double misfit(double logarithm) const { return residuals(std::exp(logarithm)).square().sum(); }
  /// Two columns: how the curve changes with S_eq and with T.
  [[nodiscard]] Eigen::MatrixX2d jacobian(double T) const {
    Eigen::MatrixX2d J(t_.size(), 2);
    J.col(0) = shape(T).matrix();
    J.col(1) = (-equilibrium(T) * t_ / (T * T) * (-t_ / T).exp()).matrix();
    return J;
  }
  [[nodiscard]] double least_step() const {
    double least = t_[0] > 0 ? t_[0] : HUGE_VAL;
    for (Eigen::Index i = 1; i < t_.size(); ++i) least = std::min(least, t_[i] - t_[i - 1]);
    return least;
  }
  [[nodiscard]] double last_time() const { return t_[t_.size() - 1]; }
  [[nodiscard]] double range() const { return S_.maxCoeff() - S_.minCoeff(); }
  [[nodiscard]] double largest() const { return S_.abs().maxCoeff(); }

 private:
  Eigen::ArrayXd t_;
  Eigen::ArrayXd S_;
};

void check(const std::vector<double>& times, const std::vector<double>& depths) {
  if (times.size() != depths.size())
    throw std::invalid_argument("times and depths differ in number; give one depth a time");
  const auto finite = [](double x) { return std::isfinite(x); };
  if (!std::all_of(times.begin(), times.end(), finite) || !std::all_of(depths.begin(), depths.end(), finite))
    throw std::invalid_argument("a time or a depth is not finite; leave such readings out");
  if (!times.empty() && times.front() < 0)
    throw std::invalid_argument("a time is negative; count from the start of scour");
  for (std::size_t i = 1; i < times.size(); ++i)
    if (!(times[i] > times[i - 1])) throw std::invalid_argument("times do not increase; sort the readings by time");
}

/// The logarithm of T with the least misfit between two logarithms: the best of a grid, then golden sections around it.
double best_logarithm(const Series& series, double low, double high) {
  constexpr int nodes = 400;
  const double step = (high - low) / nodes;
  int best = 0;
  for (int i = 1; i <= nodes; ++i)
    if (series.misfit(low + i * step) < series.misfit(low + best * step)) best = i;
  double a = low + std::max(best - 1, 0) * step;
  double b = low + std::min(best + 1, nodes) * step;
  constexpr double golden = 0.61803398874989485;
  while (b - a > 1e-10) {
    const double c = b - golden * (b - a);
    const double d = a + golden * (b - a);
    if (series.misfit(c) < series.misfit(d)) {
      b = d;
    } else {
      a = c;
    }
  }
  return 0.5 * (a + b);
}

double correlation_with_next(const Eigen::ArrayXd& residuals) {
  const Eigen::Index n = residuals.size();
  const double power = residuals.square().sum();
  if (!(power > 0)) return 0;
  const double r = (residuals.head(n - 1) * residuals.tail(n - 1)).sum() / power;
  return std::clamp(r, 0.0, 0.99);
}

/// T and S_eq of the curve with the least misfit.
struct FittedCurve {
  double logarithm = 0;  // of T
  double equilibrium = 0;
  double lowest_logarithm = 0;  // of those searched
};
FittedCurve best_curve(const Series& series) {
  FittedCurve curve;
  curve.lowest_logarithm = std::log(0.1 * series.least_step());
  curve.logarithm = best_logarithm(series, curve.lowest_logarithm, std::log(100 * series.last_time()));
  curve.equilibrium = series.equilibrium(std::exp(curve.logarithm));
  return curve;
}

/// Standard errors of S_eq and T, if residuals do not depend on each other.
Eigen::Vector2d standard_errors(const Series& series, double T) {
  const Eigen::ArrayXd residuals = series.residuals(T);
  const double variance = residuals.square().sum() / static_cast<double>(residuals.size() - 2);
  const Eigen::MatrixX2d J = series.jacobian(T);
  // T is of another unit than S_eq: the columns are scaled to one before they are inverted.
  const Eigen::Vector2d size = J.colwise().norm();
  const Eigen::MatrixX2d scaled = J * size.cwiseInverse().asDiagonal();
  const Eigen::Matrix2d inverse = (scaled.transpose() * scaled).inverse();
  return (variance * inverse.diagonal()).cwiseMax(0).cwiseSqrt().cwiseQuotient(size);
}

/// S_eq over that of the first half of the time with two of its standard errors, less 1.
double growth_of(double equilibrium, const std::vector<double>& times, const std::vector<double>& depths) {
  const auto half = std::upper_bound(times.begin(), times.end(), 0.5 * times.back()) - times.begin();
  if (half < static_cast<std::ptrdiff_t>(fewest_readings)) return 0;
  const Series series({times.begin(), times.begin() + half}, {depths.begin(), depths.begin() + half});
  const FittedCurve curve = best_curve(series);
  const double before = curve.equilibrium + 2 * standard_errors(series, std::exp(curve.logarithm))[0];
  return before > 0 ? equilibrium / before - 1 : 0;
}

}  // namespace

EquilibriumFit fit_equilibrium(const std::vector<double>& times, const std::vector<double>& depths) {
  check(times, depths);
  EquilibriumFit fit;
  if (times.size() < fewest_readings) {
    fit.refusal = fmt::format("no fit: {} readings, and at least {} are needed", times.size(), fewest_readings);
    return fit;
  }
  const Series series(times, depths);
  if (!(series.range() > 1e-9 * series.largest())) {
    fit.refusal = "no fit: the depth does not change";
    return fit;
  }
  const FittedCurve curve = best_curve(series);
  const double T = std::exp(curve.logarithm);
  constexpr double at_the_edge = 1e-6;
  const double S_eq = curve.equilibrium;
  if (!(S_eq > 0) || curve.logarithm - curve.lowest_logarithm < at_the_edge) {
    fit.refusal = "no fit: the depth does not grow towards an equilibrium";
    return fit;
  }
  const Eigen::ArrayXd residuals = series.residuals(T);
  const double n = static_cast<double>(times.size());
  fit.equilibrium = S_eq;
  fit.time_scale = T;
  fit.reached = -std::expm1(-series.last_time() / T);
  fit.growth = growth_of(S_eq, times, depths);
  fit.rms = std::sqrt(residuals.square().sum() / n);
  fit.autocorrelation = correlation_with_next(residuals);
  const double inflation = (1 + fit.autocorrelation) / (1 - fit.autocorrelation);
  const Eigen::Vector2d errors = 2 * std::sqrt(inflation) * standard_errors(series, T);
  fit.equilibrium_error = errors[0];
  fit.time_scale_error = errors[1];
  return fit;
}

std::string describe_fit(const EquilibriumFit& fit, const std::string& depth_unit, const std::string& time_unit) {
  if (!fit.is_fitted()) return fit.refusal;
  if (fit.still_grows() && fit.reached > enough_reached) {
    return fmt::format("not reached: it still grows; S_eq of all readings is {:.0f} % above that of the first half",
                       100 * fit.growth);
  }
  if (!fit.has_reached()) return fmt::format("not reached: S/S_eq {:.2f}", fit.reached);
  return fmt::format(
      "S_eq {:.4g} {} +- {:.2g} {}, T {:.4g} {} +- {:.2g} {} (two standard errors), rms {:.2g} {}, S/S_eq {:.2f}",
      fit.equilibrium, depth_unit, fit.equilibrium_error, depth_unit, fit.time_scale, time_unit, fit.time_scale_error,
      time_unit, fit.rms, depth_unit, fit.reached);
}

}  // namespace thalweg
