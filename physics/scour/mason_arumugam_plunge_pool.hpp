#pragma once

#include <cmath>
#include <vector>

#include "physics/scour/limits.hpp"

namespace thalweg {

/// Inputs of mason_arumugam_depth() and mason_arumugam_model_depth().
struct MasonArumugamPlungePool {
  double discharge = 0;       // q [m^2/s], per width of the falling water
  double drop = 0;            // H [m], from the water level above to the tailwater's
  double tailwater = 0;       // h [m], depth of the tailwater over the bed
  double grain_diameter = 0;  // d [m], mean; 0.25 m for rock
  double gravity = 9.81;      // g [m/s^2]
};

/// Depth of the deepest point of the pool below a free jet [m], counted from the tailwater's surface, models and
/// prototypes:
///   D = K q^x H^y h^0.15/(g^0.30 d^0.10),   K = 6.42 - 3.10 H^0.10,  x = 0.60 - H/300,  y = 0.05 + H/200
/// The scour depth is D less h. Source: Mason & Arumugam 1985, J. Hydraul. Eng. 111(2), 220-235, fitted to 26
/// prototypes and 47 models. q = 0.1 m^2/s, H = 1 m, h = 0.2 m, d = 5 mm: 0.5652 m.
inline double mason_arumugam_depth(const MasonArumugamPlungePool& fall) {
  const double H = fall.drop;
  const double K = 6.42 - 3.10 * std::pow(H, 0.10);
  return K * std::pow(fall.discharge, 0.60 - H / 300) * std::pow(H, 0.05 + H / 200) * std::pow(fall.tailwater, 0.15) /
         (std::pow(fall.gravity, 0.30) * std::pow(fall.grain_diameter, 0.10));
}

/// The same for models alone: D = 3.27 q^0.60 H^0.05 h^0.15/(g^0.30 d^0.10), which is of the dimension of a length.
/// q = 0.1 m^2/s, H = 1 m, h = 0.2 m, d = 5 mm: 0.5525 m.
inline double mason_arumugam_model_depth(const MasonArumugamPlungePool& fall) {
  return 3.27 * std::pow(fall.discharge, 0.60) * std::pow(fall.drop, 0.05) * std::pow(fall.tailwater, 0.15) /
         (std::pow(fall.gravity, 0.30) * std::pow(fall.grain_diameter, 0.10));
}

/// Limits left of the general form: H from the least of the models, 0.325 m, to the greatest of the prototypes, 109
/// m.
inline std::vector<LimitLeft> limits_left(const MasonArumugamPlungePool& fall) {
  return Limits().between("H [m]", fall.drop, 0.325, 109).left();
}

/// Limits left of the form for models: H from 0.325 m to 2.15 m, q from 0.015 to 0.42 m^2/s, d from 1 to 28 mm.
inline std::vector<LimitLeft> limits_left_of_models(const MasonArumugamPlungePool& fall) {
  return Limits()
      .between("H [m]", fall.drop, 0.325, 2.15)
      .between("q [m^2/s]", fall.discharge, 0.015, 0.42)
      .between("d [mm]", 1e3 * fall.grain_diameter, 1, 28)
      .left();
}

}  // namespace thalweg
