// system/controlDict, fvSchemes, fvSolution: times, steps, schemes, solvers.
#include <cmath>

#include "foam_reference/bed_files.hpp"
#include "foam_reference/case_files.hpp"
#include "foam_reference/dictionary.hpp"

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

std::string volume_functions(const FoamCase& foam_case) {
  std::string fields;
  std::string outflows;
  for (const std::string& phase : phases(foam_case)) {
    fields += " alpha." + phase;
    if (!foam_case.plan.open(Face::open) || phase == "air") continue;
    outflows += substitute(R"(
    outflow_%phase%  // [m^3/s] through the open faces
    {
        type            surfaceFieldValue;
        libs            ("libfieldFunctionObjects.so");
        regionType      patch;
        name            atmosphere;
        operation       weightedSum;
        weightField     alpha.%phase%;
        fields          (phi);
        writeFields     no;
        writeControl    timeStep;
        writeInterval   1;
        log             no;
    }
)",
                           {{"phase", phase}});
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
                     {"functions", volume_functions(foam_case)}});
}

constexpr const char* schemes = R"(ddtSchemes      { default Euler; }
gradSchemes     { default Gauss linear; }
divSchemes
{
    default             none;
    div(rhoPhi,U)       Gauss linearUpwind grad(U);
    div(phi,alpha)      Gauss vanLeer;
    div(phirb,alpha)    Gauss linear;
    div(((rho*nuEff)*dev2(T(grad(U))))) Gauss linear;
}
laplacianSchemes        { default Gauss linear corrected; }
interpolationSchemes    { default linear; }
snGradSchemes           { default corrected; }
)";

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
    "U.*"
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
                    {{"alpha", alpha}, {"corrections", plan.has_surfaces ? "1" : "0"}, {"reference", reference}});
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
  add("fvSchemes", "First order in time, second in space, phases kept sharp by limited compression.", schemes);
  add("fvSolution",
      "The momentum predictor carries the bed's large viscosity implicitly. One outer corrector: more of them "
      "together\n"
      "with sub-cycles of alpha lose sediment (6.7 % in 1 s of a dam break with OpenFOAM 1912).",
      solution(foam_case));
  return files;
}

}  // namespace thalweg::foam
