#include "foam_reference/all_models.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "common/console.hpp"
#include "common/error.hpp"
#include "common/warnings.hpp"
#include "foam_reference/foam_library.hpp"
#include "foam_reference/foam_run.hpp"
#include "foam_reference/reference_run.hpp"

namespace thalweg::foam {
namespace {

struct Planned {
  FoamModel model;
  int coarsening;  // of the cells
  FoamCase foam_case;
};

std::vector<FoamModel> chosen_models(const Case& scene, const ModelOptions& options) {
  if (options.model.empty()) return models_of(scene);
  const FoamModel model = model_of(options.model);
  if (!scene.has_sediment() && model != FoamModel::stock) {
    throw InputError(fmt::format("{}: a scene without sediment has no model \"{}\"; use --model stock",
                                 scene.file.string(), options.model));
  }
  return {model};
}

// The folder of the library; empty if no model needs it.
std::filesystem::path find_library(const Case& scene, const std::vector<FoamModel>& models) {
  const auto needs = [&](FoamModel model) { return needs_library(scene, model); };
  const auto first = std::ranges::find_if(models, needs);
  if (first == models.end()) return {};
  if (const auto library = foam_library()) return *library;
  throw RunError(fmt::format(
      "foam: the model \"{}\" needs libthalwegFoam, which cannot be had for the reason above; mend that, or "
      "ask for OpenFOAM's own HerschelBulkley, whose yield stress knows no pressure: --set "
      "foam.models='[\"stock\"]'",
      name_of(*first)));
}

std::vector<Planned> plan(const Case& scene, const std::vector<FoamModel>& models, const ModelOptions& options,
                          const std::filesystem::path& library, const Warn& warn) {
  const int meshes = options.meshes > 0 ? options.meshes : scene.foam.meshes;
  std::vector<Planned> planned;
  for (const FoamModel model : models) {
    for (int mesh = 0; mesh < meshes; ++mesh) {
      const int coarsening = 1 << mesh;
      Case coarser = scene;
      coarser.foam.cell = cell_size(scene) * coarsening;
      try {
        planned.push_back({model, coarsening,
                           make_foam_case(coarser, options.ranks, model,
                                          needs_library(scene, model) ? library : std::filesystem::path())});
      } catch (const InputError& error) {
        if (mesh == 0) throw;
        warn(fmt::format("no mesh {} times as coarse ({})", coarsening, error.what()));
        break;
      }
    }
  }
  return planned;
}

}  // namespace

std::string folder_of(FoamModel model, int coarsening) {
  return coarsening == 1 ? name_of(model) : fmt::format("{}-{}x", name_of(model), coarsening);
}

void run_models(const Case& scene, const RunFolder& run, const ModelOptions& options) {
  const std::vector<FoamModel> models = chosen_models(scene, options);
  const auto silent = [](const std::string&) {};
  for (const Planned& checked : plan(scene, models, options, {}, silent))
    (void)case_files(checked.foam_case);  // throws
  require_openfoam();
  if (options.check) return;
  keep_log(run, "foam");
  const WarningFile kept(run, "foam");
  kept.clear();
  const Warn warn = [&](const std::string& line) {
    thalweg::warn("foam: " + line);
    kept.add(line);
  };
  const std::filesystem::path library = find_library(scene, models);
  for (const Planned& one : plan(scene, models, options, library, warn)) {
    const std::filesystem::path folder = run.foam() / folder_of(one.model, one.coarsening);
    say_beside(fmt::format("foam: {}, cells of {:g} mm, {} of them", name_of(one.model), 1e3 * one.foam_case.plan.cell,
                           one.foam_case.plan.cell_count()));
    if (reference_run(one.foam_case, folder, warn) == Reference::already_there) {
      say_beside(fmt::format("foam: {} is finished and up to date", folder.string()));
    }
  }
}

}  // namespace thalweg::foam
