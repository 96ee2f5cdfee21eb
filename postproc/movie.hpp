#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "common/run_folder.hpp"

namespace thalweg {

struct Movie {
  std::size_t frames = 0;
  std::filesystem::path film;         // empty without ffmpeg
  std::vector<std::string> warnings;  // why there is no film or no frame, with the cure; damaged snapshots
};

/// Draws every snapshot of a run with VTK: movie/f00000.png …, and movie.mp4 where ffmpeg is installed. Water is
/// coloured by its speed, sediment by its state or, without states, by its speed. VTK needs a display: the one of
/// $DISPLAY or, where that cannot be reached, an Xvfb of its own. Throws InputError when the run has no snapshot,
/// RunError.
Movie make_movie(const RunFolder& run, const Case& resolved);

}  // namespace thalweg
