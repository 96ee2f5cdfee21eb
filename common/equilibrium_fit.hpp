#pragma once

#include <string>
#include <vector>

namespace thalweg {

/// Share of the equilibrium that a series has to reach before its fit is worth printing [-].
inline constexpr double enough_reached = 0.8;
/// S_eq may be so much larger than that of the first half of the time [-]. Curves that grow like a logarithm or a power of
/// time give 0.12 and more, and an exponential fit says of each that it has reached its end; a true exponential gives 0.
inline constexpr double most_growth = 0.05;

/// S(t) = S_eq (1 - exp(-t/T)), fitted to a series of scour depths by least squares.
///
/// Errors are two standard errors (about 95 %) from the residuals' covariance s^2 (J'J)^-1. Residuals of a series
/// that is sampled densely depend on each other; the covariance is therefore multiplied by (1 + r)/(1 - r), r being
/// the correlation of a residual with the next one (a first-order autoregressive process; samples at about even
/// steps). It says how well the curve is known if it is the right curve; it does not say whether the scour follows
/// it.
struct EquilibriumFit {
  double equilibrium = 0;        // S_eq, in the unit of the depths
  double time_scale = 0;         // T, in the unit of the times
  double equilibrium_error = 0;  // two standard errors of S_eq
  double time_scale_error = 0;   // two standard errors of T
  double rms = 0;                // of the residuals, in the unit of the depths
  double autocorrelation = 0;    // r [-], 0 to 0.99
  double reached = 0;            // [-] the curve at the last time over S_eq
  double growth = 0;             // [-] S_eq over the most that the first half of the time lets expect, less 1
  std::string refusal;           // why there is no fit, in a line; empty if there is one

  [[nodiscard]] bool is_fitted() const { return refusal.empty(); }
  /// True if the series has come far enough towards its equilibrium for the numbers to be printed.
  [[nodiscard]] bool has_reached() const { return is_fitted() && reached > enough_reached && !still_grows(); }
  /// True if the curve of the first half of the time falls short of what came after.
  [[nodiscard]] bool still_grows() const { return growth > most_growth; }
};

/// Fits a series: times since the scour began (increasing, >= 0) and depths of the hole (positive downwards), in any
/// units. For each T the best S_eq follows in closed form; T is searched between a tenth of the shortest step and a
/// hundred times the last time, on a logarithmic grid and then by golden sections. A series that says nothing of an
/// equilibrium (fewer than five readings, constant, falling, empty) gives a refusal. Throws std::invalid_argument if
/// the series differ in length, times do not increase or are negative, or a number is not finite.
EquilibriumFit fit_equilibrium(const std::vector<double>& times, const std::vector<double>& depths);

/// The fit in a line: "S_eq 0.12 m +- 0.01 m, T 35 s +- 4 s (two standard errors), rms 0.002 m, S/S_eq 0.97";
/// "not reached: S/S_eq 0.62" where it has not, "not reached: …" where it still grows, and the refusal where there is no
/// fit.
std::string describe_fit(const EquilibriumFit& fit, const std::string& depth_unit, const std::string& time_unit);

}  // namespace thalweg
