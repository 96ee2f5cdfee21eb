#pragma once

#include "physics/kernel.hpp"
#include "physics/no_slip.hpp"
#include "physics/sediment/effective_pressure.hpp"
#include "physics/sediment/material.hpp"
#include "physics/transport/bed_shear.hpp"
#include "physics/water/equation_of_state.hpp"
#include "physics/water/viscosity_treatment.hpp"
#include "solver/state/lattice.hpp"
#include "solver/state/record.hpp"
#include "solver/state/seepage_scene.hpp"

namespace thalweg {

/// Constants of the sediment as the passes use them: its law, and the effective pressure's.
struct SedimentScene : SedimentMaterial<float> {
  EffectivePressure effective_pressure = EffectivePressure::column;
  float submerged_weight = 0;   // (rho_bed - rho_pore) g [N/m^3]
  float pore_stiffness = 0;     // B_w [Pa], of the pressure from the equation of state
  float laplace_tolerance = 0;  // [Pa] change a sweep at which the iteration stops
};

/// Constants of erosion, suspension and settling as models/states/bed_states.hpp uses them.
template <int Dim>
struct ErosionScene {
  BedShear bed_shear = BedShear::log_law;
  bool as_printed = false;            // the paper's printed tests in place of the consistent ones
  float surface_fill = 0;             // sediment with less of its kernel filled by sediment is surface [-]
  float fill_hysteresis = 0;          // more than that, for grains that move [-]
  float diameter = 0;                 // d50 [m]
  float roughness = 0;                // ks [m]
  float grain_density = 0;            // [kg/m^3]
  float grain_weight = 0;             // (rho_s - rho_w) g d [Pa]
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

/// When sediment comes to rest and wakes again (models/rest/rest.hpp).
struct RestCriteria {
  float shear_rate = 0;       // [1/s] below which sediment is calm: 98 % of the yield stress
  float wake_shear_rate = 0;  // [1/s] above which it wakes: 99.8 % of the yield stress
  float speed = 0;            // [m/s] below which sediment is calm
  float time = 0;             // [s] for which it has to be
};

/// Everything about a scene that does not change while it runs, as the passes use it (single precision where a pair sum
/// reads it). Passed by value to a device.
template <int Dim>
struct Scene {
  Lattice<Dim> lattice;
  Vec<Dim, double> domain_from{};  // [m] particles outside are excluded
  Vec<Dim, double> domain_to{};    // [m]

  Vec<Dim, double> lattice_node{};  // [m] one node of the lattice the particles started on

  double spacing = 0;           // [m]
  double smoothing_length = 0;  // [m]
  double list_reach = 0;        // [m] support with skin
  WendlandC2<Dim, float> kernel{1.0F};
  float singularity = 0;  // eps = 0.01 h^2 [m^2]

  Vec<Dim, float> gravity{};         // [m/s^2]
  float sound_speed = 0;             // [m/s] the same in both phases
  float water_density = 0;           // [kg/m^3] at rest
  float sediment_density = 0;        // [kg/m^3] bed as a whole, at rest
  float water_viscosity = 0;         // [Pa s]
  float quarter_root_viscosity = 0;  // (mu_w/rho_w)^(1/4)
  bool wall_friction = false;        // of water
  float diffusion = 0;               // 2 delta h c [m^2/s]
  float artificial_viscosity = 0;    // alpha c h [m^2/s]
  double cfl = 0;
  bool two_pass = false;  // integrator
  NoSlip<Dim> no_slip;
  ViscosityTreatment viscosity = ViscosityTreatment::implicit;
  double viscous_tolerance = 0;
  int viscous_iterations = 1000;

  bool has_sediment = false;
  bool has_states = false;  // of sediment
  bool may_rest = false;    // sediment
  bool has_moving_walls = false;
  RestCriteria rest;
  ErosionScene<Dim> erosion;
  SedimentScene sediment;
  SeepageScene seepage;

  HOST_DEVICE float density_at_rest(float phase) const {
    return phase == phase_sediment ? sediment_density : water_density;
  }
  /// Density at rest in particle files, with which mass over density is the space a particle takes: a grain's with its
  /// share of the pores.
  [[nodiscard]] float density_in_files(float phase) const {
    return density_at_rest(phase) * (phase == phase_sediment ? seepage.solids_at_rest : 1.0F);
  }
  HOST_DEVICE float stiffness(float phase) const { return tait_stiffness(density_at_rest(phase), sound_speed); }
  /// Along direction k of the scene, from place b to place a [m].
  [[nodiscard]] HOST_DEVICE float distance(int k, std::int32_t a, std::int32_t b) const {
    return static_cast<float>(Lattice<Dim>::difference(a, b)) * lattice.quantum[k];
  }
  [[nodiscard]] HOST_DEVICE float support() const { return static_cast<float>(2 * smoothing_length); }
};

}  // namespace thalweg
