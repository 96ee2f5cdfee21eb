#include "postproc/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "common/csv.hpp"
#include "common/extraction/profile_extraction.hpp"

namespace thalweg {
namespace {

constexpr double missing = Profile::missing;

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

constexpr Curve bed_curve = curves[1];

// The bed from which changes count: the reference's own, else that of the other, else none.
const TimedProfile* initial_of(const ProfileSet& first, const ProfileSet& second) {
  for (const ProfileSet* set : {&first, &second}) {
    if (set->initial && !set->initial->profile.bed.empty()) return &*set->initial;
  }
  return nullptr;
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
  constexpr double least_change = 1e-6;  // [m] root mean square, below what any extraction resolves
  if (points == 0 || std::sqrt(change / points) < least_change) return missing;
  return 1 - error / change;
}

// The front a source's own front.csv gives at a time, or the one its profile shows.
double front_at(const ProfileSet& set, const TimedProfile& timed, double least_depth) {
  const std::filesystem::path file = timed.file.parent_path() / "front.csv";
  if (std::filesystem::exists(file)) {
    const CsvTable table = CsvTable::read(file);
    const std::vector<double> times = table.numbers("time", "s");
    for (std::size_t row = 0; row < times.size(); ++row) {
      if (std::abs(times[row] - timed.time) <= same_time) return table.numbers("front", "m")[row];
    }
  }
  const bool is_model = set.kind != SourceKind::measured;
  return water_front(timed.profile, {}, least_depth, is_model ? MissingColumn::dry : MissingColumn::unknown);
}

struct Extremes {
  double scour = missing;
  double scour_at = missing;
  double deposition = missing;
};

Extremes extremes_of(const Profile& initial, const Profile& now, const ComparedRange& range) {
  Extremes found;
  for (std::size_t i = 0; i < now.bed.size(); ++i) {
    const std::optional<double> before = value_at(initial.x, initial.bed, now.x[i]);
    if (now.x[i] < range.from || now.x[i] > range.to || std::isnan(now.bed[i]) || !before) continue;
    const double rise = now.bed[i] - *before;
    if (!(std::max(0.0, -rise) <= found.scour)) {
      found.scour = std::max(0.0, -rise);
      found.scour_at = now.x[i];
    }
    if (!(std::max(0.0, rise) <= found.deposition)) found.deposition = std::max(0.0, rise);
  }
  return found;
}

// Front and extremes of the bed at the times both have.
void compare_numbers(const ProfileSet& reference, const ProfileSet& compared, const ComparedRange& range,
                     Comparison& result) {
  const TimedProfile* reference_initial = initial_of(reference, compared);
  const TimedProfile* compared_initial = initial_of(compared, reference);
  for (const TimedProfile& wanted : reference.profiles) {
    const TimedProfile* found = compared.at(wanted.time);
    if (found == nullptr) continue;
    const auto add = [&](const char* quantity, double of_reference, double of_compared) {
      if (std::isnan(of_reference) && std::isnan(of_compared)) return;
      result.scalars.push_back(
          {reference.label, compared.label, reference.line, quantity, wanted.time, of_reference, of_compared});
    };
    if (reference.line.empty()) {
      add("front", front_at(reference, wanted, range.least_depth), front_at(compared, *found, range.least_depth));
    }
    if (reference_initial == nullptr) continue;
    const Extremes a = extremes_of(reference_initial->profile, wanted.profile, range);
    const Extremes b = extremes_of(compared_initial->profile, found->profile, range);
    add("scour", a.scour, b.scour);
    add("scour_at", a.scour_at, b.scour_at);
    add("deposition", a.deposition, b.deposition);
  }
}

// Sum of squares of what two curves differ by where both have values, and how many columns these are.
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

std::string millimetres(double metres) { return std::isnan(metres) ? "" : fmt::format("{:.2f}", metres * 1e3); }
std::string per_cent(double share) { return std::isnan(share) ? "-" : fmt::format("{:.1f} %", share * 1e2); }

}  // namespace

Comparison compare(const ProfileSet& reference, const ProfileSet& compared, const ComparedRange& range) {
  Comparison result;
  const std::string pair =
      compared.label + " against " + reference.label + (reference.line.empty() ? "" : ", line " + reference.line);
  const TimedProfile* initial = initial_of(reference, compared);
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
          both ? compare_curve(wanted.profile, found->profile, curve, range) : std::nullopt;
      if (!error) {
        result.remarks.push_back(
            fmt::format("{}: no common points of {} at {:g} s, not compared", pair, curve.name, wanted.time));
        continue;
      }
      error->reference = reference.label;
      error->compared = compared.label;
      error->time = wanted.time;
      error->line = reference.line;
      if (initial != nullptr && curve.values == &Profile::bed) {
        error->brier_skill = brier_skill(initial->profile, wanted.profile, found->profile, range);
      }
      result.errors.push_back(*error);
    }
  }
  if (has_curve(reference, bed_curve) && has_curve(compared, bed_curve)) {
    if (initial == nullptr) {
      result.remarks.push_back(pair +
                               ": neither has a bed at 0 s, so there is no Brier skill score, scour or deposition");
    } else if (!reference.initial) {
      result.remarks.push_back(pair + ": " + reference.label + " has no bed at 0 s; its change counts from that of " +
                               compared.label);
    }
  }
  compare_numbers(reference, compared, range, result);
  return result;
}

