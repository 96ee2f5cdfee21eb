#pragma once

#include "physics/kernel.hpp"
#include "physics/water/equation_of_state.hpp"
#include "solver/state/lattice.hpp"
#include "solver/state/pair_geometry.hpp"

namespace thalweg {

/// Constants of a scene that every pass may need (single precision where a pair sum reads them).
template <int Dim>
struct FlowScene {
  Lattice<Dim> lattice;
  Vec<Dim, double> domain_from{};  // [m] particles outside are excluded
  Vec<Dim, double> domain_to{};    // [m]

  Vec<Dim, double> lattice_node{};  // [m] one node of the lattice the particles started on

  double spacing = 0;           // [m]
  double smoothing_length = 0;  // [m]
  double list_reach = 0;        // [m] support with skin
  WendlandC2<Dim, float> kernel{1.0F};
  float singularity = 0;  // eps = 0.01 h^2 [m^2]

  Vec<Dim, float> gravity{};       // [m/s^2]
  float sound_speed = 0;           // [m/s] the same in both phases
  double fast_wave = 1;            // speed of the fastest pressure wave over the sound speed [-]
  float water_density = 0;         // [kg/m^3] at rest
  float sediment_density = 0;      // [kg/m^3] at rest; of a mixture's grains, else of the bed as a whole
  float water_viscosity = 0;       // [Pa s]
  float diffusion = 0;             // 2 delta h c [m^2/s]
  float artificial_viscosity = 0;  // alpha c h [m^2/s]
  bool viscosity_switch = false;   // the artificial viscosity acts in compression and disorder only
  float acoustic_damping = 0;      // a c h [m^2/s]
  double cfl = 0;
  bool has_sediment = false;
  bool has_drift = false;  // particles may move faster than their velocity says: plus the work quad (models/bed_load)
  bool water_has_grains = false;  // water carries grains, whose mass it moves too (models/suspended_load)
  bool walls_move = false;        // some walls change their places (models/moving_walls, models/surface_bed)
  bool keeps_wall_shear = false;  // some model asks for the shear stress on walls (models/wall_stress)
  bool needs_near_walls = false;  // some model sums over the fluid with walls in reach (Particles::near_walls)

  HOST_DEVICE float density_at_rest(float kind) const { return kind > 0.5F ? sediment_density : water_density; }
  HOST_DEVICE float stiffness(float kind) const { return tait_stiffness(density_at_rest(kind), sound_speed); }
  /// Along direction k of the scene, from place b to place a [m].
  [[nodiscard]] HOST_DEVICE float distance(int k, std::int32_t a, std::int32_t b) const {
    return static_cast<float>(Lattice<Dim>::difference(a, b)) * lattice.quantum[k];
  }
  /// From place b to place a, each of three coordinates [m].
  [[nodiscard]] HOST_DEVICE Vec<Dim, float> separation(const std::int32_t* a, const std::int32_t* b) const {
    Vec<Dim, float> r{};
    for (int k = 0; k < Dim; ++k) r[k] = distance(k, a[axis<Dim>(k)], b[axis<Dim>(k)]);
    return r;
  }
  [[nodiscard]] HOST_DEVICE float support() const { return static_cast<float>(2 * smoothing_length); }
  [[nodiscard]] PairMetric<Dim> metric() const { return {lattice.quantum, kernel}; }
};

/// g . r [m^2/s^2], of numbers or of packs.
template <int Dim, class L>
HOST_DEVICE inline L gravity_dot(const FlowScene<Dim>& scene, const Vec<Dim, L>& r) {
  L sum = r[0] * L(scene.gravity[0]);
  for (int k = 1; k < Dim; ++k) sum = sum + r[k] * L(scene.gravity[k]);
  return sum;
}

/// A scene: FlowScene with the parameters of every model (models/all.hpp). Passed by value to a device.
template <int Dim>
struct Scene;

}  // namespace thalweg
