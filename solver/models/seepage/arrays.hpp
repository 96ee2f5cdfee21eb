#pragma once

#include "solver/state/arrays.hpp"
#include "solver/state/particles.hpp"

namespace thalweg {

namespace field {
inline constexpr Field pores{"Pores"};
}

/// The other set of a mixture, as a particle knows it.
struct PoreState {
  float porosity;  // n [-], 1 away from grains
  float exchange;  // of water: drag coefficient of a pair over both tiles and W [kg m^dim/(m^3 s)]
};

/// Arrays of the mixture; empty without it. Every step computes them anew.
template <class Device>
struct SeepageArrays {
  typename Device::template Buffer<PoreState> pores;

  template <class Scene, class Visitor>
  void describe(const Scene&, Visitor& v) {
    v.array(field::pores, pores, halo, PoreState{1, 0});
    v.shown("Porosity", pores, &PoreState::porosity, {.fluid_only = true, .otherwise = 1});
  }
};

}  // namespace thalweg
