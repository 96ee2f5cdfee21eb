#include "postproc/scour_summary.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "case/reader/case_file.hpp"
#include "common/csv.hpp"
#include "common/error.hpp"
#include "common/io/particle_file.hpp"
#include "postproc/bed_map.hpp"
#include "postproc/snapshots.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

void add_row(ScourSeries& series, double time, double scour, double deposition, double eroded, double deposited) {
  series.time.push_back(time);
  series.scour.push_back(scour);
  series.deposition.push_back(deposition);
  series.eroded.push_back(eroded);
  series.deposited.push_back(deposited);
}

/// The largest depth up to a time.
double deepest_until(const std::vector<double>& time, const std::vector<double>& depth, double until) {
  double deepest = 0;
  for (std::size_t n = 0; n < time.size(); ++n) {
    if (time[n] <= until + same_time) deepest = std::fmax(deepest, depth[n]);
  }
  return deepest;
}

std::optional<ScourBeside> coarser_run(const RunFolder& run, int times, const ScourSeries& series) {
  const RunFolder beside = run.coarser(times);
  const fs::path table_file = beside.profiles() / "series.csv";
  if (!fs::exists(beside.resolved_case()) || !fs::exists(table_file)) return std::nullopt;
  const CsvTable table = CsvTable::read(table_file);
  if (!table.has("scour")) return std::nullopt;
  const std::vector<double> time = table.numbers("time", "s");
  if (time.empty()) return std::nullopt;
  const double common = std::min(time.back(), series.time.back());
  const double spacing = read_case(beside.resolved_case()).numerics.spacing;
  return ScourBeside{fmt::format("{} times the spacing ({:g} mm)", times, 1e3 * spacing),
                     deepest_until(time, table.numbers("scour", "m"), common),
                     deepest_until(series.time, series.scour, common)};
}

}  // namespace

ScourSeries series_of(const ExtractionRun& extraction) {
  ScourSeries series;
  for (const BalanceSample& sample : extraction.balances) {
    if (!sample.balance) continue;
    const BedBalance& bed = *sample.balance;
    add_row(series, sample.time, bed.scour, bed.deposition, bed.eroded, bed.deposited);
  }
  return series;
}

ScourSeries series_of_columns(const std::vector<SeriesEntry>& snapshots, const ScourRecord& record) {
  ScourSeries series;
  series.of_bed_time = true;
  if (snapshots.empty() || record.time.empty()) return series;
  std::vector<std::optional<BedExtremes>> found(snapshots.size());
  const ParticleSet first = first_readable(snapshots);
  tbb::parallel_for(std::size_t{0}, snapshots.size(), [&](std::size_t n) {
    try {
      found[n] = extremes_of(map_of_columns(first, read_particles(snapshots[n].file)));
    } catch (const InputError&) {  // the pass over the snapshots has warned of it
    }
  });
  for (std::size_t n = 0; n < snapshots.size(); ++n) {
    if (!found[n]) continue;
    const double time = bed_time_at(record, snapshots[n].time);
    if (!series.time.empty() && !(time > series.time.back())) continue;  // no bed step since
    add_row(series, time, found[n]->scour, found[n]->deposition, found[n]->eroded, found[n]->deposited);
  }
  return series;
}

void write_series_table(const fs::path& file, const ScourSeries& series, int dimension) {
  const std::string volume = dimension == 2 ? "m^2" : "m^3";
  CsvTable table({{"time", "s"}, {"scour", "m"}, {"deposition", "m"}, {"eroded", volume}, {"deposited", volume}});
  table.comments.emplace_back(series.of_bed_time ? "time that the bed's changes stand for" : "time of the water");
  for (std::size_t n = 0; n < series.time.size(); ++n) {
    table.add_row({csv_number(series.time[n]), csv_number(series.scour[n]), csv_number(series.deposition[n]),
                   csv_number(series.eroded[n]), csv_number(series.deposited[n])});
  }
  table.write(file);
}

std::optional<ScourAnswer> deepest_scour(const ExtractionRun& extraction, const ScourRecord& record) {
  ScourAnswer answer;
  if (!record.time.empty()) {
    const auto deepest = std::max_element(record.depth.begin(), record.depth.end());
    const auto n = static_cast<std::size_t>(deepest - record.depth.begin());
    answer = {*deepest, record.x[n], record.y[n], record.water[n], record.time[n], record.depth.back()};
    return answer;
  }
  bool any = false;
  for (const BalanceSample& sample : extraction.balances) {
    if (!sample.balance) continue;
    const BedBalance& bed = *sample.balance;
    if (!any || bed.scour > answer.depth) {
      answer.depth = bed.scour;
      answer.x = bed.scour_at.x();
      answer.y = bed.scour_at.y();
      answer.time = sample.time;
    }
    answer.at_end = bed.scour;
    any = true;
  }
  return any ? std::make_optional(answer) : std::nullopt;
}

bool ScourBand::is_known() const { return !beside.empty() || !std::isnan(scatter); }

double ScourBand::half_width() const {
  double largest = std::isnan(scatter) ? 0 : scatter;
  for (const ScourBeside& run : beside) largest = std::max(largest, std::abs(run.difference()));
  return largest;
}

ScourBand band_of(const RunFolder& run, const ScourSeries& series, const std::vector<ScourCheck>& checks,
                  const std::vector<Repeatability>& repeatability) {
  ScourBand band;
  for (const ScourCheck& check : checks) {
    band.beside.push_back({check.label, check.depth, check.of_main});
    band.spacing_varied = band.spacing_varied || check.of_spacing;
  }
  if (checks.empty() && !series.of_bed_time && !series.time.empty()) {
    for (const int times : {2, 4, 8}) {
      if (auto beside = coarser_run(run, times, series)) band.beside.push_back(std::move(*beside));
    }
    band.spacing_varied = !band.beside.empty();
  }
  for (const Repeatability& known : repeatability) {
    if (known.curve == "bed") band.scatter = std::fmax(band.scatter, known.rms);
  }
  return band;
}

}  // namespace thalweg
