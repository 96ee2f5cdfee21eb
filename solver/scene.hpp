#pragma once

#include "solver/lattice.hpp"
#include "solver/physics/equation_of_state.hpp"
#include "solver/physics/kernel.hpp"
#include "solver/record.hpp"
#include "solver/seepage_scene.hpp"

namespace thalweg {

/// Constants of the sediment as the passes use them.
struct SedimentScene {
  float yield_coefficient = 0;  // K [-]
  float yield_cohesion = 0;     // [Pa]
  float regularisation = 0;     // [s]
  float consistency = 0;        // [Pa s^n]
  float flow_index = 1;         // [-]
  float submerged_weight = 0;   // (rho_bed - rho_pore) g [N/m^3]
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
  double viscous_tolerance = 0;

  bool has_sediment = false;
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
  [[nodiscard]] float support() const { return static_cast<float>(2 * smoothing_length); }
};

}  // namespace thalweg
