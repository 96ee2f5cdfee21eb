#pragma once

#include "physics/transport/pick_up.hpp"

namespace thalweg {

/// Constants of the suspended load that the water carries.
struct SuspendedLoadConstants {
  bool on = false;
  PickUp pick_up = PickUp::mastbergen;
  float settling_velocity = 0;  // of one grain in still water [m/s]
  float excess_density = 0;     // rho_s/rho_w - 1 [-]
  float packing = 0;            // 1 - n, share of grains in a bed [-]
  float reference_level = 0;    // over the bed, of the reference concentration [m]
  float diffusivity = 0;        // of grains in water without eddies [m^2/s]
  float schmidt = 1;            // eddy viscosity over the diffusivity of the grains [-]
  float area = 0;               // dp^(dim-1), of a surface particle [m^(dim-1)]
  float contact = 0;            // sum of V W over half a layer of water [-]
};

/// Parameters of the model of suspended load.
template <int Dim>
struct SuspendedLoadScene {
  SuspendedLoadConstants suspended_load;
};

}  // namespace thalweg
