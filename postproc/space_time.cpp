#include "postproc/space_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/csv.hpp"
#include "postproc/bed_change.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

std::vector<TimedProfile> profiles_of(const ReportInput& input) {
  std::vector<TimedProfile> profiles;
  for (const SnapshotProfile& snapshot : input.extraction.along_x) profiles.push_back(snapshot.get());
  return profiles;
}

}  // namespace

BedHistory write_bed_history(const fs::path& file, const ReportInput& input) {
  const std::vector<TimedProfile> profiles = profiles_of(input);
  BedHistory history{file};
  if (profiles.size() < 2 || profiles.front().profile.bed.empty()) return history;
  const Profile& first = profiles.front().profile;
  CsvTable table({{"x", "m"}, {"time", "s"}, {"from", "s"}, {"to", "s"}, {"change", "m"}});
  table.comments.emplace_back(
      "bed minus the bed of the first time, from the run's profiles; where sediment lies then or now");
  for (std::size_t n = 0; n < profiles.size(); ++n) {
    const double time = profiles[n].time;
    const double from = n > 0 ? (profiles[n - 1].time + time) / 2 : time;
    const double to = n + 1 < profiles.size() ? (time + profiles[n + 1].time) / 2 : time;
    const Profile& now = profiles[n].profile;
    const std::vector<double> rise = rise_of_bed(first, now);
    for (std::size_t i = 0; i < now.x.size(); ++i) {
      if (std::isnan(rise[i])) continue;
      history.largest = std::max(history.largest, std::abs(rise[i]));
      table.add_row(
          {csv_number(now.x[i]), csv_number(time), csv_number(from), csv_number(to), fmt::format("{:.6g}", rise[i])});
    }
  }
  if (table.rows() == 0) return history;  // the plane of the profiles has no bed
  table.write(file);
  history.times = profiles.size();
  return history;
}

}  // namespace thalweg
