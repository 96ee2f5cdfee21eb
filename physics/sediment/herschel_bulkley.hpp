#pragma once

#include <cmath>

#include "physics/host_device.hpp"

namespace thalweg {

/// Apparent dynamic viscosity [Pa s] of a Herschel-Bulkley-Papanastasiou fluid (Papanastasiou 1987, J. Rheol. 31,
/// 385-404) at the shear rate gdot = sqrt(2 D:D) [1/s]:
///   eta = tau_y (1 - exp(-m gdot/2)) / gdot + k gdot^(n-1)
/// tau_y yield stress [Pa], m regularisation [s], k consistency [Pa s^n], n flow index [-].
/// Limits for gdot -> 0:
///   n = 1   tau_y m/2 + k
///   n > 1   tau_y m/2
///   n < 1   gdot is kept above 1e-6 1/s
/// tau_y = 0 and n = 1: k, a Newtonian fluid.
///
/// Derivation from the paper's (8), which is f1 in tau = f1 D, twice this viscosity: f1/2 with sqrt(II_D) = gdot/2
/// gives the first term; its power law, 2 mu |4 II_D|^((n-1)/2) = 2 mu gdot^(n-1), gives the second. DualSPHysics
/// raises gdot/2 to the power instead. That is a factor of 2^(n-1): the constants of the two are not interchangeable.
template <class Real>
HOST_DEVICE inline Real herschel_bulkley_viscosity(Real gdot, Real yield_stress, Real regularisation, Real consistency,
                                                   Real flow_index) {
  using std::expm1;
  using std::pow;
  const Real x = regularisation * gdot / 2;
  // (1 - e^-x)/x; the series keeps its digits where x underflows in the quotient.
  const Real decay = x < Real(1e-4) ? 1 - x / 2 : -expm1(-x) / x;
  const Real plastic = yield_stress * regularisation / 2 * decay;
  if (flow_index == 1) return plastic + consistency;
  const Real floor = flow_index < 1 ? Real(1e-6) : Real(0);
  return plastic + consistency * pow(gdot > floor ? gdot : floor, flow_index - 1);
}

}  // namespace thalweg
