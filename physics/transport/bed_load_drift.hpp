#pragma once

#include <cmath>

#include "physics/host_device.hpp"

// Bed load as a drift of the bed's top layer of particles over the skeleton below: the layer of thickness dp holds
// (1 - n) dp of grains per area, so that the flux q of a law is its drift q/((1 - n) dp) whatever the spacing.
namespace thalweg {

/// Bed load across the flow over that along it, per slope across the flow [-]: 1.5 sqrt(theta_cr/theta), Ikeda 1982 (J.
/// Hydraul. Div. ASCE 108, 1369-1373) with the coefficient of van Rijn 1993. critical_over_stress theta_cr/theta, 0 to 1.
template <class Real>
HOST_DEVICE inline Real transverse_slope(Real critical_over_stress) {
  using std::sqrt;
  return Real(1.5) * sqrt(critical_over_stress);
}

/// Drift of the top layer [m/s] for the bed load q [m^2/s], at most the water's speed along the bed [m/s];
/// layer = (1 - n) dp > 0 [m].
template <class Real>
HOST_DEVICE inline Real bed_load_drift(Real flux, Real layer, Real water_speed) {
  const Real drift = flux / layer;
  return drift < water_speed ? drift : water_speed;
}

}  // namespace thalweg
