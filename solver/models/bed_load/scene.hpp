#pragma once

#include "physics/transport/bed_load.hpp"
#include "physics/transport/slope_effect.hpp"

namespace thalweg {

/// Constants of the bed load and of the drag between bed and water.
struct BedLoadConstants {
  bool on = false;
  bool holds_surface = false;  // against the pressure of the water (hold.hpp)
  BedLoad law = BedLoad::meyer_peter_mueller;
  SlopeEffect slope_effect = SlopeEffect::friction;
  float scale = 0;             // sqrt((rho_s/rho_w - 1) g d^3) [m^2/s]
  float layer = 0;             // (1 - n) dp, grains of a surface particle over its area [m]
  float area = 0;              // dp^(dim-1), of a surface particle [m^(dim-1)]
  float contact = 0;           // sum of V W over half a layer of water [-]
  float saturation = 0;        // length over which the load adapts [m]
  float submerged_weight = 0;  // (rho_bed - rho_w) g [N/m^3]
};

/// Parameters of the model of bed load.
template <int Dim>
struct BedLoadScene {
  BedLoadConstants bed_load;
};

}  // namespace thalweg
