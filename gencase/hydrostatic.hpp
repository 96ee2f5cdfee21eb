#pragma once

#include <deque>
#include <span>
#include <vector>

#include "gencase/filling.hpp"

namespace thalweg::gencase {

/// Density [kg/m^3] at which Tait's equation gives `pressure` [Pa]:
///   p = (rho0 c^2 / 7) [(rho / rho0)^7 - 1]   =>   rho = rho0 (1 + 7 p / (rho0 c^2))^(1/7).
double hydrostatic_density(double density_at_rest, double pressure, double sound_speed);

/// Pressure of fluid at rest on a filled lattice: along each column of nodes the weights above a node add up from the
/// free surface down. Where a wall covers the fluid (under a pipe), the pressure is that of the nearest fluid at the
/// same height that is connected to it; fluid enclosed all around starts from zero at its highest point.
class HydrostaticStart {
 public:
  /// `gravity` [m/s^2] along the lattice's columns, signed; 0 makes every pressure 0.
  HydrostaticStart(const Filling& filling, const std::vector<PlacedShape>& shapes, double gravity);

  /// Fills in the pressures [Pa] of one column, 0 where there is no fluid. `pressures` has one entry per node.
  void column(std::int64_t column, std::span<double> pressures) const;

  /// Height of the fluid along the columns from its lowest to its highest point [m].
  [[nodiscard]] double fluid_height() const;

 private:
  /// Fluid nodes of one column without a gap; `top` and `bottom` count downward.
  struct Run {
    std::int64_t column;
    std::int64_t top;
    std::int64_t bottom;          // last node
    double surface_pressure = 0;  // [Pa] at the upper face of the top node
    bool known = false;
  };

  [[nodiscard]] Label label(std::int64_t column, std::int64_t below_top) const;
  [[nodiscard]] double weight(std::int64_t column, std::int64_t below_top) const;  // [Pa] of one node
  [[nodiscard]] double weight_above_centre(const Run& run, std::int64_t node) const;
  [[nodiscard]] bool is_fluid(std::int64_t column, std::int64_t below_top) const {
    return fluid_density_[label(column, below_top)] > 0;
  }
  void find_runs();
  void connect_runs();
  void spread(std::deque<std::size_t> known);

  const Filling& filling_;
  double gravity_;
  std::vector<double> fluid_density_;   // at rest, per label; 0: no fluid
  std::vector<Run> runs_;               // column by column, from the top down
  std::vector<std::size_t> first_run_;  // per column, and one more
};

}  // namespace thalweg::gencase
