#pragma once

#include <cstddef>
#include <vector>

#include "case/case.hpp"
#include "solver/domain/population.hpp"
#include "solver/models/openings/openings.hpp"
#include "solver/models/openings/zone.hpp"

namespace thalweg {

/// Bed load that inlets bring, as the host keeps it: how fast their rows of particles go (feed.hpp), and who follows.
class BedFeeds {
 public:
  explicit BedFeeds(const Case& of);

  /// Adds an inlet, in the order of the case; zone.feeds tells whether it brings bed load.
  void add(const Inlet& inlet, const Zone& zone);
  /// Speeds of the rows [m/s], one for each inlet; 0 without a row.
  [[nodiscard]] const std::vector<double>& speeds() const { return speeds_; }

  /// Sets the speeds. waters: next to each opening; sediment [kg]: what has come in through each, less what has gone out;
  /// dt [s]: since the last call.
  void set_speeds(const std::vector<WaterAtOpening>& waters, const std::vector<double>& sediment, double dt);
  /// Bears the particles of the rows; once, at the start.
  void fill(Population& population);
  /// After a step of dt [s]: bears who follows. Returns the mass that has crossed the plane of inlet n [kg].
  [[nodiscard]] double advance(std::size_t n, double dt, Population& population);

  /// All that a checkpoint needs; and back from `next`, which moves on.
  void add_numbers(std::vector<double>& to) const;
  [[nodiscard]] std::size_t count_of_numbers() const;
  void restore(const double*& next);

 private:
  struct Row {
    Zone zone;
    InletBedLoad kind = InletBedLoad::none;
    double asked = 0;  // [m^2/s] of a fixed rate
    Index ranks = 1;   // particles side by side
    double rate = 0;   // [m^2/s] volume of grains per time and width
    double age = 0;    // [s] over which the rate is a mean
    double way = 0;    // [m] of the row since a particle crossed the plane
  };

  void bear(const Row& row, int layer, Population& population) const;

  double spacing_;  // [m]
  int dimension_;
  int layers_ = 0;      // particles of a row one behind the other
  double layer_ = 0;    // [m] volume of grains per area of the row
  double mass_ = 0;     // [kg] of a particle
  double density_ = 0;  // [kg/m^3] of the bed
  std::vector<Row> rows_;
  std::vector<double> speeds_;
  bool is_filled_ = false;
};

}  // namespace thalweg
