#pragma once

#include <cstddef>
#include <vector>

#include "solver/state/report.hpp"

namespace thalweg {

/// A column of the bed on the device.
struct BedColumn {
  float from = 0;       // [m] level of the bed's surface before its motion
  float to = 0;         // [m] and after; the same while it stands still
  float floor = 0;      // [m] ground under the bed
  float slope[2] = {};  // of the surface after the motion, along x and y [-]
  float shear = 0;      // [Pa] mean of the last window
  float rows = 0;       // of particles in the column
};

/// Shear stress on a column, summed over time.
struct ColumnShear {
  double x = 0;     // [Pa s]
  double y = 0;     // [Pa s]
  double time = 0;  // [s]
};

/// The bed on the host: it gathers the water's shear stress in windows of time, and moves the surface between them. Made
/// from a case (make_surface_bed.hpp); the steps know it through this.
class SurfaceBed {
 public:
  virtual ~SurfaceBed() = default;

  [[nodiscard]] virtual const std::vector<BedColumn>& columns() const = 0;
  [[nodiscard]] virtual bool is_moving() const = 0;
  /// Time [s] at which something is due: the stress gathered so far, or the end of the motion.
  [[nodiscard]] virtual double due() const = 0;
  /// Share of its way that the surface has gone at a time [s], 0 to 1.
  [[nodiscard]] virtual double share_at(double time) const = 0;
  /// Its rate [1/s].
  [[nodiscard]] virtual double rate_at(double time) const = 0;
  /// Grains that the water took from each column since the last call [m^3], less those that settled on it.
  virtual void lift(const std::vector<double>& grains) = 0;
  /// Takes the sums since the last call and decides, at a time [s]: gather on, or move.
  virtual void take(const std::vector<ColumnShear>& sums, double time) = 0;
  /// The motion is at its end, at a time [s].
  virtual void arrive(double time) = 0;
  /// Time of the bed [s]: what its changes stand for.
  [[nodiscard]] virtual double bed_time() const = 0;
  [[nodiscard]] virtual BedReport report() const = 0;
  /// Mean shear stress of the last window on the bed that an inlet's water meets first [Pa]; 0 before there is one.
  /// inlet: its number in the case.
  [[nodiscard]] virtual double stress_at_inlet(std::size_t inlet) const = 0;

  /// All that a checkpoint needs (make_surface_bed.hpp reads it).
  [[nodiscard]] virtual std::vector<double> numbers() const = 0;
};

/// Numbers a column that follow those of the bed in a checkpoint: a ColumnShear, and grains that the water took. A flag
/// is the last.
inline constexpr std::size_t numbers_of_sums = 4;

/// Name of the bed's numbers in a checkpoint (ParticleSet::facts).
inline constexpr const char* surface_bed_fact = "SurfaceBed";

}  // namespace thalweg
