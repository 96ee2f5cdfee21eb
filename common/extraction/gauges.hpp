#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "common/csv.hpp"
#include "common/particles.hpp"

namespace thalweg {

/// The readings of a case's gauges at one time.
struct GaugeRow {
  std::vector<double> values;      // one for each of gauge_columns(), NaN where there was nothing to measure
  std::vector<std::string> notes;  // the reasons for NaN: "p1: no fluid in reach"
};

/// The columns of gauges.csv between time and note, in the order of the case's gauges.
std::vector<CsvColumn> gauge_columns(const Case& of);

/// The heading line of gauges.csv: time, gauge_columns(), note.
std::string gauge_heading_line(const Case& of);
/// A row of gauges.csv; `time` [s] with all its digits.
std::string gauge_line(double time, const GaugeRow& row);

/// The boxes [m] that hold the particles read_gauges() needs from a set with these facts: one for each gauge, infinite
/// in some directions. Other particles may be left out of its set.
std::vector<Eigen::AlignedBox3d> gauge_regions(const Case& of, const ParticleFileInfo& info);

/// Measures a particle set, which has to say its facts (ParticleSet::info), on the host.
///
/// water level: extract_profile() of the particles around the column, linear between its columns. A sheet of water
/// counts that rides up to three spacings above the bed; a drop does not.
/// pressure, velocity: moving least squares of first order over the particles in the kernel's reach, that is the value,
/// at the gauge, of the plane that fits them best; exact for hydrostatic pressure, also at a wall. It is the weighted
/// mean if the particles lie too unevenly for a plane. With model.seepage = "mixture" of the water alone.
/// flux: the sum of V u over the particles within the kernel's reach 2h of the plane, weighted by (1 - d/2h)/2h with
/// their distance d.
GaugeRow read_gauges(const Case& of, const ParticleSet& particles);

}  // namespace thalweg
