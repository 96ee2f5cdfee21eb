#pragma once

#include <cmath>

#include "physics/host_device.hpp"
#include "physics/sediment/sediment_parameters.hpp"
#include "physics/transport/bed_shear.hpp"

namespace thalweg {

/// Shields number [-] at which a flat bed begins to move, at grain Reynolds number R* = u* d/nu [-]; the paper's (16):
///   0.010595 ln R* + 0.110476/R* + 0.0027197   1 < R* <= 500
///   0.068                                      R* > 500
///   0.1                                        R* <= 1, where the fit grows without bound
/// A fit of Shields' curve, with the constants and the lower bound of SPHERA (Shields.f90). The pieces do not meet: the
/// fit gives 0.1132 at R* = 1 and 0.0688 at R* = 500. It is smallest at R* = 10.4, 0.03815; at R* = 100 it is 0.0526.
template <class Real>
HOST_DEVICE inline Real critical_shields_number(Real grain_reynolds) {
  using std::log;
  if (!(grain_reynolds > 1)) return Real(0.1);
  if (grain_reynolds > 500) return Real(0.068);
  return Real(0.010595) * log(grain_reynolds) + Real(0.110476) / grain_reynolds + Real(0.0027197);
}

/// The critical Shields number [-] that a sediment gives, as one or as a stress; 0: it gives none. Water density
/// [kg/m^3], gravity g [m/s^2].
inline double critical_shields_of(const SedimentParameters& s, double water_density, double gravity) {
  if (!(s.critical_stress > 0)) return s.critical_shields;
  return s.critical_stress / grain_weight_stress(s.grain_density, water_density, gravity, s.grain_diameter);
}

}  // namespace thalweg
