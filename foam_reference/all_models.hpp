#pragma once

#include <string>
#include <vector>

#include "common/run_folder.hpp"
#include "foam_reference/foam_model.hpp"

namespace thalweg::foam {

/// Choices for a run that the case does not make.
struct ModelOptions {
  std::string model;  // one model only; empty: models_of(scene)
  int meshes = 0;     // 0: foam.meshes
  int ranks = 1;
  bool check = false;  // throw what keeps the models from running, and run none
};

/// Folder of a model's results inside RunFolder::foam(): "same-material", on twice as coarse a mesh "same-material-2x".
std::string folder_of(FoamModel model, int coarsening);

/// Runs the mesh models of a case on their meshes, each in its folder (foam_reference/reference_run.hpp). A coarser mesh
/// that does not fit the container is left out, and a line tells so; for the first mesh this is an error. A model whose
/// library cannot be had is an error too: no other takes its place. Throws InputError, RunError, Interrupted.
void run_models(const Case& scene, const RunFolder& run, const ModelOptions& options);

}  // namespace thalweg::foam
