#pragma once

#include <cmath>

#include "physics/host_device.hpp"

namespace thalweg {

/// Viscosity [Pa s] of water with the volume share C [-] of sediment in suspension, Vand 1948 (J. Phys. Chem. 52,
/// 277-299), the paper's (24):
///   mu = mu_w exp[2.5 C/(1 - 39 C/64)]
/// mu_w viscosity of the water [Pa s]. The 2.5 is Einstein's coefficient; the paper misprints it as 0.5, which gives
/// 1.20 instead of 2.504 at C = 0.3. mu/mu_w at C = 0.1, 0.2, 0.3: 1.305, 1.767, 2.504.
/// Limits: for dilute to moderate suspensions. C is taken within [0, 0.6]: above, the grains touch and the formula has
/// no meaning, long before its pole at C = 64/39.
template <class Real>
HOST_DEVICE inline Real suspension_viscosity(Real water_viscosity, Real volume_share, Real einstein = Real(2.5)) {
  using std::exp;
  const Real above = volume_share > 0 ? volume_share : Real(0);
  const Real C = above < Real(0.6) ? above : Real(0.6);
  return water_viscosity * exp(einstein * C / (1 - Real(39.0 / 64.0) * C));
}

}  // namespace thalweg
