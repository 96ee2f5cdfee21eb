#pragma once

#include <cmath>

namespace thalweg {

/// Constants of a sediment as a case file gives them (SI, angles in rad). Defaults that differ from the source paper
/// are named where they differ; NAN marks what a case has to give. Source: Zhang, Xiong & Liu 2024, J. Hunan Univ.
/// (Nat. Sci.) 51(3), 69-80, called "the paper".
struct SedimentParameters {
  double grain_density = NAN;         // [kg/m^3]
  double porosity = NAN;              // [-]
  double grain_diameter = NAN;        // [m] d50
  double friction_angle = NAN;        // [rad]
  double cohesion = 0;                // [Pa]
  double suction = 0;                 // [Pa] of the pore water where the bed is out of the water
  double pore_density = 1000;         // [kg/m^3] of what fills the pores; 0 for a dry bed
  double consistency = 1.5e-3;        // [Pa s^n]
  double flow_index = 1;              // [-]
  double regularisation = 100;        // [s]
  double dynamic_friction_angle = 0;  // [rad] of mu(I)
  double inertial_number = 0.279;     // [-] I0 of mu(I)
  double roughness = 0;               // [m] ks; 0: the grain diameter
  double lift_ratio = 0.85;           // [-] lift over drag of a grain
  double critical_shields = 0;        // [-]; 0: by the grain Reynolds number
  double critical_stress = 0;         // [Pa] in its place; 0: by the Shields number
  double given_density = 0;           // [kg/m^3] of the bed as a whole; 0: by the porosity
  double oedometer_modulus = 1e6;     // [Pa]
  double critical_porosity = 0;       // [-]; 0: the packing keeps its porosity when it is sheared
  double dilatancy = 4.09;            // [-] tangent of the angle of dilatancy over the difference of shares of solids

  // Three states: when grains leave the bed load, and when they come back to it.
  double dilute_concentration = 0.312;  // [-]
  double dense_concentration = 0.33;    // [-]
  double deposition_stress = 0.8;       // [-] over the critical stress
  double deposition_speed = 0.01;       // [-] over sqrt(g d)

  // Rest: when calm sediment stops, and when it wakes. m is the regularisation, dp the particle spacing.
  double rest_shear = 8;                // [-] shear rate times m
  double rest_least_shear_rate = 0.01;  // [1/s]
  double rest_speed = 0.01;             // [-] over sqrt(g dp)
  double rest_time = 2;                 // [-] over sqrt(dp/g)
  double wake_shear = 1.5;              // [-] over the shear rate of rest

  /// Density of the bed as a whole, grains and what fills the pores [kg/m^3].
  [[nodiscard]] double bed_density() const {
    return given_density > 0 ? given_density : porosity * pore_density + (1 - porosity) * grain_density;
  }

