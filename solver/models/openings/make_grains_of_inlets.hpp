#pragma once

#include "case/case.hpp"
#include "physics/bed/grains.hpp"

namespace thalweg {

/// The grains that the water of inlets brings.
class GrainsOfInlets {
 public:
  explicit GrainsOfInlets(const Case& of);

  /// [kg/m^3] of a grain; 0 where water carries none.
  [[nodiscard]] double density() const { return density_; }
  /// Volume share of the grains at a height over the inlet's lower edge [m], in water of a depth [m] with a mean velocity
  /// [m/s] over a bed with a shear stress [Pa]; 0: as the inlet's profile makes it. Not of those that come back.
  [[nodiscard]] double concentration(const Inlet& inlet, double height, double depth, double velocity,
                                     double bed_stress) const;

 private:
  double viscosity_;              // [m^2/s]
  double density_ = 0;            // [kg/m^3]
  double settling_velocity_ = 0;  // [m/s] of one grain
  double reference_level_ = 0;    // [m] over the bed
  double grain_stress_ = 1;       // [-] share of the stress that moves grains
  Grains bed_;
};

}  // namespace thalweg
