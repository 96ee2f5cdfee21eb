#pragma once

#include <filesystem>
#include <vector>

#include "foam_reference/case_files.hpp"

namespace thalweg::foam {

/// The fields of a run at one time that the velocity over the depth is made of.
struct WaterFields {
  std::vector<double> share;   // of water in the cells [-]
  std::vector<Vec3> velocity;  // [m/s]
};

/// The water's velocity over the depth at one place of a current, a mean over time (as postproc/velocity_stations.hpp).
struct SampledStation {
  double place = 0;              // [m] along the flow
  double ground = 0;             // [m] lower edge of the lowest cell with water
  double depth = 0;              // [m]
  double mean_velocity = 0;      // [m/s]
  double friction_velocity = 0;  // [m/s] of the logarithmic law with this mean velocity and depth
  std::vector<double> height;    // [m] over the ground, middles of rows of cells
  std::vector<double> velocity;  // [m/s]
  std::vector<double> law;       // [m/s]
};

/// Takes velocities at a quarter, half and three quarters of the way from the first inlet to the first outlet, or of the
/// block: the columns of cells within four spacings of the particles, and two cells at least; in 3-D over all the width.
class VelocitySampler {
 public:
  /// `centres`: of the cells [m].
  VelocitySampler(const FoamCase& foam_case, const std::vector<Vec3>& centres);

  /// Adds the fields of one time to the means.
  void add(const WaterFields& fields);

  /// The stations; those without water are left out. Rows that water fills to less than half are left out.
  [[nodiscard]] std::vector<SampledStation> stations() const;

 private:
  struct Row {
    double water = 0;     // [m^3] sum over columns and times
    double flow = 0;      // times velocity
    double capacity = 0;  // [m^3] of the cells
  };
  struct Place {
    double at = 0;
    std::vector<Row> rows;  // of cells, from the block's lowest
  };

  const FoamCase& foam_case_;
  int component_ = 0;
  double sign_ = 1;
  std::vector<Place> places_;
  std::vector<int> place_of_;  // of each cell; -1: none
  std::vector<std::size_t> row_of_;
};

/// Writes them as a table: place, height, velocity, law as the particles' table has them, and the station's ground,
/// depth, mean and friction velocity in each of its rows.
void write_stations(const std::filesystem::path& file, const std::vector<SampledStation>& stations);

}  // namespace thalweg::foam
