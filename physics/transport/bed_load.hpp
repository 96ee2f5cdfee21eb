#pragma once

#include <cmath>

#include "physics/host_device.hpp"
#include "physics/transport/engelund_fredsoe.hpp"
#include "physics/transport/meyer_peter_mueller.hpp"
#include "physics/transport/van_rijn_bed_load.hpp"
#include "physics/transport/wong_parker.hpp"

// Bed load: grains that roll and jump along a bed, as volume of grains without pores per second and metre of width
// [m^2/s]. Symbols: Shields numbers theta of the bed and theta_cr at its first motion [-]; grain diameter d [m];
// densities of grain rho_s and water rho_w [kg/m^3]; gravity g [m/s^2].
namespace thalweg {

/// Law for the bed load. Each has a header of its name.
///   meyer_peter_mueller   8 (theta - theta_cr)^1.5; the default
///   wong_parker           3.97 (theta - theta_cr)^1.5
///   engelund_fredsoe      for sands
///   van_rijn              for sands of 0.2 to 2 mm
enum class BedLoad { meyer_peter_mueller, wong_parker, engelund_fredsoe, van_rijn };

/// Unit of bed load, sqrt((rho_s/rho_w - 1) g d^3) [m^2/s] (Einstein). PVC of 3.5 mm, 1540 kg/m^3: 4.76577e-4 m^2/s.
template <class Real>
HOST_DEVICE inline Real bed_load_scale(Real diameter, Real grain_density, Real water_density, Real gravity) {
  using std::sqrt;
  return diameter * sqrt((grain_density / water_density - 1) * gravity * diameter);
}

/// Bed load over its unit [-] by a law; dimensionless diameter d* [-] (lift_settling.hpp).
template <class Real>
HOST_DEVICE inline Real bed_load(BedLoad law, Real shields, Real critical_shields, Real dimensionless_diameter) {
  switch (law) {
    case BedLoad::meyer_peter_mueller:
      return meyer_peter_mueller(shields, critical_shields);
    case BedLoad::wong_parker:
      return wong_parker(shields, critical_shields);
    case BedLoad::engelund_fredsoe:
      return engelund_fredsoe(shields, critical_shields);
    case BedLoad::van_rijn:
      return van_rijn_bed_load(shields, critical_shields, dimensionless_diameter);
  }
  return 0;
}

}  // namespace thalweg
