#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "common/io/series.hpp"
#include "postproc/extraction_run.hpp"
#include "postproc/run_records.hpp"
#include "postproc/scour_record.hpp"

namespace thalweg {

/// The change of the whole bed over time. Volumes are per metre of width in 2-D [m^2].
struct ScourSeries {
  bool of_bed_time = false;        // `time` is that of a bed that is a surface, and not that of the water
  std::vector<double> time;        // [s]
  std::vector<double> scour;       // [m] deepest fall since the start
  std::vector<double> deposition;  // [m] highest rise
  std::vector<double> eroded;      // [m^3] where the bed fell
  std::vector<double> deposited;   // [m^3] where it rose
};

/// The series of a run's snapshots; empty without a bed.
ScourSeries series_of(const ExtractionRun& extraction);
/// The series of a bed that is a surface, from the columns in its snapshots, over the bed's time. Snapshots that cannot be
/// read are left out.
ScourSeries series_of_columns(const std::vector<SeriesEntry>& snapshots, const ScourRecord& record);
/// Writes time [s], scour [m], deposition [m], eroded [m^3], deposited [m^3]; in 2-D [m^2].
void write_series_table(const std::filesystem::path& file, const ScourSeries& series, int dimension);

/// The deepest scour of a run.
struct ScourAnswer {
  double depth = 0;                                            // [m] largest over the run
  double x = 0;                                                // [m]
  double y = 0;                                                // [m]
  double time = 0;                                             // [s] of the water
  double bed_time = std::numeric_limits<double>::quiet_NaN();  // [s] of a bed that is a surface
  double at_end = 0;                                           // [m] in the end, anywhere
};
/// Nothing without a bed.
std::optional<ScourAnswer> deepest_scour(const ExtractionRun& extraction, const ScourRecord& record);

/// The deepest scour of a run beside the main one, up to the latest time that both have.
struct ScourBeside {
  std::string label;   // "twice the spacing (20 mm)"
  double depth = 0;    // [m]
  double of_main = 0;  // [m]

  [[nodiscard]] double difference() const { return depth - of_main; }
};

/// Dependence of a run's depth on numerical choices: on the chance that parts equal runs, on spacing and factor. It is no
/// error against nature.
struct ScourBand {
  std::vector<ScourBeside> beside;
  bool spacing_varied = false;                                // by one of them
  double scatter = std::numeric_limits<double>::quiet_NaN();  // [m] of the bed of equal runs, root mean square

  [[nodiscard]] bool is_known() const;
  /// Largest of all differences [m].
  [[nodiscard]] double half_width() const;
};

/// From the runs in `coarser` and `slower` below the run's folder, and the scatter that the case tells.
ScourBand band_of(const RunFolder& run, const ScourSeries& series, const std::vector<ScourCheck>& checks,
                  const std::vector<Repeatability>& repeatability);

}  // namespace thalweg
