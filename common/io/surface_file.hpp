#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "common/particles.hpp"

namespace thalweg {

/// Polygons that share points, as in a mesh file.
struct PolygonSoup {
  std::vector<Vec3> points;  // in the file's unit
  std::vector<std::vector<std::size_t>> polygons;
};

/// Polylines with a number each, to be shown beside particles.
struct LineSet {
  std::string number_name;               // name of the array with the numbers
  std::vector<std::vector<Vec3>> lines;  // [m]
  std::vector<int> numbers;              // one for each line
};

/// Reads the polygons and triangle strips of a VTK XML polydata file (.vtp). Throws InputError naming the file.
PolygonSoup read_vtp_surface(const std::filesystem::path& file);

/// Writes polylines as .vtp, whole or not at all. Throws RunError.
void write_lines(const std::filesystem::path& file, const LineSet& lines);

}  // namespace thalweg
