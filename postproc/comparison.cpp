#include "postproc/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "common/csv.hpp"

namespace thalweg {
namespace {

// The value of a curve at x, linear between its points; nothing beyond its ends or beside a gap.
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
                                        double from, double to) {
  const std::vector<double>& wanted = reference.*curve.values;
  const std::vector<double>& found = compared.*curve.values;
  CurveError error;
  double squares = 0;
  double sum = 0;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t i = 0; i < reference.x.size(); ++i) {
    const double x = reference.x[i];
    if (x < from || x > to || std::isnan(wanted[i])) continue;
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
  // A curve this level has no height of its own to measure an error by.
  error.normalised_rmse = high - low > 1e-9 ? error.rmse / (high - low) : std::numeric_limits<double>::quiet_NaN();
  return error;
}

std::string times_only_in(const ProfileSet& one, const ProfileSet& other) {
  std::string times;
  for (const TimedProfile& profile : one.profiles) {
    if (other.at(profile.time) != nullptr) continue;
    times += fmt::format("{}{:g} s", times.empty() ? "" : ", ", profile.time);
  }
  return times;
}

bool has_curve(const ProfileSet& set, const Curve& curve) {
  return std::any_of(set.profiles.begin(), set.profiles.end(), [&](const TimedProfile& timed) {
    const std::vector<double>& values = timed.profile.*curve.values;
    return std::any_of(values.begin(), values.end(), [](double value) { return !std::isnan(value); });
  });
}

std::string millimetres(double metres) { return std::isnan(metres) ? "" : fmt::format("{:.2f}", metres * 1e3); }
std::string per_cent(double share) { return std::isnan(share) ? "-" : fmt::format("{:.1f} %", share * 1e2); }

}  // namespace

Comparison compare(const ProfileSet& reference, const ProfileSet& compared, double from, double to) {
  Comparison result;
  const std::string pair = compared.label + " against " + reference.label;
  for (const auto& [one, other] : {std::pair{&reference, &compared}, std::pair{&compared, &reference}}) {
    const std::string alone = times_only_in(*one, *other);
    if (!alone.empty()) result.remarks.push_back(pair + ": only " + one->label + " has a profile at " + alone);
  }
  for (const Curve& curve : curves) {
    const bool in_reference = has_curve(reference, curve);
    const bool in_compared = has_curve(compared, curve);
    if (in_reference != in_compared) {
      result.remarks.push_back(fmt::format("{}: {} has no {}, not compared", pair,
                                           in_reference ? compared.label : reference.label, curve.name));
    }
    if (!in_reference || !in_compared) continue;
    for (const TimedProfile& wanted : reference.profiles) {
      const TimedProfile* found = compared.at(wanted.time);
      if (found == nullptr) continue;
      const bool both = !(wanted.profile.*curve.values).empty() && !(found->profile.*curve.values).empty();
      std::optional<CurveError> error =
          both ? compare_curve(wanted.profile, found->profile, curve, from, to) : std::nullopt;
      if (!error) {
        result.remarks.push_back(
            fmt::format("{}: no common points of {} at {:g} s, not compared", pair, curve.name, wanted.time));
        continue;
      }
      error->reference = reference.label;
      error->compared = compared.label;
      error->time = wanted.time;
      result.errors.push_back(*error);
    }
  }
  return result;
}

Comparison compare_all(const std::vector<ProfileSet>& sets, double from, double to) {
  Comparison result;
  for (std::size_t a = 0; a < sets.size(); ++a) {
    for (std::size_t b = a + 1; b < sets.size(); ++b) {
      const bool first_is_reference = sets[a].kind > sets[b].kind;
      Comparison pair = first_is_reference ? compare(sets[a], sets[b], from, to) : compare(sets[b], sets[a], from, to);
      std::move(pair.errors.begin(), pair.errors.end(), std::back_inserter(result.errors));
      std::move(pair.remarks.begin(), pair.remarks.end(), std::back_inserter(result.remarks));
    }
  }
  return result;
}

std::string table_of(const Comparison& comparison) {
  std::string text;
  const CurveError* last = nullptr;
  for (const CurveError& error : comparison.errors) {
    if (last == nullptr || last->reference != error.reference || last->compared != error.compared) {
      text += fmt::format("\n{} against {}\n  {:<13}{:>8}{:>10}{:>9}{:>10}{:>10}{:>9}{:>8}  {}\n", error.compared,
                          error.reference, "curve", "t [s]", "RMSE [mm]", "of range", "bias [mm]", "max [mm]",
                          "at x [m]", "points", "range [m]");
    }
    text += fmt::format("  {:<13}{:>8.3f}{:>10}{:>9}{:>10}{:>10}{:>9.3f}{:>8}  {:.3f} .. {:.3f}\n", error.curve,
                        error.time, millimetres(error.rmse), per_cent(error.normalised_rmse), millimetres(error.bias),
                        millimetres(error.largest_error), error.largest_error_at, error.points, error.from, error.to);
    last = &error;
  }
  if (last != nullptr) text += fmt::format("\n{}\n", comparison_method);
  return text;
}

void write_errors(const std::filesystem::path& file, const Comparison& comparison) {
  CsvTable table({{"reference", ""},
                  {"compared", ""},
                  {"curve", ""},
                  {"time", "s"},
                  {"points", "-"},
                  {"from", "m"},
                  {"to", "m"},
                  {"rmse", "m"},
                  {"normalised_rmse", "-"},
                  {"bias", "m"},
                  {"largest_error", "m"},
                  {"largest_error_at", "m"}});
  table.comments.emplace_back(comparison_method);
  table.comments.insert(table.comments.end(), comparison.remarks.begin(), comparison.remarks.end());
  const auto number = [](double value) { return std::isnan(value) ? std::string() : fmt::format("{:.6g}", value); };
  for (const CurveError& e : comparison.errors) {
    table.add_row({e.reference, e.compared, e.curve, number(e.time), std::to_string(e.points), number(e.from),
                   number(e.to), number(e.rmse), number(e.normalised_rmse), number(e.bias), number(e.largest_error),
                   number(e.largest_error_at)});
  }
  table.write(file);
}

}  // namespace thalweg
