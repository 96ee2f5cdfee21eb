#pragma once

#include <deque>
#include <span>
#include <vector>

#include "gencase/filling.hpp"

namespace thalweg::gencase {

/// Density [kg/m^3] at which the solver's equation of state (physics/water/equation_of_state.hpp) gives `pressure`
/// [Pa].
double hydrostatic_density(double density_at_rest, double pressure, double sound_speed);

/// Pressure of fluid at rest on a filled lattice. Along each column of nodes it is the weight of the fluid above,
/// summed from the free surface down. Fluid under a wall, such as a pipe, gets the pressure of the nearest connected
/// fluid at the same height. Fluid that walls enclose on all sides starts from zero at its highest point.
class HydrostaticStart {
 public:
  /// `gravity` [m/s^2] along the lattice's columns, signed; 0 makes every pressure 0.
  HydrostaticStart(const Filling& filling, const std::vector<PlacedShape>& shapes, double gravity);

  /// Writes the pressures [Pa] of one column, 0 at nodes without fluid. `pressures` has one entry per node.
  void column(std::int64_t column, std::span<double> pressures) const;

  /// Height of the fluid of these roles along the columns, from its lowest to its highest point [m].
  [[nodiscard]] double fluid_height(const std::vector<ShapeRole>& roles) const;

 private:
  /// Consecutive fluid nodes of one column; `top` and `bottom` count downward.
  struct Run {
    std::int64_t column;
    std::int64_t top;
    std::int64_t bottom;          // last node
    double surface_pressure = 0;  // [Pa] at the upper face of the top node
    bool known = false;           // true once surface_pressure is set
  };

  [[nodiscard]] Label label(std::int64_t column, std::int64_t below_top) const;
  [[nodiscard]] double weight(std::int64_t column, std::int64_t below_top) const;  // [Pa] of one node
  [[nodiscard]] double weight_above_centre(const Run& run, std::int64_t node) const;
  [[nodiscard]] bool is_fluid(std::int64_t column, std::int64_t below_top) const {
    return fluid_density_[label(column, below_top)] > 0;
  }
  void find_runs();
  void connect_runs();                         // finds the pressure of covered runs
  void spread(std::deque<std::size_t> known);  // from known runs to connected ones

  const Filling& filling_;
  const std::vector<PlacedShape>& shapes_;
  double gravity_;
  std::vector<double> fluid_density_;   // at rest, per label; 0: no fluid
  std::vector<Run> runs_;               // column by column, from the top down
  std::vector<std::size_t> first_run_;  // per column, and one more
};

}  // namespace thalweg::gencase
