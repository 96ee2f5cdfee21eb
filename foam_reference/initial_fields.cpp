// 0.orig: the fields before setFields fills the shapes, and their conditions at walls and open faces.
#include "foam_reference/case_files.hpp"
#include "foam_reference/dictionary.hpp"

namespace thalweg::foam {
namespace {

std::string boundary_entry(const std::string& patch, const std::string& entries) {
  return "    " + patch + " { " + entries + " }\n";
}

// Entries for walls and open faces. Those for empty and cyclic patches follow from the mesh.
std::string boundary(const MeshPlan& plan, const std::string& at_walls, const std::string& at_open) {
  std::string text;
  if (plan.open(Face::wall)) text += boundary_entry("walls", at_walls);
  if (plan.has_solids) text += boundary_entry("solids", at_walls);
  if (plan.has_surfaces) text += boundary_entry("\"surface[0-9]+\"", at_walls);
  if (plan.open(Face::open)) text += boundary_entry("atmosphere", at_open);
  if (plan.open(Face::unused)) text += boundary_entry("frontAndBack", "type empty;");
  if (plan.open(Face::periodic)) text += boundary_entry("\"(minus|plus)[XYZ]\"", "type cyclic;");
  return text;
}

std::string field(const FoamCase& foam_case, const std::string& foam_class, const std::string& name,
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

}  // namespace

CaseFiles initial_fields(const FoamCase& foam_case) {
  const MeshPlan& plan = foam_case.plan;
  CaseFiles files;
  for (const std::string& phase : phases(foam_case)) {
    const std::string inflow = phase == "air" ? "1" : "0";
    if (phase == "air" && foam_case.application() == "interFoam") continue;  // interFoam has one share, the water's
    files["0.orig/alpha." + phase] =
        field(foam_case, "volScalarField", "alpha." + phase,
              "Volume share of " + phase + " [-]. What flows in through open faces is air.", "[0 0 0 0 0 0 0]", inflow,
              boundary(plan, "type zeroGradient;",
                       "type inletOutlet; inletValue uniform " + inflow + "; value uniform " + inflow + ";"));
  }
  if (foam_case.has_eroding_bed()) {
    const std::string open = "type inletOutlet; inletValue uniform 0; value uniform 0;";
    files["0.orig/bed"] =
        field(foam_case, "volScalarField", "bed", "Share of the cell that lies below the bed's surface [-].",
              "[0 0 0 0 0 0 0]", "0", boundary(plan, "type zeroGradient;", "type zeroGradient;"));
    files["0.orig/grains"] = field(foam_case, "volScalarField", "grains", "Volume share of suspended grains [-].",
                                   "[0 0 0 0 0 0 0]", "0", boundary(plan, "type zeroGradient;", open));
  }
  switch (foam_case.scene.foam.turbulence) {
    case FoamTurbulence::smagorinsky:
      files["0.orig/nut"] = field(foam_case, "volScalarField", "nut", "Eddy viscosity [m^2/s].", "[0 2 -1 0 0 0 0]",
                                  "0", boundary(plan, "type zeroGradient;", "type zeroGradient;"));
      break;
    case FoamTurbulence::laminar:
      break;
  }
  files["0.orig/U"] =
      field(foam_case, "volVectorField", "U", "Velocity [m/s]: at rest; no slip at walls.", "[0 1 -1 0 0 0 0]",
            "(0 0 0)", boundary(plan, "type noSlip;", "type pressureInletOutletVelocity; value uniform (0 0 0);"));
  // The atmosphere's p = 0 is a condition on p, not on p_rgh, since p_rgh differs with depth at open sides.
  files["0.orig/p_rgh"] = field(foam_case, "volScalarField", "p_rgh",
                                "Pressure without its hydrostatic part, p - rho g.x [Pa].", "[1 -1 -2 0 0 0 0]", "0",
                                boundary(plan, "type fixedFluxPressure; value uniform 0;",
                                         "type prghTotalPressure; p0 uniform 0; value uniform 0;"));
  return files;
}

}  // namespace thalweg::foam
