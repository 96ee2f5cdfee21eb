#include "case/models/implementation.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <array>
#include <ostream>
#include <string>

#include "physics/sediment/sediment_parameters.hpp"
#include "physics/sediment/surface_fill.hpp"

namespace thalweg {
namespace {

/// One row of the differences: the paper as printed, the paper consistent with itself, and ours.
struct Reading {
  std::string subject;
  std::string paper;
  std::string consistent;
  std::string law = "as consistent";
};

std::array<Reading, 15> readings() {
  const SedimentParameters s;
  return {{
      {"yield coefficient K", "2 sin(phi)/(sqrt3 (3 - sin(phi))), the coefficient of I1 used on p: 0.298 at 38 deg",
       "sin(phi), plane strain without dilation: 0.616 at 38 deg (model.yield_fit)"},
      {"cohesion term", "6 c cos(phi)/(sqrt3 (3 - sin(phi))); yield_fit = \"printed\": the misprint 6 c sin(phi)/...",
       "c cos(phi)"},
      {"pressure in the yield stress", "all of the pressure, water included (model.effective_pressure = \"total\")",
       "the weight under water of the sediment above (model.effective_pressure)"},
      {"density of the bed", "the grains' own, 1540 kg/m^3 (materials.NAME.bed_density)", "by the porosity"},
      {"viscosity", "the factor of the stress in (8), twice the viscosity that (7) needs", "half of that"},
      {"grain Reynolds number", "by the u* of (17) to (19), whatever (20) gives", "by the u* of the shear stress"},
      {"yielded sediment", "consistency 1.54 Pa s^n, flow index 1.8: a syrup, which hides the erosion law",
       "consistency 1.5e-3 Pa s, flow index 1: a light slurry, which lets it act"},
      {"bed shear stress", "rho (kappa du/2)^2, du summed over the water without dividing by its share",
       "rho u*^2 by the logarithmic law from the mean of the water in reach (model.bed_shear)",
       "as consistent, with the roughness z0 that knows no steps and the mean height of the logarithm; its reaction "
       "drags the water"},
      {"bed load", "a fluid that yields at the stress which moves its grains, buried ones at the last such stress",
       "a fluid that yields at the stress which moves its grains",
       "a drift of the surface over the bed below it, at the rate of model.bed_load whatever the spacing"},
      {"bed surface",
       fmt::format("sediment-only density sum below 1250 of 1540 kg/m^3, {} of a full bed", surface_fill_as_printed),
       fmt::format("below {} ({} for smoothing_ratio > {}); grains that move have to be buried by {} more",
                   surface_fill_narrow, surface_fill_wide, widest_narrow_kernel_of_states, surface_fill_hysteresis)},
      {"deposit to bed load", "shear stress above the critical one of the slope", "the same",
       "the same, cohesion added to the critical stress"},
      {"bed load to deposit", "none: bed load never consolidates",
       fmt::format("buried; or below {} of the critical stress and slower than {} sqrt(g d) for sqrt(d/g)",
                   s.deposition_stress, s.deposition_speed)},
      {"bed load to suspended",
       fmt::format("concentration <= {} and speed above the lift velocity", s.dilute_concentration),
       fmt::format(
           "concentration <= {}, stress above critical, velocity along the bed's normal above the lift velocity",
           s.dilute_concentration)},
      {"suspended to bed load",
       fmt::format("concentration > {} or speed below the settling velocity", s.dilute_concentration),
       fmt::format("concentration > {}; or slower than the settling velocity, sinking through the water, over bed load "
                   "or deposit",
                   s.dense_concentration)},
      {"viscosity in suspension", "water's times exp[0.5 C/(1 - 39 C/64)], C share of sediment particles",
       "water's times exp[2.5 C/(1 - 39 C/64)], C volume share of grains (Vand)"},
  }};
}

}  // namespace

void explain_implementations(std::ostream& to) {
  fmt::print(to, "What model.implementation changes (docs/theory.md, \"Three states\"):\n");
  for (const Reading& r : readings()) {
    fmt::print(to, "  {}\n    paper:      {}\n    consistent: {}\n    law:        {}\n", r.subject, r.paper,
               r.consistent, r.law);
  }
}

}  // namespace thalweg