  template <class Visitor>
  void describe(Visitor& v) {
    v.quantity("grain_density", grain_density, "kg/m^3", 1001, 30000,
               "Density of the grains themselves; Shields number and settling use this one.");
    v.number("porosity", porosity, 0, 0.95,
             "Share of the bed's volume that is pores; bed density = porosity * pore density + (1 - porosity) * grain "
             "density.");
    v.quantity("bed_density", given_density, "kg/m^3", 0, 30000,
               "Density of the bed as a whole, in place of the one that follows from the porosity; 0: that one. With "
               "implementation = \"paper\" the default is the grains' own, which the paper gives the bed.");
    v.quantity("grain_diameter", grain_diameter, "m", 1e-6, 0.5, "Median grain diameter d50.");
    v.quantity("friction_angle", friction_angle, "rad", 0, 1.2, "Angle of internal friction.");
    v.quantity("cohesion", cohesion, "Pa", 0, 1e7, "Cohesion: yield stress without any effective pressure.");
    v.quantity("suction", suction, "Pa", 0, 1e6,
               "Suction of the pore water where no water stands over the bed, which presses the grains of a wet bank "
               "together: 9.81 kPa for a metre above the water table; up to the capillary rise of the sediment.");
    v.quantity("pore_density", pore_density, "kg/m^3", 0, 2000,
               "Density of the fluid in the pores: water for a saturated bed (default), 0 for a dry one.");
    v.quantity("consistency", consistency, "Pa s", 0, 1e6,
               "Consistency of the yielded sediment (Herschel-Bulkley). Default 1.5e-3: a light slurry, so that "
               "erosion laws can act; the paper's is 0.001 m^2/s times the density.");
    v.number("flow_index", flow_index, 0.2, 3,
             "Exponent n of the yielded sediment: 1 Bingham (default), 1.8 in the paper.");
    v.quantity("regularisation", regularisation, "s", 1e-3, 1e6,
               "Papanastasiou's m: how sharply the viscosity rises below yield.");
    v.quantity("dynamic_friction_angle", dynamic_friction_angle, "rad", 0, 1.2,
               "rheology = \"mu-of-i\": friction angle of a fast flow; mu_2 follows from it as mu_s does from "
               "friction_angle.");
    v.number("inertial_number", inertial_number, 1e-6, 100,
             "rheology = \"mu-of-i\": inertial number at which friction is half-way between the two; 0.279 for glass "
             "beads.");
    v.quantity("roughness", roughness, "m", 0, 1,
               "Equivalent sand roughness ks of the bed, for the water's shear stress on it; 0: the grain diameter.");
    v.number("lift_ratio", lift_ratio, 0, 0.99, "Lift over drag of a grain on the bed (three-state).");
    v.number("critical_shields", critical_shields, 0, 1,
             "Shields number at which a flat bed begins to move; 0: by the grain Reynolds number.");
    v.quantity("critical_stress", critical_stress, "Pa", 0, 1000,
               "Shear stress at which a flat bed begins to move, measured, as for mud or clay: in place of "
               "critical_shields and cohesion; 0: by these.");
    v.quantity("oedometer_modulus", oedometer_modulus, "Pa", 1e3, 1e11,
               "Stiffness of the packing against compression, with which excess pore pressure drains "
               "(model.pore_pressure).");
    v.number(
        "critical_porosity", critical_porosity, 0, 0.95,
        "Porosity in which the packing flows steadily: a denser one opens when it is sheared and sucks water in, a "
        "looser one closes and presses it out (model.pore_pressure). 0: the porosity does not change.");
    v.number(
        "dilatancy", dilatancy, 0, 40,
        "With critical_porosity: tangent of the angle of dilatancy over the difference of the shares of solids; 4.09 "
        "for glass beads.");
    describe_states(v);
    describe_rest(v);
  }

 private:
  template <class Visitor>
  void describe_states(Visitor& v) {
    v.number(
        "dilute_concentration", dilute_concentration, 0, 1,
        "three-state: bed load is taken into suspension only where sediment, pores included, is at most this share "
        "of the fluid's volume. With implementation = \"paper\" suspended grains become bed load above it.");
    v.number("dense_concentration", dense_concentration, 0, 1,
             "three-state: suspended grains become bed load where sediment is more than this share of the fluid's "
             "volume; above dilute_concentration, so that grains do not change to and fro.");
    v.number("deposition_stress", deposition_stress, 0, 1,
             "three-state: bed load comes to rest on the bed only where the shear stress is below this share of the "
             "critical one.");
    v.number("deposition_speed", deposition_speed, 0, 10,
             "three-state: bed load comes to rest on the bed only where it is slower than this times sqrt(g d50).");
  }
  template <class Visitor>
  void describe_rest(Visitor& v) {
    v.number("rest_shear", rest_shear, 0, 1000,
             "model.rest: sediment is calm where its shear rate times `regularisation` is less; with 8 its stress is "
             "below 98 % of the yield stress.");
    v.quantity("rest_least_shear_rate", rest_least_shear_rate, "s^-1", 0, 1e3,
               "model.rest: sediment is calm below this shear rate, however sharp the regularisation is.");
    v.number("rest_speed", rest_speed, 0, 10,
             "model.rest: sediment is calm only if it is slower than this times sqrt(g dp), dp being the particle "
             "spacing.");
    v.number(
        "rest_time", rest_time, 0, 1e6,
        "model.rest: sediment stops after it has been calm for this times sqrt(dp/g); 2: the time in which a grain "
        "falls two spacings.");
    v.number("wake_shear", wake_shear, 1, 1000,
             "model.rest: sediment at rest wakes where the shear rate is above this times the one of calm sediment.");
  }
};

}  // namespace thalweg
