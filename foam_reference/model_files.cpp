// constant/: gravity, phases, turbulence.
#include <fmt/format.h>

#include "foam_reference/case_files.hpp"
#include "foam_reference/dictionary.hpp"

namespace thalweg::foam {
namespace {

// Air at 20 degrees C (dry, sea level).
constexpr double air_density = 1.2;                 // [kg/m^3]
constexpr double air_kinematic_viscosity = 1.5e-5;  // [m^2/s]

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

std::string purpose(const FoamCase& foam_case) {
  std::string text =
      "Phases that share the cells. No surface tension: the particle model has none, and cells are far larger than\n"
      "a capillary rise.\n";
  if (!foam_case.rheology) return text;
  const StockRheology& r = *foam_case.rheology;
  return text +
         fmt::format(
             "\nSediment: eta = min(nu0, tau0/gdot + k gdot^(n-1)), all divided by the bed's density of {:.6g} "
             "kg/m^3.\n"
             "The stock model's yield stress does not know the pressure. tau0 = {:.4g} Pa is the particle model's\n"
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
  return substitute("phases\n(\n%phases%);\n\nsigmas\n(\n%sigmas%);\n",
                    {{"phases", newtonian("water", water.viscosity / water.density, water.density) +
                                    (foam_case.rheology ? herschel_bulkley(*foam_case.rheology) : "") +
                                    newtonian("air", air_kinematic_viscosity, air_density)},
                     {"sigmas", surface_tensions(phases(foam_case))}});
}

}  // namespace

CaseFiles model_files(const FoamCase& foam_case) {
  const Case& scene = foam_case.scene;
  CaseFiles files;
  files["constant/transportProperties"] =
      foam_file(scene, "dictionary", "transportProperties", purpose(foam_case), transport(foam_case));
  files["constant/turbulenceProperties"] =
      foam_file(scene, "dictionary", "turbulenceProperties", "No turbulence model, as in the particle model.",
                "simulationType laminar;\n");
  files["constant/g"] = foam_file(scene, "uniformDimensionedVectorField", "g", "Gravity [m/s^2].",
                                  "dimensions [0 1 -2 0 0 0 0];\nvalue " + vector(scene.domain.gravity) + ";\n");
  return files;
}

}  // namespace thalweg::foam
