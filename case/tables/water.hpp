#pragma once

#include "case/tables/table.hpp"

namespace thalweg {

/// [materials.water]
struct WaterParameters {
  static constexpr TableHeading heading{"materials.water", "The water."};

  double density = 1000;    // [kg/m^3]
  double viscosity = 1e-3;  // [Pa s]

  template <class V>
  void describe(V& v) {
    v.quantity("density", density, "kg/m^3", 1, 20000, "Density at rest, at the surface.");
    v.quantity("viscosity", viscosity, "Pa s", 0, 1e3, "Dynamic viscosity.");
  }
};

}  // namespace thalweg
