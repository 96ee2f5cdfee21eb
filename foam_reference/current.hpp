#pragma once

#include "foam_reference/case_files.hpp"
#include "foam_reference/openings.hpp"

namespace thalweg::foam {

/// A current in equilibrium with its bed.
struct Current {
  double depth = 0;              // [m]
  double mean_velocity = 0;      // [m/s]
  double friction_velocity = 0;  // [m/s]
};

/// The current that the case drives, or the largest that its first inlet brings; all 0 without either. Its walls have
/// the roughness that the particles' current has (case/models/driven_flow.hpp).
Current current_of(const FoamCase& foam_case);

/// The largest current through an inlet, over ground of its `roughness`.
Current current_of(const FoamCase& foam_case, const OpeningPatch& inlet);

/// Kinematic viscosity of the water [m^2/s].
double kinematic_viscosity(const Case& scene);

/// k [m^2/s^2] and omega [1/s] at a height z [m] over the bed of a current of the depth H with the friction velocity u*.
/// They hold the shear stress u*^2 (1 - z/H) in equilibrium with its eddy viscosity kappa u* z (1 - z/H) (Nezu and
/// Nakagawa 1993): k = u*^2 (1 - z/H)/sqrt(C_mu), omega = u*/(sqrt(C_mu) kappa z), C_mu = 0.09. Near the surface the
/// stress is taken as a tenth of the bed's, so that k does not vanish.
struct EddyState {
  double k = 0;
  double omega = 0;
};
EddyState eddies_at(const Current& current, double z);

/// Files of the drive around a period: constant/fvOptions; none without a drive. `more`: entries of other options.
std::string drive_entries(const FoamCase& foam_case);

/// Name of the drive among the options, and of its folder in postProcessing.
inline constexpr const char* drive_name = "drive";

}  // namespace thalweg::foam
