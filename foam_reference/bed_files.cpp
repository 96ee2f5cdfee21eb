// The eroding bed's parts of a case: constant/fvOptions, and the entry of system/controlDict that moves it.
#include "foam_reference/bed_files.hpp"

#include <fmt/format.h>

#include "foam_reference/case_files.hpp"
#include "foam_reference/current.hpp"
#include "foam_reference/dictionary.hpp"
#include "foam_reference/library/dictionary_words.hpp"
#include "foam_reference/openings.hpp"
#include "physics/transport/critical_shields.hpp"

namespace thalweg::foam {

namespace {

/// The columns beside inlets that bring bed load keep their level: the entry `fed`, boxes one cell deep. They are the
/// equilibrium, whatever the inlet asks for.
std::string fed_entry(const FoamCase& foam_case) {
  std::string boxes;
  for (const OpeningPatch& patch : opening_patches(foam_case.scene)) {
    if (patch.inlet == nullptr || patch.inlet->bed_load == InletBedLoad::none) continue;
    Bounds box = bounds_of(patch, foam_case.plan, foam_case.scene.info.dimension);
    const int axis = static_cast<int>(patch.face / 2);
    (patch.face % 2 == 0 ? box.high : box.low)[axis] += (patch.face % 2 == 0 ? 1 : -1) * foam_case.plan.cell;
    boxes += fmt::format(" (({} {} 0) ({} {} 0))", number(box.low.x()), number(box.low.y()), number(box.high.x()),
                         number(box.high.y()));
  }
  return boxes.empty() ? "" : "        fed             (" + boxes + " );  // columns that keep their level\n";
}

}  // namespace

std::string eroding_bed_function(const FoamCase& foam_case) {
  const Case& scene = foam_case.scene;
  const SedimentParameters& s = scene.sediment();
  return substitute(R"(    %name%  // moves the bed after each step; SI
    {
        type            erodingBed;
        libs            ("libthalwegFoam.so");
        waterPhase      water;
        grainDensity    %grain_density%;
        porosity        %porosity%;
        grainDiameter   %diameter%;
        frictionAngle   %friction_angle%;  // also the angle of repose
        liftRatio       %lift_ratio%;
        roughness       %roughness%;  // ks
        criticalShields %critical%;  // 0: by the grain Reynolds number
        bedLoad         %bed_load%;
        slopeEffect     %slope_effect%;
        pickUp          %pick_up%;
        drag            %drag%;  // [1/s] on water in the bed
%fed%        columns
        {
%columns%        }
        writeControl    writeTime;
    }
)",
                    {{"name", eroding_bed_name},
                     {"grain_density", number(s.grain_density)},
                     {"porosity", number(s.porosity)},
                     {"diameter", number(s.grain_diameter)},
                     {"friction_angle", number(s.friction_angle)},
                     {"lift_ratio", number(s.lift_ratio)},
                     {"roughness", number(s.roughness > 0 ? s.roughness : s.grain_diameter)},
                     {"critical", number(critical_shields_of(s, scene.water.density, scene.domain.gravity.norm()))},
                     {"bed_load", dictionary_word(scene.foam.bed_load)},
                     {"slope_effect", dictionary_word(scene.model.slope_effect)},
                     {"pick_up", dictionary_word(scene.foam.pick_up)},
                     {"drag", number(bed_drag)},
                     {"fed", fed_entry(foam_case)},
                     {"columns", columns_entries(foam_case.plan, "            ")}});
}

CaseFiles option_files(const FoamCase& foam_case) {
  const Case& scene = foam_case.scene;
  std::string purpose;
  std::string entries;
  if (foam_case.has_eroding_bed()) {
    purpose +=
        "The bed holds the water in it still and brakes what runs over it (field bedDrag); grains in suspension\nadd "
        "their weight. Both fields come from the eroding bed in system/controlDict.\n";
    entries += substitute(
        R"(immersedBed
{
    type            immersedBed;
    libs            ("libthalwegFoam.so");
    waterPhase      water;
    grainDensity    %grain_density%;
    waterDensity    %water_density%;
%eddies%}
)",
        {{"grain_density", number(scene.sediment().grain_density)},
         {"water_density", number(scene.water.density)},
         {"eddies",
          foam_case.has_wall_functions() ? "    eddies          yes;  // k and omega of the law of the wall\n" : ""}});
  }
  if (scene.flow.drive != Drive::off) {
    purpose += "The drive accelerates the water along the flow, and is no part of gravity.\n";
    entries += drive_entries(foam_case);
  }
  if (entries.empty()) return {};
  return {{"constant/fvOptions", foam_file(scene, "dictionary", "fvOptions", purpose, entries)}};
}

}  // namespace thalweg::foam
