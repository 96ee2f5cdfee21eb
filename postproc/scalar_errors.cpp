#include "postproc/scalar_errors.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/csv.hpp"
#include "common/extraction/profile_extraction.hpp"
#include "postproc/bed_change.hpp"
#include "postproc/curve_errors.hpp"

namespace thalweg {
namespace {

constexpr double missing = Profile::missing;

// The front of a model as its profile shows it: its own front.csv may go by another depth, half of another spacing. That
// of a measurement as its front.csv gives it, or else its profile.
double front_at(const ProfileSet& set, const TimedProfile& timed, double least_depth) {
  if (set.kind != SourceKind::measured) return water_front(timed.profile, least_depth, MissingColumn::dry);
  const std::filesystem::path file = timed.file.parent_path() / "front.csv";
  if (std::filesystem::exists(file)) {
    const CsvTable table = CsvTable::read(file);
    const std::vector<double> times = table.numbers("time", "s");
    for (std::size_t row = 0; row < times.size(); ++row) {
      if (std::abs(times[row] - timed.time) <= same_time) return table.numbers("front", "m")[row];
    }
  }
  return water_front(timed.profile, least_depth, MissingColumn::unknown);
}

struct Extremes {
  double scour = missing;
  double scour_at = missing;
  double deposition = missing;
};

Extremes extremes_of(const Profile& initial, const Profile& now, const ComparedRange& range) {
  Extremes found;
  // Columns of one source, which knows its walls: what is no bed does not count.
  const bool walls_known = !initial.floor.empty() && !now.floor.empty() && initial.x == now.x;
  const std::vector<double> rises = walls_known ? rise_of_bed(initial, now) : std::vector<double>();
  for (std::size_t i = 0; i < now.bed.size(); ++i) {
    const std::optional<double> before = value_at(initial.x, initial.bed, now.x[i]);
    if (now.x[i] < range.from || now.x[i] > range.to || std::isnan(now.bed[i]) || !before) continue;
    const double rise = walls_known ? rises[i] : now.bed[i] - *before;
    if (std::isnan(rise)) continue;
    if (!(std::max(0.0, -rise) <= found.scour)) {
      found.scour = std::max(0.0, -rise);
      found.scour_at = now.x[i];
    }
    if (!(std::max(0.0, rise) <= found.deposition)) found.deposition = std::max(0.0, rise);
  }
  return found;
}

}  // namespace

const TimedProfile* initial_of(const ProfileSet& first, const ProfileSet& second) {
  for (const ProfileSet* set : {&first, &second}) {
    if (set->initial && !set->initial->profile.bed.empty()) return &*set->initial;
  }
  return nullptr;
}

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

}  // namespace thalweg
