#pragma once

#include <string>

#include "case/case.hpp"
#include "common/extraction/profile_extraction.hpp"

namespace thalweg {

/// The profile of a 3-D set along a line in plan, x counted from the line's start: extract_profile() of the particles in
/// reach of the vertical plane through the line, turned into that plane. It has the accuracy of extract_profile(), and
/// no value where the line runs through a wall.
Profile extract_along(const ParticleSet& particles, const ExtractionSettings& settings, const ProfileLine& line);

/// "along the line s1 from x = 0 m, y = 0.1 m to …", for a file's comments.
std::string description_of(const ProfileLine& line);

/// Reads an argument of --line, "NAME=X0,Y0,X1,Y1" with units ("0.1 m"). Throws InputError.
ProfileLine parse_line(const std::string& text);

}  // namespace thalweg
