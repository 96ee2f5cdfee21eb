// 0.orig/k, omega, nut of the k-omega model, with wall functions of each wall's roughness.
#include <algorithm>
#include <cmath>

#include "foam_reference/current.hpp"
#include "foam_reference/dictionary.hpp"
#include "foam_reference/initial_fields.hpp"
#include "foam_reference/opening_conditions.hpp"
#include "foam_reference/wall_patches.hpp"
#include "physics/water/log_profile.hpp"

namespace thalweg::foam {
namespace {

// The law of the wall of the particle model, u+ = ln(z/z0)/kappa with z0 = 0.11 nu/u* + 0.033 ks, in the words of
// OpenFOAM's wall functions: kappa, and E = 1/0.11.
constexpr const char* law_of_wall = "kappa 0.41; E 9.09;";

// Eddies of a scene without a current that its numbers tell: a tenth of the speed of a wave, a tenth of the height.
Current otherwise(const FoamCase& foam_case) {
  const MeshPlan& plan = foam_case.plan;
  const double height = plan.high.z() - plan.low.z();
  const double speed = 0.1 * std::sqrt(foam_case.scene.domain.gravity.norm() * height);
  return {height, speed, 0.05 * speed};
}

}  // namespace

// nutkRoughWallFunction has 1 + Cs ks+ only above ks+ = 90; below it Ligrani & Moffat's transition,
//   ((ks+ - 2.25)/87.75 + Cs ks+)^sin(0.4258 (ln ks+ - 0.811)),
// which for sand's 0.3 lies up to a fifth below the law of the particles, 1 + 0.3 ks+ (Colebrook's transition, E = 1/0.11).
double roughness_constant(double roughness, double friction_velocity, double viscosity) {
  constexpr double sand = 0.033 / 0.11;
  constexpr double smooth = 2.25;  // below it the function is that of a smooth wall
  constexpr double rough = 90;
  constexpr double most = 1;  // end of its range
  const double ks_plus = roughness * friction_velocity / viscosity;
  if (ks_plus >= rough || ks_plus <= smooth) return sand;
  const double exponent = std::sin(0.4258 * (std::log(ks_plus) - 0.811));
  const double constant =
      (std::pow(1 + sand * ks_plus, 1 / exponent) - (ks_plus - smooth) / (rough - smooth)) / ks_plus;
  return std::min(constant, most);
}

CaseFiles turbulence_fields(const FoamCase& foam_case) {
  if (!foam_case.has_wall_functions()) return {};
  Current current = current_of(foam_case);
  if (!(current.friction_velocity > 0)) current = otherwise(foam_case);
  const EddyState eddies = eddies_at(current, 0.5 * current.depth);
  const double viscosity = kinematic_viscosity(foam_case.scene);

  const auto nut_at_walls = [&](const WallPatch& wall) -> std::string {
    if (!(wall.roughness > 0)) return std::string("type nutkWallFunction; ") + law_of_wall + " value uniform 0;";
    const double friction =
        friction_velocity_of_current(current.mean_velocity, current.depth, viscosity, wall.roughness);
    return "type nutkRoughWallFunction; Ks uniform " + number(wall.roughness) + "; Cs uniform " +
           number(roughness_constant(wall.roughness, friction, viscosity)) + "; " + law_of_wall + " value uniform 0;";
  };
  const std::string inwards = "type inletOutlet; inletValue $internalField; value $internalField;";
  CaseFiles files;
  files["0.orig/k"] = field_file(
      foam_case, "volScalarField", "k", "Kinetic energy of the eddies [m^2/s^2].", "[0 2 -2 0 0 0 0]", number(eddies.k),
      boundary(
          foam_case, [](const WallPatch&) { return "type kqRWallFunction; value $internalField;"; }, inwards,
          [&](const OpeningPatch& patch) { return k_at(foam_case, patch); }));
  files["0.orig/omega"] = field_file(
      foam_case, "volScalarField", "omega", "Frequency of the eddies [1/s].", "[0 0 -1 0 0 0 0]", number(eddies.omega),
      boundary(
          foam_case,
          [](const WallPatch&) {
            return std::string("type omegaWallFunction; ") + law_of_wall + " value $internalField;";
          },
          inwards, [&](const OpeningPatch& patch) { return omega_at(foam_case, patch); }));
  files["0.orig/nut"] = field_file(
      foam_case, "volScalarField", "nut",
      "Eddy viscosity [m^2/s]. Walls have the law of the wall, rough ones with Nikuradse's ks of their shape. Cs lets "
      "the\n"
      "wall function's transition meet 1 + 0.3 ks+ at the friction velocity that the case's current has on this wall.",
      "[0 2 -1 0 0 0 0]", "0",
      boundary(foam_case, nut_at_walls, "type calculated; value uniform 0;",
               [](const OpeningPatch&) { return "type calculated; value uniform 0;"; }));
  return files;
}

}  // namespace thalweg::foam
