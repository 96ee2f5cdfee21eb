#pragma once

#include <filesystem>
#include <vector>

#include "common/run_folder.hpp"
#include "postproc/figures/figure_writer.hpp"
#include "postproc/method_cost.hpp"

namespace thalweg {

/// True if a mesh model ran on a coarser mesh too: the two have a band between them.
bool has_band(const Method& method);

/// Writes the gnuplot scripts of the report's part on methods and their data: bands between fine and coarse meshes, and
/// speed against error. Returns the scripts; throws RunError.
std::vector<std::filesystem::path> method_scripts(const std::vector<Method>& methods, const ProfileSet& particles,
                                                  const PictureFrame& frame, const RunFolder& run,
                                                  const PageUnit& height);

}  // namespace thalweg
