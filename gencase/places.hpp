#pragma once

#include <string>

#include "case/case.hpp"

namespace thalweg::gencase {

/// A length or coordinate [m] with its unit, told to a hundredth of the spacing: "13.5 cm", "659800.25 m".
std::string placed_text(double metres, double spacing);

/// A place of a scene so told: "x = 13.5 cm, z = 4 mm", in 3-D with y.
std::string placed_text(const Case& scene, const Vec3& place);

/// A length [m] with its unit: "13.5 cm".
std::string length_text(double metres);

/// A length or coordinate as a plain number of metres, for lists.
std::string placed_number(double metres, double spacing);

}  // namespace thalweg::gencase
