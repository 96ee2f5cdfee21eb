// 0.orig: the fields before setFields fills the shapes, and their conditions at walls and open faces.
#include "foam_reference/initial_fields.hpp"

#include "foam_reference/dictionary.hpp"
#include "foam_reference/opening_conditions.hpp"

namespace thalweg::foam {
namespace {

std::string boundary_entry(const std::string& patch, const std::string& entries) {
  return "    " + patch + " { " + entries + " }\n";
}

}  // namespace

std::string boundary(const FoamCase& foam_case, const std::function<std::string(const WallPatch&)>& at_walls,
                     const std::string& at_open, const std::function<std::string(const OpeningPatch&)>& at_openings) {
  const MeshPlan& plan = foam_case.plan;
  std::string text;
  for (const WallPatch& wall : wall_patches(foam_case)) text += boundary_entry(wall.name, at_walls(wall));
  if (plan.open(Face::open)) text += boundary_entry("atmosphere", at_open);
  for (const OpeningPatch& patch : opening_patches(foam_case.scene)) {
    text += boundary_entry(patch.patch, at_openings(patch));
  }
  if (plan.open(Face::unused)) text += boundary_entry("frontAndBack", "type empty;");
  if (plan.open(Face::periodic)) text += boundary_entry("\"(minus|plus)[XYZ]\"", "type cyclic;");
  return text;
}

std::string field_file(const FoamCase& foam_case, const std::string& foam_class, const std::string& name,
                       const std::string& purpose, const std::string& dimensions, const std::string& value,
                       const std::string& patches) {
  return foam_file(foam_case.scene, foam_class, name, purpose,
                   substitute(R"(dimensions      %dimensions%;
internalField   uniform %value%;

boundaryField
{
%patches%}
)",
                              {{"dimensions", dimensions}, {"value", value}, {"patches", patches}}));
}

CaseFiles initial_fields(const FoamCase& foam_case) {
  const auto everywhere = [](const std::string& entries) { return [=](const auto&) { return entries; }; };
  const auto zero_gradient = everywhere("type zeroGradient;");
  CaseFiles files = turbulence_fields(foam_case);
  for (const std::string& phase : phases(foam_case)) {
    const std::string inflow = phase == "air" ? "1" : "0";
    if (phase == "air" && foam_case.application() == "interFoam") continue;  // interFoam has one share, the water's
    files["0.orig/alpha." + phase] = field_file(
        foam_case, "volScalarField", "alpha." + phase,
        "Volume share of " + phase + " [-]. What flows in through open faces is air.", "[0 0 0 0 0 0 0]", inflow,
        boundary(foam_case, zero_gradient,
                 "type inletOutlet; inletValue uniform " + inflow + "; value uniform " + inflow + ";",
                 [&](const OpeningPatch& patch) { return alpha_at(foam_case, patch); }));
  }
  if (foam_case.has_eroding_bed()) {
    const std::string open = "type inletOutlet; inletValue uniform 0; value uniform 0;";
    files["0.orig/bed"] =
        field_file(foam_case, "volScalarField", "bed", "Share of the cell that lies below the bed's surface [-].",
                   "[0 0 0 0 0 0 0]", "0", boundary(foam_case, zero_gradient, "type zeroGradient;", zero_gradient));
    files["0.orig/grains"] =
        field_file(foam_case, "volScalarField", "grains", "Volume share of suspended grains [-].", "[0 0 0 0 0 0 0]",
                   "0", boundary(foam_case, zero_gradient, open, everywhere(open)));
  }
  switch (foam_case.scene.foam.turbulence) {
    case FoamTurbulence::smagorinsky:
      files["0.orig/nut"] =
          field_file(foam_case, "volScalarField", "nut", "Eddy viscosity [m^2/s].", "[0 2 -1 0 0 0 0]", "0",
                     boundary(foam_case, zero_gradient, "type zeroGradient;", zero_gradient));
      break;
    case FoamTurbulence::laminar:
    case FoamTurbulence::k_omega:
      break;
  }
  // Air that a current carries along slips past the open top; no-slip there would stir it, and the water through it.
  const std::string at_open =
      has_current(foam_case.scene) ? "pressureInletOutletParSlipVelocity" : "pressureInletOutletVelocity";
  files["0.orig/U"] = field_file(
      foam_case, "volVectorField", "U", "Velocity [m/s]: at rest; no slip at walls.", "[0 1 -1 0 0 0 0]", "(0 0 0)",
      boundary(foam_case, everywhere("type noSlip;"), "type " + at_open + "; value uniform (0 0 0);",
               [&](const OpeningPatch& patch) { return velocity_at(foam_case, patch); }));
  // The atmosphere's p = 0 is a condition on p, not on p_rgh, since p_rgh differs with depth at open sides.
  files["0.orig/p_rgh"] =
      field_file(foam_case, "volScalarField", "p_rgh", "Pressure without its hydrostatic part, p - rho g.x [Pa].",
                 "[1 -1 -2 0 0 0 0]", "0",
                 boundary(foam_case, everywhere("type fixedFluxPressure; value uniform 0;"),
                          "type prghTotalPressure; p0 uniform 0; value uniform 0;",
                          [&](const OpeningPatch& patch) { return pressure_at(foam_case, patch); }));
  return files;
}

}  // namespace thalweg::foam
