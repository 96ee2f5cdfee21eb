#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "foam_reference/foam_model.hpp"
#include "foam_reference/mesh_plan.hpp"
#include "foam_reference/sediment_rheology.hpp"

namespace thalweg::foam {

/// Density of the air [kg/m^3]: dry, at 20 degrees C and sea level.
inline constexpr double air_density = 1.2;

/// Everything that a run of the mesh model depends on.
struct FoamCase {
  Case scene;
  FoamModel model = FoamModel::stock;
  std::filesystem::path library;  // folder of libthalwegFoam.so; empty where the model needs none
  MeshPlan plan;
  SceneContents contents;
  std::optional<StockRheology> rheology;  // of the stock model with sediment
  int ranks = 1;

  [[nodiscard]] bool has_sediment_phase() const { return scene.has_sediment() && model != FoamModel::eroding_bed; }
  [[nodiscard]] bool has_eroding_bed() const { return scene.has_sediment() && model == FoamModel::eroding_bed; }
  /// True if walls have the law of the wall, with k and omega beside them.
  [[nodiscard]] bool has_wall_functions() const { return scene.foam.turbulence == FoamTurbulence::k_omega; }
  [[nodiscard]] std::string application() const { return application_of(scene, model); }
};

/// Text of every file of an OpenFOAM case, by its path in the case's folder.
using CaseFiles = std::map<std::filesystem::path, std::string>;

/// Plans the run. Throws InputError for a scene that the mesh model cannot compute.
FoamCase make_foam_case(const Case& scene, int ranks, FoamModel model = FoamModel::stock,
                        const std::filesystem::path& library = {});

/// The complete case: dictionaries, initial fields, Allrun, Allclean, case.foam.
CaseFiles case_files(const FoamCase& foam_case);

/// Names of the phases, heaviest first: water [sediment] air.
std::vector<std::string> phases(const FoamCase& foam_case);

/// Interval [s] at which fields are written: a common divisor of output.end and compare.times, and of output.interval
/// too unless that makes it much shorter. Throws InputError if the times have no common divisor above a 500th of the
/// run.
double write_interval(const Case& scene);

/// Entries of the dictionary that tell libthalwegFoam the columns of the block. Each line begins with `indent`.
std::string columns_entries(const MeshPlan& plan, const std::string& indent);

// The parts of case_files, one subject each.
CaseFiles mesh_files(const FoamCase& foam_case);
CaseFiles initial_fields(const FoamCase& foam_case);
CaseFiles model_files(const FoamCase& foam_case);
CaseFiles option_files(const FoamCase& foam_case);  // of the eroding bed and the drive
CaseFiles control_files(const FoamCase& foam_case);
CaseFiles scripts(const FoamCase& foam_case);

}  // namespace thalweg::foam
