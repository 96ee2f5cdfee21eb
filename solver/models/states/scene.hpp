#pragma once

#include "physics/transport/bed_shear.hpp"
#include "physics/vec.hpp"

namespace thalweg {

/// Constants of erosion, suspension and settling as models/states uses them.
template <int Dim>
struct ErosionScene {
  BedShear bed_shear = BedShear::log_law;
  bool as_printed = false;            // the paper's printed tests in place of the consistent ones
  bool by_law = false;                // bed load drifts at the rate of a law (models/bed_load)
  float surface_fill = 0;             // sediment with less of its kernel filled by sediment is surface [-]
  float fill_hysteresis = 0;          // more than that, for grains that move [-]
  float diameter = 0;                 // d50 [m]
  float roughness = 0;                // ks [m]
  float share_over_flat = 0;          // sum of V W of the water over a flat bed, at its surface [-]
  float rise_of_share = 0;            // height over the bed of a particle that stands out, over what it sees more [m]
  float grain_density = 0;            // [kg/m^3]
  float grain_weight = 0;             // (rho_s - rho_w) g d [Pa]
  float cohesion = 0;                 // that water has to overcome too [Pa]
  float gravity = 0;                  // [m/s^2]
  Vec<Dim, float> down{};             // unit
  float critical_shields = 0;         // [-]; 0: by the grain Reynolds number
  float lift_ratio = 0;               // eta [-]
  float dimensionless_diameter = 0;   // d* [-]
  float settling_velocity = 0;        // [m/s]
  float dilute = 0;                   // concentration up to which grains are lifted off [-]
  float dense = 0;                    // above which suspended ones are bed load again [-]
  float return_stress = 0;            // of the critical one, below which bed load may stop [-]
  float return_speed = 0;             // [m/s]
  float return_time = 0;              // [s]
  float solids_share = 0;             // 1 - porosity [-]
  float einstein_coefficient = 2.5F;  // of Vand's viscosity [-]
};

/// Parameters of the model of three states.
template <int Dim>
struct StatesScene {
  bool has_states = false;
  ErosionScene<Dim> erosion;
};

}  // namespace thalweg
