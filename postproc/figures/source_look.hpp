#pragma once

#include <array>
#include <string>
#include <vector>

#include "postproc/profile_set.hpp"

namespace thalweg {

/// Okabe & Ito (2008): distinguishable with any common colour-vision deficiency. In the order of `curves`.
inline constexpr std::array<const char*, 3> curve_colours{"#0072b2", "#d55e00", "#1a1a1a"};

/// The colour of a source in a key and in pictures with one curve: sources differ by dashes and markers.
inline constexpr const char* source_colour = "#444444";

/// The dashes of a source's line, as "10,5": the run's line is whole (empty), meshes' are dashed, the second one's
/// dotted, other sources' dash-dotted. Measurements are markers (empty).
std::string dashes_of_source(const std::vector<ProfileSet>& sets, std::size_t s);

/// gnuplot's style for a source: "with points …" for measurements, otherwise "with lines …" with its dashes.
std::string source_style(const std::vector<ProfileSet>& sets, std::size_t s);

/// A folder name made of a label: "OpenFOAM 10 mm" → "openfoam_10_mm".
std::string folder_name_of(const std::string& label);

}  // namespace thalweg
