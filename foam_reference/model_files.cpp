// constant/: gravity, phases, turbulence.
#include <fmt/format.h>

#include "foam_reference/case_files.hpp"
#include "foam_reference/dictionary.hpp"
#include "foam_reference/library/dictionary_words.hpp"
#include "physics/sediment/material.hpp"

namespace thalweg::foam {
namespace {

constexpr double air_kinematic_viscosity = 1.5e-5;  // [m^2/s] dry air at 20 degrees C at sea level

std::string newtonian(const std::string& phase, double kinematic_viscosity, double density) {
  return substitute(R"(    %phase%
    {
        transportModel  Newtonian;
        nu              %nu%;
        rho             %rho%;
    }
)",
                    {{"phase", phase}, {"nu", number(kinematic_viscosity)}, {"rho", number(density)}});
}

std::string herschel_bulkley(const StockRheology& r) {
  return substitute(R"(    sediment
    {
        transportModel  HerschelBulkley;
        HerschelBulkleyCoeffs
        {
            tau0        %tau0%;
            k           %k%;
            n           %n%;
            nu0         %nu0%;
        }
        rho             %rho%;
    }
)",
                    {{"tau0", number(r.yield_stress / r.density)},
                     {"k", number(r.consistency / r.density)},
                     {"n", number(r.flow_index)},
                     {"nu0", number(r.viscosity_cap / r.density)},
                     {"rho", number(r.density)}});
}

// The particle model's own laws, compiled into libthalwegFoam.
std::string thalweg_sediment(const FoamCase& foam_case) {
  const Case& scene = foam_case.scene;
  const SedimentParameters& s = scene.sediment();
  return substitute(R"(    sediment
    {
        transportModel  thalwegSediment;
        thalwegSedimentCoeffs
        {
            density             %density%;
            porosity            %porosity%;
            grainDensity        %grain_density%;
            poreDensity         %pore_density%;
            grainDiameter       %diameter%;
            frictionAngle       %friction_angle%;
            cohesion            %cohesion%;
            yieldCriterion      %criterion%;
            yieldFit            %fit%;
            effectivePressure   %closure%;
            asPrinted           %as_printed%;
            rheology            %rheology%;
            consistency         %consistency%;
            flowIndex           %flow_index%;
            regularisation      %regularisation%;
            dynamicFrictionAngle %dynamic_angle%;
            inertialNumber      %inertial_number%;
            gravity             %gravity%;
            leastViscosity      %least%;
            columns
            {
%columns%            }
        }
        rho             %density%;
    }
)",
                    {{"density", number(s.bed_density())},
                     {"porosity", number(s.porosity)},
                     {"grain_density", number(s.grain_density)},
                     {"pore_density", number(s.pore_density)},
                     {"diameter", number(s.grain_diameter)},
                     {"friction_angle", number(s.friction_angle)},
                     {"cohesion", number(s.cohesion)},
                     {"criterion", dictionary_word(scene.model.yield)},
                     {"fit", dictionary_word(plane_strain_fit(scene.model.yield, scene.model.yield_fit))},
                     {"closure", dictionary_word(scene.model.effective_pressure)},
                     {"as_printed", scene.model.implementation == Implementation::paper ? "true" : "false"},
                     {"rheology", dictionary_word(scene.model.rheology)},
                     {"consistency", number(s.consistency)},
                     {"flow_index", number(s.flow_index)},
                     {"regularisation", number(s.regularisation)},
                     {"dynamic_angle", number(s.dynamic_friction_angle)},
                     {"inertial_number", number(s.inertial_number)},
                     {"gravity", number(-scene.domain.gravity.z())},
                     {"least", number(scene.water.viscosity)},
                     {"columns", columns_entries(foam_case.plan, "                ")}});
}

std::string sediment_phase(const FoamCase& foam_case) {
  if (!foam_case.has_sediment_phase()) return "";
  return foam_case.rheology ? herschel_bulkley(*foam_case.rheology) : thalweg_sediment(foam_case);
}