Comparison compare_all(const std::vector<ProfileSet>& sets, const ComparedRange& range) {
  Comparison result;
  for (std::size_t a = 0; a < sets.size(); ++a) {
    for (std::size_t b = a + 1; b < sets.size(); ++b) {
      const bool first_is_reference = sets[a].kind > sets[b].kind;
      Comparison pair = first_is_reference ? compare(sets[a], sets[b], range) : compare(sets[b], sets[a], range);
      std::move(pair.errors.begin(), pair.errors.end(), std::back_inserter(result.errors));
      std::move(pair.scalars.begin(), pair.scalars.end(), std::back_inserter(result.scalars));
      std::move(pair.remarks.begin(), pair.remarks.end(), std::back_inserter(result.remarks));
    }
  }
  return result;
}

std::vector<Scatter> scatter_of(const std::vector<ProfileSet>& repeated) {
  std::vector<Scatter> result;
  if (repeated.size() < 2) return result;
  for (const TimedProfile& timed : repeated.front().profiles) {
    const bool all_have_it = std::all_of(repeated.begin(), repeated.end(),
                                         [&](const ProfileSet& set) { return set.at(timed.time) != nullptr; });
    if (!all_have_it) continue;
    for (const Curve& curve : curves) {
      double sum = 0;
      int columns = 0;
      for (std::size_t a = 0; a < repeated.size(); ++a) {
        for (std::size_t b = a + 1; b < repeated.size(); ++b) {
          const Profile& one = repeated[a].at(timed.time)->profile;
          const Profile& other = repeated[b].at(timed.time)->profile;
          if ((one.*curve.values).empty() || (other.*curve.values).empty()) continue;
          const auto [squares, shared] = squares_between(one, other, curve);
          sum += squares;
          columns += shared;
        }
      }
      if (columns == 0) continue;
      result.push_back(
          {repeated.front().line, curve.name, timed.time, std::sqrt(sum / columns), static_cast<int>(repeated.size())});
    }
  }
  return result;
}

void add_scatter(Comparison& comparison, const std::string& label, const std::vector<Scatter>& scatter) {
  for (CurveError& error : comparison.errors) {
    if (error.reference != label && error.compared != label) continue;
    for (const Scatter& known : scatter) {
      if (known.line != error.line || known.curve != error.curve || std::abs(known.time - error.time) > same_time)
        continue;
      error.scatter = known.rms;
      error.scatter_runs = known.runs;
    }
  }
}

