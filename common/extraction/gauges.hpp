#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "common/csv.hpp"
#include "common/particles.hpp"

namespace thalweg {

/// What the gauges of a case measured at one time.
struct GaugeRow {
  std::vector<double> values;      // one for each of gauge_columns(), NaN where there was nothing to measure
  std::vector<std::string> notes;  // why not: "p1: no fluid in reach"
};

/// The columns of gauges.csv between time and note, in the order of the case's gauges.
std::vector<CsvColumn> gauge_columns(const Case& of);

/// The heading of the column `note`, and of the time.
std::string gauge_heading_line(const Case& of);
/// A row of gauges.csv; `time` [s] with all its digits.
std::string gauge_line(double time, const GaugeRow& row);

/// Where the particles lie that read_gauges() looks at, of a set with these facts [m]: a box for each gauge, infinite
/// in some directions. Other particles may be left out of its set.
std::vector<Eigen::AlignedBox3d> gauge_regions(const Case& of, const ParticleFileInfo& info);

/// Measures a particle set, which has to say its facts (ParticleSet::info), on the host.
///
/// water level: extract_profile() of the particles around the column; linear between its columns. pressure, velocity:
/// of the particles in reach of the kernel, the value at the place of the plane through them that is best in the
/// weighted least squares (moving least squares of first order, exact for hydrostatic pressure also at a wall); the
/// weighted mean where they lie too unevenly for a plane. With model.seepage = "mixture" of the water alone. flux: the
/// sum of V u over the particles within the kernel's reach 2h of the plane, weighted by (1 - d/2h)/2h with their
/// distance d.
GaugeRow read_gauges(const Case& of, const ParticleSet& particles);

}  // namespace thalweg
