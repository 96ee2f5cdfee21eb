// system/controlDict, fvSchemes, fvSolution: times, steps, schemes, solvers.
#include <cmath>

#include "foam_reference/bed_files.hpp"
#include "foam_reference/case_files.hpp"
#include "foam_reference/dictionary.hpp"
#include "foam_reference/gauges.hpp"
#include "foam_reference/open_patches.hpp"
#include "foam_reference/openings.hpp"

namespace thalweg::foam {
namespace {

// The step [s] in which a surface wave crosses 0.4 of a cell. A wave is at most sqrt(g H) fast, H height of the block.
// The Courant limits do not see it while the water is at rest. With a whole cell in a step, water at rest over a bed
// begins to slosh (bed +-1.5 mm after 1 s at 10 mm cells); with up to half a cell it stays at rest.
double largest_step(const FoamCase& foam_case) {
  const MeshPlan& plan = foam_case.plan;
  const double height = plan.high.z() - plan.low.z();
  return 0.4 * plan.size().x() / std::sqrt(foam_case.scene.domain.gravity.norm() * height);
}

// A number that is written at every step: what an operation makes of a field on a patch.
std::string patch_function(const std::string& name, const std::string& comment, const std::string& patch,
                           const std::string& operation, const std::string& field) {
  return substitute(
      R"(
    %name%  // %comment%
    {
        type            surfaceFieldValue;
        libs            ("libfieldFunctionObjects.so");
        regionType      patch;
        name            %patch%;
        operation       %operation%;
        fields          (%field%);
        writeFields     no;
        writeControl    timeStep;
        writeInterval   1;
        log             no;
    }
)",
      {{"name", name}, {"comment", comment}, {"patch", patch}, {"operation", operation}, {"field", field}});
}

std::string outflow_function(const FoamCase& foam_case, const std::string& phase, const std::string& patch) {
  // interFoam keeps the flux of water with which it moved the water.
  const bool exact = foam_case.application() == "interFoam";
  return patch_function(outflow_of(phase, patch), "[m^3/s] of " + phase + " out of the scene", patch,
                        exact ? "sum" : "weightedSum;\n        weightField     alpha." + phase,
                        exact ? "alphaPhi0." + phase : "phi");
}

std::string volume_functions(const FoamCase& foam_case) {
  std::string fields;
  std::string outflows;
  for (const std::string& phase : phases(foam_case)) {
    fields += " alpha." + phase;
    if (phase == "air") continue;
    for (const std::string& patch : open_patches(foam_case)) outflows += outflow_function(foam_case, phase, patch);
  }
  for (const OpeningPatch& patch : opening_patches(foam_case.scene)) {
    outflows += patch_function(wet_area_of(patch.patch), "[m^2] wetted", patch.patch, "areaIntegrate", "alpha.water");
  }
  return substitute(R"(    volumes  // [m^3] of each phase
    {
        type            volFieldValue;
        libs            ("libfieldFunctionObjects.so");
        regionType      all;
        operation       volIntegrate;
        fields          (%fields% );
        writeFields     no;
        writeControl    timeStep;
        writeInterval   1;
        log             no;
    }
)",
                    {{"fields", fields}}) +
         outflows + (foam_case.has_eroding_bed() ? eroding_bed_function(foam_case) : "");
}

std::string control(const FoamCase& foam_case) {
  const double step = largest_step(foam_case);
  return substitute(R"(application     %application%;
%libraries%
startFrom       startTime;
startTime       0;
stopAt          endTime;
endTime         %end%;

deltaT          %first_step%;
adjustTimeStep  yes;
maxCo           0.5;
maxAlphaCo      0.5;
maxDeltaT       %largest_step%;

writeControl    adjustableRunTime;
writeInterval   %interval%;
purgeWrite      0;
writeFormat     binary;
writePrecision  12;
writeCompression off;
timeFormat      general;
timePrecision   8;
runTimeModifiable yes;

functions
{
%functions%}
)",
                    {{"application", foam_case.application()},
                     {"libraries", foam_case.library.empty() ? "" : "libs            (\"libthalwegFoam.so\");\n"},
                     {"end", number(foam_case.scene.output.end)},
                     {"first_step", number(step / 20)},
                     {"largest_step", number(step)},
                     {"interval", number(write_interval(foam_case.scene))},
                     {"functions", volume_functions(foam_case) + gauge_functions(foam_case)}});
}