std::string table_of(const Comparison& comparison) {
  std::string text;
  const CurveError* last = nullptr;
  for (const CurveError& error : comparison.errors) {
    if (last == nullptr || last->reference != error.reference || last->compared != error.compared ||
        last->line != error.line) {
      text += fmt::format("\n{} against {}{}\n  {:<13}{:>8}{:>10}{:>9}{:>10}{:>10}{:>9}{:>8}{:>13}{:>8}  {}\n",
                          error.compared, error.reference, error.line.empty() ? "" : ", line " + error.line, "curve",
                          "t [s]", "RMSE [mm]", "of range", "bias [mm]", "max [mm]", "at x [m]", "skill",
                          "scatter [mm]", "points", "range [m]");
    }
    text += fmt::format("  {:<13}{:>8.3f}{:>10}{:>9}{:>10}{:>10}{:>9.3f}{:>8}{:>13}{:>8}  {:.3f} .. {:.3f}\n",
                        error.curve, error.time, millimetres(error.rmse), per_cent(error.normalised_rmse),
                        millimetres(error.bias), millimetres(error.largest_error), error.largest_error_at,
                        std::isnan(error.brier_skill) ? "" : fmt::format("{:.2f}", error.brier_skill),
                        millimetres(error.scatter), error.points, error.from, error.to);
    last = &error;
  }
  if (last != nullptr) text += fmt::format("\n{}\n", comparison_method);
  if (!comparison.scalars.empty()) {
    text += fmt::format("\n  {:<12}{:>8}{:>16}{:>15}{:>12}  {}\n", "number", "t [s]", "reference [mm]", "compared [mm]",
                        "error [mm]", "compared against reference");
  }
  for (const ScalarError& s : comparison.scalars) {
    text += fmt::format("  {:<12}{:>8.3f}{:>16}{:>15}{:>12}  {} against {}{}\n", s.quantity, s.time,
                        millimetres(s.reference_value), millimetres(s.compared_value),
                        millimetres(s.compared_value - s.reference_value), s.compared, s.reference,
                        s.line.empty() ? "" : ", line " + s.line);
  }
  return text;
}

namespace {

std::string number(double value) { return std::isnan(value) ? std::string() : fmt::format("{:.6g}", value); }

void write_scalars(const std::filesystem::path& file, const std::vector<ScalarError>& scalars) {
  CsvTable table({{"reference", ""},
                  {"compared", ""},
                  {"line", ""},
                  {"quantity", ""},
                  {"time", "s"},
                  {"reference_value", "m"},
                  {"compared_value", "m"},
                  {"error", "m"},
                  {"relative_error", "-"}});
  table.comments.emplace_back(
      "error = compared - reference, relative to the reference's value; scour and deposition: largest fall and rise of "
      "the "
      "bed since 0 s within the compared range; an empty cell is a value that a source does not have");
  for (const ScalarError& s : scalars) {
    const double error = s.compared_value - s.reference_value;
    const double relative = s.reference_value == 0 ? missing : error / std::abs(s.reference_value);
    table.add_row({s.reference, s.compared, s.line, s.quantity, number(s.time), number(s.reference_value),
                   number(s.compared_value), number(error), number(relative)});
  }
  table.write(file);
}

}  // namespace

void write_errors(const std::filesystem::path& folder, const Comparison& comparison) {
  CsvTable table({{"reference", ""},
                  {"compared", ""},
                  {"line", ""},
                  {"curve", ""},
                  {"time", "s"},
                  {"points", "-"},
                  {"from", "m"},
                  {"to", "m"},
                  {"rmse", "m"},
                  {"normalised_rmse", "-"},
                  {"bias", "m"},
                  {"largest_error", "m"},
                  {"largest_error_at", "m"},
                  {"brier_skill", "-"},
                  {"scatter", "m"},
                  {"scatter_runs", "-"}});
  table.comments.emplace_back(comparison_method);
  table.comments.insert(table.comments.end(), comparison.remarks.begin(), comparison.remarks.end());
  for (const CurveError& e : comparison.errors) {
    table.add_row({e.reference, e.compared, e.line, e.curve, number(e.time), std::to_string(e.points), number(e.from),
                   number(e.to), number(e.rmse), number(e.normalised_rmse), number(e.bias), number(e.largest_error),
                   number(e.largest_error_at), number(e.brier_skill), number(e.scatter),
                   e.scatter_runs > 0 ? std::to_string(e.scatter_runs) : std::string()});
  }
  table.write(folder / "errors.csv");
  write_scalars(folder / "scalars.csv", comparison.scalars);
}

}  // namespace thalweg
