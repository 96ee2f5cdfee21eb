#pragma once

#include <string>
#include <vector>

#include "common/run_folder.hpp"
#include "foam_reference/foam_model.hpp"

namespace thalweg::foam {

/// What to run besides what the case says.
struct ModelOptions {
  std::string model;  // one model only; empty: models_of(scene)
  int meshes = 0;     // 0: foam.meshes
  int ranks = 1;
};

/// Folder of a model's results inside RunFolder::foam(): "same-material", on twice as coarse a mesh "same-material-2x".
std::string folder_of(FoamModel model, int coarsening);

/// Runs the mesh models of a case on their meshes, each in its folder (foam_reference/reference_run.hpp). Where
/// libthalwegFoam cannot be had the stock model takes the place of those that need it, and a line says so. Meshes that
/// are too coarse for the container are left out with a line; the first one is not.
/// Throws InputError, RunError, Interrupted.
void run_models(const Case& scene, const RunFolder& run, const ModelOptions& options);

}  // namespace thalweg::foam
