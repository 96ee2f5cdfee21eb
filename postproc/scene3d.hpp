#pragma once

#include <string>

#include "postproc/report.hpp"

namespace thalweg {

/// The run in space, for the page: bed and free surface of every time in surfaces/, and the bodies that stand in the
/// flow. Arrays are base64 of little-endian numbers, what view/scene/scene.js reads.
struct SpaceScene {
  std::string data;     // JSON; empty: there is nothing to show
  std::string why_not;  // in that case: one line with the cure
  std::size_t frames = 0;
  double largest = 0;              // [m] change of the bed's level that ends the colours
  std::size_t most_triangles = 0;  // of one surface as shown
  bool thinned = false;            // surfaces were decimated to that many
};

/// Reads the surfaces that postproc has written before. Says why not: a run in the plane, no surfaces, or a program
/// built without vtk.js. Throws InputError for a surface that cannot be read.
SpaceScene make_space_scene(const ReportInput& input);

}  // namespace thalweg
