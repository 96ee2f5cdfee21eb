#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "foam_reference/mesh_plan.hpp"
#include "foam_reference/sediment_rheology.hpp"

namespace thalweg::foam {

/// All that decides a run of the mesh model.
struct FoamCase {
  Case scene;
  MeshPlan plan;
  SceneContents contents;
  std::optional<StockRheology> rheology;  // nothing without sediment
  int ranks = 1;
};

/// Text of every file of an OpenFOAM case, by its path in the case's folder.
using CaseFiles = std::map<std::filesystem::path, std::string>;

/// Checks what the mesh model can do and plans it. Throws InputError.
FoamCase make_foam_case(const Case& scene, int ranks);

/// The complete case for multiphaseInterFoam: dictionaries, initial fields, Allrun, Allclean, case.foam.
CaseFiles case_files(const FoamCase& foam_case);

/// Names of the phases, heaviest first: water [sediment] air.
std::vector<std::string> phases(const FoamCase& foam_case);

/// Interval [s] at which fields are written: a common divisor of output.end and compare.times, and of output.interval
/// where that does not make it much shorter. Throws InputError when the times share none above a 500th of the run.
double write_interval(const Case& scene);

/// The parts of case_files, one subject each.
CaseFiles mesh_files(const FoamCase& foam_case);
CaseFiles initial_fields(const FoamCase& foam_case);
CaseFiles model_files(const FoamCase& foam_case);
CaseFiles control_files(const FoamCase& foam_case);
CaseFiles scripts(const FoamCase& foam_case);

}  // namespace thalweg::foam
