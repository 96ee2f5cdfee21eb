#pragma once

#include <array>

#include "case/models/shifting.hpp"
#include "case/tables/table.hpp"
#include "physics/water/viscosity_treatment.hpp"

namespace thalweg {

/// The precision of the sums over pairs; that of what is kept of a particle is the same in both.
enum class Precision { single_sums, double_sums };

inline constexpr std::array<Choice<Precision>, 2> choices(Precision) {
  return {{{Precision::single_sums, "single", "32 bits; distances are exact first"},
           {Precision::double_sums, "double",
            "64 bits, on CPU cores only: to see what single precision costs in accuracy and gains in time"}}};
}

/// A level of accuracy. It sets the defaults of other keys of the table: numerics_at().
enum class Accuracy { draft, standard, fine };

inline constexpr std::array<Choice<Accuracy>, 3> choices(Accuracy) {
  return {{{Accuracy::draft, "draft", "cfl = 0.7, acoustic_damper = 0.15, sound_speed_factor = 7"},
           {Accuracy::standard, "standard", "the defaults of this table"},
           {Accuracy::fine, "fine", "sound_speed_factor = 20"}}};
}

inline constexpr std::array<Choice<ViscosityTreatment>, 3> choices(ViscosityTreatment) {
  return {{{ViscosityTreatment::implicit, "implicit", "solved for at the end of the step"},
           {ViscosityTreatment::explicit_steps, "explicit", "explicit, with steps 50 to 400 times shorter"},
           {ViscosityTreatment::capped, "capped",
            "explicit, the viscosity cut to what the acoustic step can take: the bed creeps"}}};
}

/// [numerics]: discretisation and time steps.
struct Numerics {
  static constexpr TableHeading heading{"numerics", "How it is computed."};

  Accuracy accuracy = Accuracy::standard;
  double spacing = required;           // [m]
  double smoothing_ratio = 1.5;        // [-] h / spacing
  double sound_speed_factor = 10;      // [-]
  double maximum_speed = 0;            // [m/s]; 0: 2 sqrt(g H)
  double cfl = 0.5;                    // [-]
  double density_diffusion = 0.1;      // [-]
  double artificial_viscosity = 0.02;  // [-]
  double acoustic_damper = 0.5;        // [-]
  ViscosityTreatment viscosity = ViscosityTreatment::implicit;
  double viscous_tolerance = 1e-3;  // [-]
  int viscous_iterations = 1000;
  double list_skin = 0.15;       // [-]
  double excluded_limit = 1e-3;  // [-]
  Precision precision = Precision::single_sums;
  Shifting shifting = Shifting::automatic;  // off or on as soon as the case has been read

  template <class V>
  void describe(V& v) {
    v.choice("accuracy", accuracy,
             "Sets the defaults of other keys of this table; what each level costs and gives is measured in "
             "docs/speed-against-error.md. The spacing decides more than any of them.");
    v.quantity("spacing", spacing, "m", 1e-6, 100, "Distance of the particles at the start (dp).");
    v.number(
        "smoothing_ratio", smoothing_ratio, 1.1, 3,
        "Smoothing length over spacing. Where it is not given it is 1.5, and 2 in plane scenes of water alone, which "
        "are more exact with it at 1.15 times the cost (docs/speed-against-error.md), and in driven flows ([flow]).");
    v.number("sound_speed_factor", sound_speed_factor, 5, 100,
             "Sound speed over maximum_speed; 10 keeps density within 1 %.");
    v.quantity("maximum_speed", maximum_speed, "m/s", 0, 1000,
               "Largest speed expected, from which the sound speed follows; 0: 2 sqrt(g H), H the height of the fluid "
               "at the start.");
    v.number("cfl", cfl, 0.01, 0.8,
             "Courant number of the acoustic and force time steps. Errors do not depend on it "
             "(docs/speed-against-error.md), but near 0.7 splashes begin to gain energy. The acoustic damper is stable "
             "to 0.7 and diverges at 1.0; so more than 0.8 is refused.");
    v.number("density_diffusion", density_diffusion, 0, 1, "Delta of the density diffusion (Fourtakas et al. 2019).");
    v.number("artificial_viscosity", artificial_viscosity, 0, 1,
             "Alpha of the artificial viscosity between approaching particles of one phase. Where it is not given it "
             "is 0.02, and 0.1 in plane scenes of water alone and in driven flows. From smoothing_ratio 1.9 on it acts "
             "only where the flow is compressed or disordered, not in shear, vortices and waves (docs/theory.md).");
    v.number(
        "acoustic_damper", acoustic_damper, 0, 1,
        "Factor of the acoustic damper, a bulk viscosity of c h that quiets sound and leaves flow alone. With 0.5 it "
        "is stable for particles in any order at a Courant number of 0.5; with more, knots of particles may burst.");
    v.choice("viscosity", viscosity, "How the viscosity of the sediment is advanced in time.");
    v.number("viscous_tolerance", viscous_tolerance, 1e-8, 0.1,
             "Residual at which the implicit viscosity stops, over the momentum one step of gravity gives.");
    v.integer("viscous_iterations", viscous_iterations, 1, 1000000,
              "Iterations after which the implicit viscosity tries again with less, and in the end stops the run.");
    v.number("list_skin", list_skin, 0, 1,
             "Reach of the neighbour list beyond the kernel's support, over the support.");
    v.number("excluded_limit", excluded_limit, 0, 1,
             "Share of the fluid particles that may leave the domain before the run stops with an error.");
    v.choice("precision", precision, "Precision in which a particle's sums over its neighbours are computed.");
    v.choice("shifting", shifting, "How the particles of sheared water are kept in order.");
  }

  /// A level of accuracy sets the defaults of other keys. Throws InputError when it is asked of a resolved case.
  void set_defaults(const GivenWords& given);
  void complete(const Case& whole);
  void check(const Case& whole, const CheckContext& at) const;
};

/// The defaults of the numerics at a level of accuracy.
Numerics numerics_at(Accuracy accuracy);

}  // namespace thalweg
