#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/particles.hpp"

namespace thalweg::gencase {

/// Measured points.
struct SurveyFile {
  std::vector<Vec3> points;  // in the file's unit; metres in a CSV table
  std::vector<int> lines;    // of the points in the file
  bool has_y = true;
  std::vector<std::string> remarks;  // what the reader took for granted or left out, one clause each
};

/// True if a file holds points and no surface, by its extension: .csv, .xyz, .txt, .asc, .grd.
bool is_survey(const std::filesystem::path& file);

/// Reads a survey: a CSV table with the columns x, z and perhaps y in m; lines of three numbers (.xyz, .txt); an ESRI
/// ASCII grid (.asc, .grd), whose points are the middles of its cells. Throws InputError "file:line: what is wrong;
/// what to do".
SurveyFile read_survey(const std::filesystem::path& file);

/// Places that a survey measured more than once.
struct Repeated {
  std::size_t places = 0;
  double largest = 0;                 // [m] difference of two heights at one place
  std::size_t first = 0, second = 0;  // the points of that difference
};

/// Leaves one point at each place, with the mean of its heights.
Repeated merge_repeated(std::vector<Vec3>& points);

/// One point for each square of the width `square` [m] in x and y that has points: their mean. The corners of the
/// points' convex outline stay beside them, so that the survey ends where it did.
std::vector<Vec3> averaged(const std::vector<Vec3>& points, double square);

}  // namespace thalweg::gencase
