#include "postproc/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "postproc/curve_errors.hpp"
#include "postproc/scalar_errors.hpp"

namespace thalweg {
namespace {

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

}  // namespace thalweg
