#include <cmath>

#include "common/app/scour/quantities.hpp"
#include "physics/transport/bed_shear.hpp"
#include "physics/transport/critical_shields.hpp"
#include "physics/transport/friction_velocity.hpp"
#include "physics/transport/lift_settling.hpp"
#include "physics/water/von_karman.hpp"

namespace thalweg {
namespace {

/// Roughness of a flat bed for skin friction, over the grain diameter [-].
constexpr double roughness_over_grain = 2.5;
/// Height over the depth at which the logarithmic law has its mean velocity [-]: 1/e.
constexpr double height_of_mean = 0.36787944117144233;

/// Mean velocity [m/s] of a logarithmic profile with a friction velocity [m/s] in a depth [m].
double mean_velocity(double friction_velocity, double depth, double viscosity, double roughness) {
  const double origin = log_law_origin(friction_velocity, viscosity, roughness);
  return friction_velocity / von_karman<double> * std::log(height_of_mean * depth / origin);
}

void derive_flow(Inputs& in) {
  const double viscosity = in.value("viscosity") / in.value("water-density");
  const double roughness = roughness_over_grain * in.value("grain");
  if (in.has("slope") && in.has("depth")) {
    in.set_if_unknown("friction-velocity", std::sqrt(in.value("gravity") * in.value("depth") * in.value("slope")),
                      "sqrt(g depth slope)");
  }
  if (in.has("jet-velocity") && in.has("jet-opening")) {
    in.set_if_unknown("discharge", in.value("jet-velocity") * in.value("jet-opening"), "jet-velocity jet-opening");
  }
  if (in.has("discharge") && in.has("depth"))
    in.set_if_unknown("velocity", in.value("discharge") / in.value("depth"), "discharge/depth");
  if (in.has("slope") && in.has("depth") && in.has("grain")) {
    const double speed = mean_velocity(in.value("friction-velocity"), in.value("depth"), viscosity, roughness);
    if (speed > 0) in.set_if_unknown("velocity", speed, "logarithmic law");
  }
  if (in.has("velocity") && in.has("depth")) {
    in.set_if_unknown("discharge", in.value("velocity") * in.value("depth"), "velocity depth");
    if (in.has("grain")) {
      const double height = height_of_mean * in.value("depth");
      in.set_if_unknown("friction-velocity",
                        friction_velocity(in.value("velocity"), height, viscosity, roughness).friction_velocity,
                        "logarithmic law, ks = 2.5 d50");
    }
  }
}

void derive_grains(Inputs& in) {
  if (!in.has("grain")) return;
  const double d = in.value("grain");
  const double density = in.value("water-density");
  const double viscosity = in.value("viscosity") / density;
  in.set_if_unknown("grain-90", d, "d50");
  const double d_star =
      dimensionless_diameter(d, in.value("grain-density"), density, in.value("gravity"), in.value("viscosity"));
  in.set_if_unknown("settling-velocity", settling_velocity(d_star, d, viscosity), "Soulsby");
  // The law takes the grain Reynolds number of the threshold itself: a fixed point.
  const double weight = grain_weight_stress(in.value("grain-density"), density, in.value("gravity"), d);
  double shields = 0.05;
  for (int round = 0; round < 20; ++round)
    shields = critical_shields_number(std::sqrt(shields * weight / density) * d / viscosity);
  in.set_if_unknown("critical-shields", shields, "Shields' curve");
}

}  // namespace

void derive(Inputs& in) {
  in.set_if_unknown("gravity", 9.81, "default");
  in.set_if_unknown("water-density", 1000, "default");
  in.set_if_unknown("viscosity", 1e-3, "default");
  in.set_if_unknown("grain-density", 2650, "default: quartz");
  derive_flow(in);
  derive_grains(in);
  if (const KnownValue* const depth = in.find("depth")) {
    in.set_if_unknown("tailwater", depth->value, depth->origin);
    in.set_if_unknown("contracted-depth", depth->value, "as upstream");
  }
  in.set_if_unknown("flow-ratio", 1, "default");
  in.set_if_unknown("bed-factor", 1.1, "default");
  in.set_if_unknown("pier-angle", 0, "default");
  if (in.has("pier-width")) in.set_if_unknown("pier-length", in.value("pier-width"), "pier-width");
  in.set_if_unknown("pipe-gap", 0, "default");
}

}  // namespace thalweg
