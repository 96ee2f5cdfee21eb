#pragma once

#include <string>

namespace thalweg::gencase {

/// A length or coordinate [m] with its unit, told to a hundredth of the spacing: "13.5 cm", "659800.25 m".
std::string placed_text(double metres, double spacing);

/// The same as a plain number of metres, for lists.
std::string placed_number(double metres, double spacing);

}  // namespace thalweg::gencase