std::string purpose(const FoamCase& foam_case) {
  std::string text =
      "Phases that share the cells. No surface tension: the particle model has none, and cells are far larger than\n"
      "a capillary rise.\n";
  if (foam_case.has_eroding_bed()) {
    return text +
           "\nThe bed is no phase: system/controlDict holds its laws, constant/fvOptions its forces on the water."
           "\nIts pores are full of water, so that the share of water does not change where it erodes.\n";
  }
  if (foam_case.has_sediment_phase() && !foam_case.rheology) {
    return text +
           "\nSediment: the particle model's own laws (folder physics), compiled into libthalwegFoam. SI, "
           "dynamic viscosities;\n`columns` is the block of cells that the effective pressure is summed up in.\n";
  }
  if (!foam_case.rheology) return text;
  const StockRheology& r = *foam_case.rheology;
  return text +
         fmt::format(
             "\nSediment: eta = min(nu0, tau0/gdot + k gdot^(n-1)), all divided by the bed's density of {:.6g} "
             "kg/m^3.\n"
             "The stock model's yield stress is one number. tau0 = {:.4g} Pa is the particle model's\n"
             "K p_eff + c_0 at the middle of the bed as it lies at the start: K = {:.4g}, p_eff = {:.4g} Pa "
             "(submerged\n"
             "weight of half the mean thickness {:.4g} m). Above the middle the bed is too strong, below too weak.\n"
             "nu0 is the particle model's viscosity at rest, tau0 m/2 + k = {:.4g} Pa s.\n",
             r.density, r.yield_stress, r.yield_coefficient, r.effective_pressure, foam_case.contents.bed_thickness,
             r.viscosity_cap);
}

std::string surface_tensions(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (std::size_t j = i + 1; j < names.size(); ++j) text += "    (" + names[i] + " " + names[j] + ") 0\n";
  }
  return text;
}

std::string transport(const FoamCase& foam_case) {
  const WaterParameters& water = foam_case.scene.water;
  if (foam_case.application() == "interFoam") {
    return "phases (water air);\n\n" + newtonian("water", water.viscosity / water.density, water.density) + "\n" +
           newtonian("air", air_kinematic_viscosity, air_density) + "\nsigma 0;\n";
  }
  return substitute("phases\n(\n%phases%);\n\nsigmas\n(\n%sigmas%);\n",
                    {{"phases", newtonian("water", water.viscosity / water.density, water.density) +
                                    sediment_phase(foam_case) + newtonian("air", air_kinematic_viscosity, air_density)},
                     {"sigmas", surface_tensions(phases(foam_case))}});
}

constexpr const char* large_eddies = R"(simulationType LES;

LES
{
    LESModel        Smagorinsky;
    turbulence      on;
    printCoeffs     on;
    delta           cubeRootVol;
    cubeRootVolCoeffs { deltaCoeff 1; }
}
)";

// b1 = 0 is Menter's baseline model. The limiter of its successor, SST, takes the shear between a wall and the first
// centre for that of the water, although the wall function replaces it, and holds the eddy viscosity there to a third.
constexpr const char* k_omega = R"(simulationType RAS;

RAS
{
    RASModel        kOmegaSST;
    turbulence      on;
    printCoeffs     on;
    kOmegaSSTCoeffs { b1 0; }
}
)";

std::string turbulence_properties(const Case& scene) {
  std::string purpose;
  std::string body;
  switch (scene.foam.turbulence) {
    case FoamTurbulence::laminar:
      purpose = "No turbulence model, as in the particle model.";
      body = "simulationType laminar;\n";
      break;
    case FoamTurbulence::smagorinsky:
      purpose = "Large eddies, in all phases alike: Smagorinsky's model does not tell them apart.";
      body = large_eddies;
      break;
    case FoamTurbulence::k_omega:
      purpose =
          "Mean flow of a current: Menter's k-omega model without the limiter of SST (b1 0), which does not fit wall\n"
          "functions.";
      body = k_omega;
      break;
  }
  return foam_file(scene, "dictionary", "turbulenceProperties", purpose, body);
}

}  // namespace

CaseFiles model_files(const FoamCase& foam_case) {
  const Case& scene = foam_case.scene;
  CaseFiles files;
  files["constant/transportProperties"] =
      foam_file(scene, "dictionary", "transportProperties", purpose(foam_case), transport(foam_case));
  files["constant/turbulenceProperties"] = turbulence_properties(scene);
  files["constant/g"] = foam_file(scene, "uniformDimensionedVectorField", "g", "Gravity [m/s^2].",
                                  "dimensions [0 1 -2 0 0 0 0];\nvalue " + vector(scene.domain.gravity) + ";\n");
  return files;
}

}  // namespace thalweg::foam
