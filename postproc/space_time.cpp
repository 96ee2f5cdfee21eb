#include "postproc/space_time.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>

#include "common/csv.hpp"
#include "common/whole_file.hpp"
#include "postproc/figure_look.hpp"
#include "postproc/figures.hpp"

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
  table.comments.emplace_back("bed minus the bed of the first time, from the run's profiles");
  for (std::size_t n = 0; n < profiles.size(); ++n) {
    const double time = profiles[n].time;
    const double from = n > 0 ? (profiles[n - 1].time + time) / 2 : time;
    const double to = n + 1 < profiles.size() ? (time + profiles[n + 1].time) / 2 : time;
    const Profile& now = profiles[n].profile;
    for (std::size_t i = 0, k = 0; i < now.x.size() && !now.bed.empty(); ++i) {
      constexpr double same_place = 1e-9;  // [m]
      while (k < first.x.size() && first.x[k] < now.x[i] - same_place) ++k;
      if (k == first.x.size() || std::abs(first.x[k] - now.x[i]) > same_place) continue;
      const double change = now.bed[i] - first.bed[k];
      if (std::isnan(change)) continue;
      history.largest = std::max(history.largest, std::abs(change));
      table.add_row(
          {csv_number(now.x[i]), csv_number(time), csv_number(from), csv_number(to), fmt::format("{:.6g}", change)});
    }
  }
  table.write(file);
  history.times = profiles.size();
  return history;
}

fs::path FigureWriter::space_time(const fs::path& table, const fs::path& front, const PictureFrame& frame,
                                  double spacing, double largest) const {
  const fs::path script = folder_ / "space_time.gp";
  write_whole_text(script, [&](std::ostream& stream) {
    fmt::print(stream, "# Draws space_time.png from the CSV files it names: gnuplot space_time.gp\n{}", figure_look);
    // Brown where the bed has risen, blue-green where it has sunk (ColorBrewer's BrBG). The boxes overlap by a tenth,
    // or the smoothing of their edges would draw a grid.
    fmt::print(
        stream,
        "set terminal pngcairo size 2000,820 font 'sans,13' fontscale 1.9 linewidth 2 noenhanced\n"
        "set output 'space_time.png'\nunset grid\nset xrange [{0:g}:{1:g}]\nset yrange [*:*] noextend\n"
        "set xlabel 'x  [m]' offset 0,0.4\nset ylabel 't  [s]' offset 1,0\n"
        "set cblabel 'bed risen or sunk  [mm]'\nset cbrange [{2:g}:{3:g}]\n"
        "set palette defined (-1 '#005a50', -0.5 '#5ab4ac', 0 '#f5f5f0', 0.5 '#d8a048', 1 '#54300a')\n"
        "set style fill solid noborder\nset key top left Left reverse samplen 2\n"
        "plot {4} using (column('x [m]')):(column('time [s]')):(column('x [m]')-{5:g}):(column('x [m]')+{5:g}):"
        "(column('from [s]')):(column('to [s]')):(1e3*column('change [m]')) with boxxyerror palette notitle, \\\n"
        "     {6} using (column('front [m]')):(column('time [s]')) with lines lw 1.6 lc rgb '#1a1a1a' "
        "title 'water front'\n",
        frame.x_from, frame.x_to, -1e3 * largest, 1e3 * largest, data(table), 0.55 * spacing, data(front));
  });
  return script;
}

}  // namespace thalweg