std::string schemes(const FoamCase& foam_case) {
  return substitute(
      R"(ddtSchemes      { default Euler; }
gradSchemes     { default Gauss linear; }
divSchemes
{
    default             none;
    div(rhoPhi,U)       Gauss linearUpwind grad(U);
    div(phi,alpha)      Gauss vanLeer;
    div(phirb,alpha)    Gauss linear;
    div(((rho*nuEff)*dev2(T(grad(U))))) Gauss linear;
%eddies%}
laplacianSchemes        { default Gauss linear corrected; }
interpolationSchemes    { default linear; }
snGradSchemes           { default corrected; }
%distance%)",
      {{"eddies", foam_case.has_wall_functions()
                      ? "    div(phi,k)          Gauss upwind;\n    div(phi,omega)      Gauss upwind;\n"
                      : ""},
       {"distance", foam_case.has_wall_functions() ? "wallDist                { method meshWave; }\n" : ""}});
}

// system/fvSolution. Where no face is open the pressure needs a point of a fixed value.
std::string solution(const FoamCase& foam_case) {
  const MeshPlan& plan = foam_case.plan;
  const std::string reference = plan.open(Face::open) ? ""
                                                      : "    pRefPoint       " + vector(plan.high - 0.5 * plan.size()) +
                                                            ";\n    pRefValue       0;\n";
  // Grains are carried by the water's flux of a whole step, which interFoam keeps only without sub-cycles.
  const std::string alpha = foam_case.application() == "interFoam"
                                ? "        nAlphaCorr      2;\n        nAlphaSubCycles 1;\n"
                                : "        nAlphaSubCycles 2;\n";
  return substitute(R"(solvers
{
    "alpha.*"
    {
%alpha%        cAlpha          1;
    }
    "pcorr.*"
    {
        solver          PCG;
        preconditioner  DIC;
        tolerance       1e-6;
        relTol          0;
    }
    p_rgh
    {
        solver          PCG;
        preconditioner  DIC;
        tolerance       1e-7;
        relTol          0.05;
    }
    p_rghFinal
    {
        $p_rgh;
        relTol          0;
    }
    "%transported%.*"
    {
        solver          PBiCGStab;
        preconditioner  DILU;
        tolerance       1e-8;
        relTol          0;
    }
}

PIMPLE
{
    momentumPredictor   yes;
    nOuterCorrectors    1;
    nCorrectors         3;
    nNonOrthogonalCorrectors %corrections%;
%reference%}
)",
                    {{"alpha", alpha},
                     {"transported", foam_case.has_wall_functions() ? "(U|k|omega)" : "U"},
                     {"corrections", plan.has_surfaces ? "1" : "0"},
                     {"reference", reference}});
}

}  // namespace

CaseFiles control_files(const FoamCase& foam_case) {
  CaseFiles files;
  const auto add = [&](const std::string& name, const std::string& purpose, const std::string& body) {
    files["system/" + name] = foam_file(foam_case.scene, "dictionary", name, purpose, body);
  };
  add("controlDict",
      "Times in s. Steps follow the Courant limits; maxDeltaT lets a surface wave cross 0.4 of a cell.\n"
      "Fields are written at a common divisor of the times to compare, the snapshots' interval and the end.",
      control(foam_case));
  add("fvSchemes", "First order in time, second in space, phases kept sharp by limited compression.",
      schemes(foam_case));
  add("fvSolution",
      "The momentum predictor carries the bed's large viscosity implicitly. One outer corrector: more of them "
      "together\n"
      "with sub-cycles of alpha lose sediment (6.7 % in 1 s of a dam break with OpenFOAM 1912).",
      solution(foam_case));
  return files;
}

}  // namespace thalweg::foam
