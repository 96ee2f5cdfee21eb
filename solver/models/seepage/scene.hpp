#pragma once

namespace thalweg {

/// Parameters of the mixture: grains and pore water as two sets of particles in the same places.
struct MixtureScene {
  bool mixture = false;
  float solids_at_rest = 1;      // phi_0: share of the bed's volume that is grains [-]
  float grain_diameter = 0;      // [m]
  float skeleton_stiffness = 0;  // pressure of grain on grain over the compression of the packing [Pa]
};

template <int Dim>
struct SeepageScene {
  MixtureScene seepage;
};

/// Density at rest in particle files [kg/m^3]: mass over it is the space a particle takes, a grain's with its share of
/// the pores.
template <class Scene>
float density_in_files(const Scene& scene, float kind) {
  return scene.density_at_rest(kind) * (kind > 0.5F ? scene.seepage.solids_at_rest : 1.0F);
}

}  // namespace thalweg
